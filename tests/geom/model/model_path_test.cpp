#include "model/model_path.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"

namespace geom {
namespace {

TEST(PathOfUri, IsRelativeToTheFolderOfItsFile) {
  EXPECT_EQ(path_of_uri("b.glb", "a.json", "s"), "b.glb");
  EXPECT_EQ(path_of_uri("b.glb", "x/y/a.json", "s"), "x/y/b.glb");
  EXPECT_EQ(path_of_uri("../z/./b%20c.glb?v=1#x", "x/y/a.json", "s"), "x/z/b c.glb");
}

TEST(PathOfUri, LeadsNowhereElse) {
  for (const char* uri : {"", "/a", "../a", "x/../../a", "http://h/a", "file:a", "a\\b", "%2e%2e/a",
                          "%2", "%zz", "a%00", "?x", "..", "%2"}) {
    EXPECT_THROW(path_of_uri(uri, "a.json", "s"), InputError) << uri;
  }
  EXPECT_THROW(path_of_uri("../../a", "x/a.json", "s"), InputError);
}

TEST(DataOfUri, DecodesBase64AndPercents) {
  EXPECT_TRUE(is_data_uri("data:,x"));
  EXPECT_FALSE(is_data_uri("data.bin"));
  EXPECT_EQ(data_of_uri("data:;base64,SGVsbG8=", "s"), "Hello");
  EXPECT_EQ(data_of_uri("data:;base64,SGVsbG8h", "s"), "Hello!");
  EXPECT_EQ(data_of_uri("data:text/plain,a%20b", "s"), "a b");
  for (const char* uri : {"data:", "data:;base64,S", "data:;base64,S?==", "data:,%"}) {
    EXPECT_THROW(data_of_uri(uri, "s"), InputError) << uri;
  }
}

}  // namespace
}  // namespace geom
