#include "geom/map/box_map_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "geom/base/error.h"
#include "geom/map/box_map.h"
#include "geom/map/join.h"
#include "support/edited_map.h"
#include "support/random_city.h"
#include "support/reading.h"
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

BoxMap timed_city(std::uint64_t seed) {
  const BoxMap city = support::random_city(seed, 30, 300);
  BoxMapSpec spec = city.spec();
  spec.epoch = "2026-05-04T06:30:00Z";
  BoxTable table = table_of(city);
  table.set_time(2, {0, 60.5});
  table.set_time(7, {-std::numeric_limits<double>::infinity(), 1e6});
  table.set_time(8, {5, std::numeric_limits<double>::infinity()});
  return {spec, table};
}

TEST(BoxMapFile, KeepsTimes) {
  const BoxMap map = timed_city(6);
  const auto bytes = file_of(map);
  const BoxMap back = read_box_map(ArrayArchive::from_bytes(bytes, "m"));
  back.require(Verified::contents);
  EXPECT_EQ(back.hash(), map.hash());
  EXPECT_EQ(back.spec().epoch, map.spec().epoch);
  ASSERT_EQ(back.timed().size(), 3u);
  for (std::size_t i = 0; i < map.size(); ++i) EXPECT_EQ(back.time(i), map.time(i));
  EXPECT_EQ(file_of(back), bytes);
  EXPECT_EQ(support::EditedMap(map).meta["version"], 2);
  EXPECT_EQ(support::EditedMap(support::random_city(6, 30, 300)).meta["version"], 1);
}

// Each of these would make a box be there at fewer times than the map's hash says, or make the file
// one that an older reader takes.
TEST(BoxMapFile, RefusesTimesThatCannotBe) {
  const auto refusal = [](auto&& edit) {
    support::EditedMap map(timed_city(6));
    edit(map);
    return support::refusal_of([&] { map.map().require(Verified::contents); });
  };
  using Map = support::EditedMap;
  const double nan = std::nan("");
  const auto says = [&](const std::string& words, auto&& edit) {
    const std::string found = refusal(edit);
    EXPECT_TRUE(support::says(found, words)) << words << '\n' << found;
  };
  EXPECT_EQ(refusal([](Map&) {}), "");
  says("its boxes have", [](Map& m) { m.times[1] = 60; });
  says("its boxes have", [](Map& m) { m.meta["epoch"] = "2026-05-04T06:30:01Z"; });
  says("found none", [](Map& m) { m.meta.erase("epoch"); });
  says("epoch", [](Map& m) { m.meta["epoch"] = 1620000000; });
  says("epoch", [](Map& m) { m.meta["epoch"] = "2026-05-04"; });
  says("until must be seconds", [&](Map& m) { m.times[1] = nan; });
  says("from must be at most until", [](Map& m) { std::swap(m.times[0], m.times[1]); });
  says("until must be seconds", [](Map& m) { m.times[1] = 1.7e9; });
  says("above the one before", [](Map& m) { std::swap(m.timed[0], m.timed[1]); });
  says("above the one before", [](Map& m) { m.timed[1] = m.timed[0]; });
  says("below 31", [](Map& m) { m.timed[2] = 31; });
  says("have 2 and 3", [](Map& m) { m.timed.pop_back(); });
  says("must be of version 2, found 1", [](Map& m) { m.meta["version"] = 1; });
  says("version 1 or 2, found 3", [](Map& m) { m.meta["version"] = 3; });
  says("found none", [](Map& m) {
    m.timed.clear();
    m.times.clear();
  });
  says("timed", [](Map& m) { m.timed.clear(); });
  // The boxes alone, as an older release would have written them.
  says("its boxes have", [](Map& m) {
    m.timed.clear();
    m.times.clear();
    m.meta["version"] = 1;
  });
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

// As `cp other.boxmap city.boxmap` does: into the file that is there.
TEST(BoxMapFile, IsSeenToHaveBeenWrittenTo) {
  const support::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "city.boxmap";
  const auto write = [&](const std::filesystem::path& to, std::uint64_t seed) {
    const auto bytes = file_of(support::random_city(seed, 30, 300));
    std::ofstream(to, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  };
  write(path, 6);
  const BoxMap map = open_map(path);
  const BoxMap other = support::random_city(6, 30, 300);
  EXPECT_NO_THROW(require_unchanged(map));
  write(folder.path() / "new", 7);
  std::filesystem::rename(folder.path() / "new", path);
  EXPECT_NO_THROW(require_unchanged(map));  // its own file has no name any more, and stays
  const BoxMap second = open_map(path);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // clocks of files tick in some
  write(path, 8);
  EXPECT_THROW(require_unchanged(second), std::runtime_error);
  EXPECT_NO_THROW(require_unchanged(map));
  EXPECT_NO_THROW(require_unchanged(other));  // of no file
}

}  // namespace
}  // namespace geom
