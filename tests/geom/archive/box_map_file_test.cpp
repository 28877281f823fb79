#include "geom/archive/box_map_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <system_error>

#include "geom/base/error.h"
#include "geom/map/box_map.h"
#include "support/edited_map.h"
#include "support/random_city.h"
#include "support/temporary_folder.h"

namespace geom {
namespace {

using support::file_of;

TEST(BoxMapFile, ReadsBackWhatWasWrittenByteForByte) {
  const BoxMap map = support::random_city(6, 200, 500);
  const auto bytes = file_of(map);
  const BoxMap back = read_box_map(ArrayArchive::from_bytes(bytes, "m"));
  EXPECT_EQ(back.hash(), map.hash());
  EXPECT_TRUE(
      std::equal(back.boxes().begin(), back.boxes().end(), map.boxes().begin(), map.boxes().end()));
  EXPECT_EQ(file_of(back), bytes);
}

TEST(BoxMapFile, HostileBytesAreRefusedOrLoadAsSoundMaps) {
  const auto good = file_of(support::random_city(7, 5, 50));
  support::Random random(8);
  int refused = 0;
  for (int i = 0; i < 4000; ++i) {
    auto bytes = good;
    for (int k = 0; k < 3; ++k)
      bytes[random.below(static_cast<int>(bytes.size()))] = std::byte(random.below(256));
    if (i % 4 == 0) bytes.resize(random.below(static_cast<int>(bytes.size())));
    try {
      const BoxMap map = read_box_map(ArrayArchive::from_bytes(bytes, "m"));
      for (const Aabb& box : map.boxes()) ASSERT_TRUE((box.min.array() <= box.max.array()).all());
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);
}

TEST(BoxMapFile, IsOpenedByItsPathAndKnownByItsMeta) {
  const support::TemporaryFolder folder;
  const BoxMap map = support::random_city(9, 20, 100);
  {
    std::ofstream out(folder / "m.boxmap", std::ios::binary);
    write_box_map(out, map);
  }
  EXPECT_EQ(open_map(folder / "m.boxmap").hash(), map.hash());
  EXPECT_THROW(open_map(folder / "none.boxmap"), std::system_error);
  EXPECT_TRUE(is_box_map(ArrayArchive::from_bytes(file_of(map), "m")));
  std::ostringstream other;
  write_array_archive(other, R"({"format":"another"})", {});
  const auto bytes = support::bytes_of(other.str());
  EXPECT_FALSE(is_box_map(ArrayArchive::from_bytes(bytes, "o")));
  EXPECT_THROW(read_box_map(ArrayArchive::from_bytes(bytes, "o")), InputError);
}

}  // namespace
}  // namespace geom
