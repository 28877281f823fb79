#include "geom/base/loaded_library.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string_view>

namespace geom {
namespace {

TEST(LoadedLibrary, GivesFunctionsByName) {
  const LoadedLibrary math("libm.so.6", "libc6");
  double (*const root)(double) = math.function("sqrt");
  EXPECT_EQ(root(4), 2);
}

TEST(LoadedLibrary, NamesTheLibraryAndItsPackageWhereItIsNotThere) {
  try {
    const LoadedLibrary none("libnone.so.7", "libnone7");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(std::string_view(error.what())
                    .starts_with("cannot load libnone.so.7 of the package libnone7: "))
        << error.what();
  }
}

TEST(LoadedLibrary, NamesAFunctionThatIsNotThere) {
  const LoadedLibrary math("libm.so.6", "libc6");
  try {
    math.function("no_such_function");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "libm.so.6 has no no_such_function: it is of another version");
  }
}

TEST(LoadedLibrary, GivesFunctionsOfLibrariesThatItUses) {
  const LoadedLibrary math("libm.so.6", "libc6");
  unsigned long (*const length)(const char*) = math.used_function("strlen");
  ASSERT_TRUE(length);
  EXPECT_EQ(length("four"), 4u);
  void (*const none)() = math.used_function("no_such_function");
  EXPECT_FALSE(none);
}

}  // namespace
}  // namespace geom
