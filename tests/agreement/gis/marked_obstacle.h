#pragma once

// The rule of all readers: an obstacle is in the map, or the tool says that it is not. Random files
// of a format have sound buildings and, at a random place, one obstacle that is told in some way
// that people use or get wrong.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geom/base/error.h"
#include "geom/base/random.h"
#include "geom/gis/footprint_source.h"

namespace geom::gis {

inline constexpr int kFiles = 10000;

template <class List>
std::string any_of(const List& list, geom::SplitMix64& random) {
  return std::string(
      list[static_cast<std::size_t>(random.whole(0, static_cast<int>(std::size(list)) - 1))]);
}

// A square, and how high it must at least be in the map.
struct Obstacle {
  geom::Vec2 corner;
  double size = 0;
  std::optional<double> bottom = 0;
  std::optional<double> top;  // metres; nothing: nobody knows
  bool no_default = false;    // a thing of any height

  std::array<geom::Vec2, 4> corners() const {
    return {corner, corner + geom::Vec2(size, 0), corner + geom::Vec2(size, size),
            corner + geom::Vec2(0, size)};
  }
};

inline bool holds(const geom::Footprint& f, const Obstacle& obstacle) {
  constexpr double kNear = 1e-6;
  if (f.polygon.outer.empty()) return false;
  geom::Vec2 low = f.polygon.outer.front();
  geom::Vec2 high = low;
  for (const geom::Vec2& p : f.polygon.outer) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  for (const geom::Vec2& p : obstacle.corners()) {
    if (((low - p).array() > kNear).any() || ((p - high).array() > kNear).any()) return false;
  }
  return f.bottom <= *obstacle.bottom + kNear && (!obstacle.top || f.top >= *obstacle.top - kNear);
}

struct Told {
  bool told = false;
  std::string file = {};  // its text, for who reads the failure
};

// Expects that each of so many files is told; `look` makes the i-th of its chance and asks
// is_told(): one of `things` obstacles, of which `marked` is the one to look for. Ends after five
// failures.
template <class Look>
void expect_told(int files, const Look& look) {
  int silent = 0;
  for (int i = 0; i < files && silent < 5; ++i) {
    geom::SplitMix64 random(static_cast<std::uint64_t>(i));
    const int things = random.whole(2, 7);
    const int marked = random.whole(0, things - 1);
    const Told told = look(things, marked, random);
    if (!told.told) ++silent;
    EXPECT_TRUE(told.told) << "file " << i << ": " << told.file;
  }
}

// Whether the obstacle is in what `read` gives, or something was said of it. All else in the file
// is sound, so that whatever is said is of the obstacle.
template <class Read>
bool is_told(const Obstacle& obstacle, const Read& read) {
  try {
    const Source source = read();
    if (!source.skipped.empty()) return true;
    for (const geom::Footprint& f : source.footprints) {
      if (holds(f, obstacle))
        return obstacle.top || (!obstacle.no_default && !source.defaults.empty());
    }
    return false;
  } catch (const geom::InputError&) {
    return true;
  }
}

// A height in metres as people write it.
inline std::string spelled(double metres, geom::SplitMix64& random) {
  const double feet = metres / 0.3048;
  const int whole = static_cast<int>(feet);
  const int inches = static_cast<int>((feet - whole) * 12) + 1;
  switch (random.whole(0, 17)) {
    case 0:
      return fmt::format("{} m", metres);
    case 1:
      return fmt::format("{}m", metres);
    case 2:
      return fmt::format("~{}", metres);
    case 3:
      return fmt::format("{:.2f} ft", feet + 0.01);
    case 4:
      return fmt::format("{}'{}\"", whole, inches);
    case 5:
      return fmt::format("{}'-{}\"", whole, inches);
    case 6:
      return fmt::format("{} ft {} in", whole, inches);
    case 7:
      return fmt::format("{};{}", metres / 2, metres);
    case 8:
      return fmt::format("{}-{} m", metres / 2, metres);
    case 9:
      return fmt::format("{} (roof), {} with mast", metres / 2, metres);
    case 10:
      return fmt::format("{}-{} storeys", whole / 20, whole / 10 + 1);
    case 11:
      return fmt::format("{} metres", metres);
    case 12:
      return fmt::format("{} cm", metres * 100);
    case 13:
      return fmt::format("{} to {}", metres / 2, metres);
    case 14:
      return whole >= 1000 ? fmt::format("{},{:03} ft", (whole + 1) / 1000, (whole + 1) % 1000)
                           : fmt::format("{} feet", whole + 1);
    case 15:
      return fmt::format(">{}", metres / 2);
    case 16:
      return fmt::format("{}+{}", metres / 2, metres / 2);
    default:
      return fmt::format("{}", metres);
  }
}

// Storeys as people write them, of 3 m each.
inline std::string spelled_levels(int levels, geom::SplitMix64& random) {
  switch (random.whole(0, 7)) {
    case 0:
      return fmt::format("{};{}", levels / 2, levels);
    case 1:
      return fmt::format("{}-{} storeys", levels / 2, levels);
    case 2:
      return fmt::format("{};{} floors", levels / 2, levels);
    case 3:
      return fmt::format("{}+{}", levels - 1, 1);
    case 4:
      return fmt::format("G+{}", levels - 1);
    case 5:
      return fmt::format("{} / {}", levels / 2, levels);
    case 6:
      return fmt::format("L{}", levels);
    default:
      return fmt::format("{}", levels);
  }
}

using Tags = std::vector<std::pair<std::string, std::string>>;

// The height of a building in tags; `top` is what they say.
inline Tags height_tags(Obstacle& obstacle, geom::SplitMix64& random) {
  const double metres = random.whole(4, 1600) / 4.0;
  const int levels = random.whole(2, 60);
  Tags tags;
  switch (random.whole(0, 7)) {
    case 0:
      tags = {{"height", any_of(std::array{"0", "-1", "0 m"}, random)},
              {"building:levels", spelled_levels(levels, random)}};
      obstacle.top = 3.0 * levels;
      break;
    case 1:
      tags = {{"building:levels", spelled_levels(levels, random)}};
      obstacle.top = 3.0 * levels;
      break;
    case 2:
      tags = {{"est_height", spelled(metres, random)}};
      obstacle.top = metres;
      break;
    case 3:
      tags = {{"min_height", fmt::format("{}", metres)}};
      obstacle.bottom = metres;
      break;
    case 4:  // its own height, from where it begins
      tags = {{"height", "3"}, {"min_height", fmt::format("{}", metres)}};
      if (metres >= 3) obstacle.top = metres + 3;
      obstacle.bottom = std::min(metres, 3.0);
      if (metres < 3) obstacle.top = 3;
      break;
    case 5:
      break;  // nobody knows
    default:
      tags = {{any_of(std::array{"height", "height", "building:height"}, random),
               spelled(metres, random)}};
      obstacle.top = metres;
  }
  return tags;
}

// Places in a grid, one for each thing of a file, in degrees.
inline geom::Vec2 place(int index) {
  return {24.9 + 0.001 * (index % 8), 60.1 + 0.001 * (index / 8)};
}

}  // namespace geom::gis
