// What a map's file says of itself is believed once it was held against what it holds.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "geom/base/error.h"
#include "geom/collision/collision.h"
#include "geom/map/box_map.h"
#include "support/cases.h"
#include "support/edited_map.h"
#include "support/random_city.h"
#include "support/reading.h"

namespace geom {
namespace {

using support::EditedMap;
using support::Random;

const Vehicle kVehicle{"box", {0.5, 0.5, 0.5}};

BoxMap city(std::uint64_t seed, int count, double side, double tile_size) {
  const BoxMap map = support::random_city(seed, count, side);
  BoxMapSpec spec = map.spec();
  spec.tile_size = tile_size;
  return BoxMap(spec, support::table_of({map.boxes().begin(), map.boxes().end()}));
}

// Moves one face of one tile's extent inwards, by one step of a double up to all of its width.
void hide(EditedMap& edited, Random& random) {
  while (true) {
    const auto t = static_cast<std::size_t>(random.below(static_cast<int>(edited.tiles())));
    const auto axis = static_cast<std::size_t>(random.below(3));
    double& low = edited.tile_extent[6 * t + axis];
    double& high = edited.tile_extent[6 * t + 3 + axis];
    if (low == high) continue;
    const double by = random.below(4) ? (high - low) * random.uniform(0, 1) : 0;
    if (random.below(2)) {
      low = std::min(high, std::max(low + by, std::nextafter(low, HUGE_VAL)));
    } else {
      high = std::max(low, std::min(high - by, std::nextafter(high, -HUGE_VAL)));
    }
    return;
  }
}

bool meets_any(std::span<const Aabb> boxes, const Vec3& half, const Vec3& a, const Vec3& b) {
  return std::any_of(boxes.begin(), boxes.end(),
                     [&](const Aabb& box) { return segment_hits(a, b, grow(box, half)); });
}

TEST(MapTrust, NoSceneIsMadeOfAMapWhoseExtentsHideABox) {
  Random random(1);
  const auto maps = static_cast<std::uint64_t>(support::cases(100));
  std::uint64_t refused = 0;
  for (std::uint64_t seed = 0; seed < maps; ++seed) {
    const EditedMap honest(city(seed, 12, 120, 25));
    CollisionScene(honest.map(), kVehicle, 0);
    for (int i = 0; i < 100; ++i) {
      EditedMap lying = honest;
      hide(lying, random);
      const BoxMap map = lying.map();
      try {
        CollisionScene(map, kVehicle, 0);
        ADD_FAILURE() << "seed " << seed << ", case " << i;
      } catch (const InputError& error) {
        refused += std::string(error.what()).find("inside the extent") != std::string::npos;
      }
    }
  }
  EXPECT_EQ(refused, 100 * maps);
}

TEST(MapTrust, NothingIsGivenOutOfAMapWhoseExtentsHideABox) {
  Random random(2);
  EditedMap lying(city(3, 30, 200, 25));
  hide(lying, random);
  EXPECT_THROW(lying.map().tiles(), InputError);
  EXPECT_THROW(lying.map().boxes(), InputError);
  EXPECT_THROW(lying.map().boxes_of(lying.tiles() - 1), InputError);
  EXPECT_THROW(lying.map().label(), InputError);
}

// Bits, counts, ranges and bounds changed, boxes left out, the hash left as it was.
void lie(EditedMap& edited, Random& random) {
  const auto any = [&](std::size_t n) {
    return static_cast<std::size_t>(random.below(static_cast<int>(n)));
  };
  const auto flip = [&](auto& values) {
    auto* const bytes = reinterpret_cast<unsigned char*>(values.data());
    bytes[any(values.size() * sizeof(values[0]))] ^= static_cast<unsigned char>(1 << any(8));
  };
  switch (random.below(9)) {
    case 0:
      return flip(edited.boxes);
    case 1:
      return flip(edited.tile_extent);
    case 2:
      return flip(edited.tile_range);
    case 3:
      return flip(edited.tile_index);
    case 4:
      return flip(edited.tile_large);
    case 5:
      return flip(edited.label);
    case 6:
      return edited.remove(any(edited.size()));
    case 7: {
      const auto corner = any(2);
      const auto axis = any(3);
      edited.meta["bounds"][corner][axis] =
          edited.meta["bounds"][corner][axis].get<double>() + random.stepped(-20, 20, 5);
      return;
    }
    default:  // a box out of the way, and its tile's extent with it
      const std::size_t i = any(edited.size());
      for (const std::size_t k : {2, 5}) edited.boxes[6 * i + k] += 500;
      for (std::size_t t = 0; t < edited.tiles(); ++t) edited.tile_extent[6 * t + 5] += 500;
  }
}

struct Tally {
  int read = 0;      // as maps
  int scenes = 0;    // of which the extents are right
  int contents = 0;  // and the contents
};

// Scenes answer as their boxes are, and maps whose contents were verified are the true one.
void try_lie(const BoxMap& truth, const EditedMap& lying, Random& random, Tally& tally) {
  try {
    const BoxMap map = lying.map();
    ++tally.read;
    const CollisionScene scene(map, kVehicle, 0);
    ++tally.scenes;
    const Aabb around = grow(truth.spec().bounds, Vec3::Constant(5));
    for (int i = 0; i < 5; ++i) {
      Vec3 a;
      Vec3 b;
      for (int k = 0; k < 3; ++k) {
        a[k] = random.uniform(around.min[k], around.max[k]);
        b[k] = std::clamp(a[k] + random.uniform(-40, 40), around.min[k], around.max[k]);
      }
      ASSERT_EQ(scene.hits(a, b), meets_any(map.boxes(), scene.half(), a, b));
    }
    map.require(Verified::contents);
    ++tally.contents;
    ASSERT_TRUE(std::equal(map.boxes().begin(), map.boxes().end(), truth.boxes().begin(),
                           truth.boxes().end()));
    ASSERT_TRUE(map.spec().bounds == truth.spec().bounds);
  } catch (const InputError&) {
  }
}

TEST(MapTrust, ALyingMapIsRefusedOrAnswersAsItsBoxesAre) {
  Random random(3);
  Tally tally;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const BoxMap truth = city(seed, 15, 120, 25);
    const EditedMap honest(truth);
    for (int i = 0; i < 100; ++i) {
      EditedMap lying = honest;
      lie(lying, random);
      try_lie(truth, lying, random, tally);
    }
  }
  EXPECT_GT(tally.read, 2500);
  EXPECT_GT(tally.scenes, 1500);
  EXPECT_LT(tally.contents, tally.scenes / 3);
}

TEST(MapTrust, ALyingMapOfManyGroupsIsRefusedOrAnswersAsItsBoxesAre) {
  Random random(4);
  Tally tally;
  const BoxMap truth = city(9, 9000, 2500, 100);
  const EditedMap honest(truth);
  for (int i = 0; i < 200; ++i) {
    EditedMap lying = honest;
    if (i % 2) {
      lie(lying, random);
    } else {
      hide(lying, random);
    }
    try_lie(truth, lying, random, tally);
  }
  EXPECT_GT(tally.read, 100);
  EXPECT_LT(tally.scenes, 100);
}

TEST(MapTrust, ContentsAreRefusedWhereABoxIsMissingUnderTheOldHash) {
  EditedMap lying(city(5, 30, 200, 100));
  lying.remove(3);
  const BoxMap map = lying.map();
  map.require(Verified::extents);
  EXPECT_EQ(support::refusal_of([&] { map.require(Verified::contents); }).find("hash") !=
                std::string::npos,
            true);
  EXPECT_EQ(map.verified(), Verified::extents);
}

TEST(MapTrust, ContentsAreRefusedWhereABoxIsInAnotherTileOrOutOfOrder) {
  const BoxMap honest = city(6, 60, 200, 25);
  EditedMap other(honest);
  ASSERT_NE(other.tile_large[1], 1);
  other.tile_index[2] -= 1;  // the second tile is the first of its row
  EXPECT_THROW(other.map().require(Verified::contents), InputError);
  EditedMap swapped(honest);
  std::size_t t = 1;
  while (swapped.tile_range[2 * t + 1] < 2) ++t;
  const auto at = static_cast<std::ptrdiff_t>(6 * swapped.tile_range[2 * t]);
  std::swap_ranges(swapped.boxes.begin() + at, swapped.boxes.begin() + at + 6,
                   swapped.boxes.begin() + at + 6);
  EXPECT_THROW(swapped.map().require(Verified::contents), InputError);
}

TEST(MapTrust, ContentsAreRefusedWhereAChecksumDiffers) {
  const BoxMap honest = city(7, 30, 200, 100);
  const auto bytes = support::file_of(honest);
  const auto archive = ArrayArchive::from_bytes(bytes, "map");
  for (const auto& entry : archive.arrays()) {
    auto damaged = bytes;
    const auto found =
        std::search(damaged.begin(), damaged.end(), entry.stored.begin(), entry.stored.end());
    ASSERT_NE(found, damaged.end());
    *(found + static_cast<std::ptrdiff_t>(entry.stored.size()) - 1) ^= std::byte{1};
    EXPECT_THROW(
        {
          const BoxMap map = read_box_map(ArrayArchive::from_bytes(damaged, "map"));
          map.require(Verified::contents);
        },
        InputError)
        << entry.name;
  }
}

TEST(MapTrust, WhatTheMetaSaysOfCountsAndLabelsMustBeSo) {
  const EditedMap honest(city(8, 10, 100, 100));
  EditedMap counts = honest;
  counts.meta["boxes"] = 3;
  EXPECT_THROW(counts.map(), InputError);
  EditedMap labels = honest;
  labels.meta["labels"] = nlohmann::json::array();
  EXPECT_THROW(labels.map(), InputError);
}

TEST(MapTrust, TheFirstWrongBoxIsNamedWhateverTheThreads) {
  EditedMap lying(city(10, 200000, 3000, 100));
  for (const std::size_t i : {199000, 70000, 131072, 70001}) lying.boxes[6 * i] = NAN;
  for (const unsigned threads : {1u, 2u, 7u}) {
    const BoxMap map = lying.map();
    const std::string message = support::refusal_of([&] {
      map.require(Verified::extents, {threads, {}});
    });
    EXPECT_TRUE(support::says(message, "box 70000 must be finite"));
  }
}

TEST(MapTrust, IsVerifiedOnceForAllCopiesAndThreads) {
  const BoxMap map = EditedMap(city(11, 3000, 900, 100)).map();
  const BoxMap copy = map;
  EXPECT_EQ(map.verified(), Verified::nothing);
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 8; ++i) {
      threads.emplace_back([&, i] { map.require(i % 2 ? Verified::extents : Verified::contents); });
    }
  }
  EXPECT_EQ(copy.verified(), Verified::contents);
}

TEST(MapTrust, AMapThatWasMadeHereIsVerified) {
  EXPECT_EQ(city(12, 10, 100, 100).verified(), Verified::contents);
}

}  // namespace
}  // namespace geom
