#include "terrain_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geom/base/error.h"
#include "geom/base/rounding.h"

namespace traj {
namespace {

// The grid's metres are those of a sphere, and its rows and columns are not quite along our axes.
constexpr double kSureReach = 1.03;
constexpr double kRoom = 2;        // m: places travel rounded, and vehicles stray
constexpr double kWholeMetre = 1;  // m: posts are whole metres, rounded or cut
// m that TERRAIN_OFS_MAX may cut off before the autopilot says so
// (AP_Terrain::update_reference_offset)
constexpr double kUnsaid = 0.5;

// How far along a row, in spacings, a post may be from where its height was taken. The autopilot
// counts columns from the corner of a whole degree, with the length of a degree of longitude half
// way to the place (AP_Terrain::calculate_grid_info), up to 0.5 degrees off. A ground station
// counts them from the corner of a block of 28 rows and 32 columns, with the length at that corner.
// Near the poles there is no such bound.
double misplaced(double latitude, std::string_view source) {
  constexpr double kHalfDegree = 0.0087267;  // rad
  constexpr double kAcross = 31;             // columns from the block's corner
  constexpr double kDegree = 111320;         // m: of longitude, at the equator
  constexpr double kRadius = 6356752;        // m: of the Earth, at least
  constexpr double kUp = 27;                 // rows from the block's corner
  constexpr double kHighest = 84;            // degrees
  if (!(std::abs(latitude) <= kHighest)) {
    throw geom::InputError(source,
                           {.expected = "home within 84 degrees of the equator, since heights "
                                        "count from terrain",
                            .found = fmt::format("{} degrees", latitude)});
  }
  const double angle = (std::abs(latitude) + 0.6) * 0.0174532925199433;
  const double turn = std::tan(angle) * kHalfDegree;
  return kAcross * turn / (1 - turn) + kUp * 0.5 * kDegree / kRadius * std::sin(angle);
}

}  // namespace

TerrainDifference::TerrainDifference(const TerrainRules& rules, const geom::Vec2& home,
                                     double latitude, double spacing, double reach,
                                     std::string_view source)
    : rules_(rules),
      error_(rules.error.value() + kWholeMetre),
      home_(home),
      spacing_(spacing),
      far_(spacing * (1 + misplaced(latitude, source))),
      reach_(far_ + reach),
      source_(source) {
  at_home_ = ground({home, home}, far_);
  const geom::GroundRange around = ground({home, home}, spacing + far_);
  slope_ = (around.high - around.low + 2 * error_) / spacing;
}

geom::GroundRange TerrainDifference::ground(const geom::Rectangle& region, double around) const {
  const geom::Vec2 by = geom::Vec2::Constant(around * kSureReach + kRoom);
  geom::Rectangle at{region.min - by, region.max + by};
  if (rules_.axes != geom::Axes::enu) {
    std::swap(at.min.x(), at.min.y());
    std::swap(at.max.x(), at.max.y());
  }
  const geom::GroundRange range = rules_.ground->range(at);
  if (range.all_known) return range;
  throw geom::InputError(
      source_,
      {.expected = fmt::format("a height model that knows the ground within {:.0f} m of the way, "
                               "since the autopilot's terrain is interpolated from there",
                               around * kSureReach + kRoom),
       .found = fmt::format("a hole, or its end, at x {:.6g} to {:.6g}, y {:.6g} to {:.6g}",
                            at.min.x(), at.max.x(), at.min.y(), at.max.y()),
       .advice = "take a larger height model (and map)"});
}

double TerrainDifference::furthest(const geom::Rectangle& region) const {
  const geom::Vec2 low = (region.min - home_).cwiseAbs();
  const geom::Vec2 high = (region.max - home_).cwiseAbs();
  return low.cwiseMax(high).sum();
}

TerrainRange TerrainDifference::over(const geom::Rectangle& region) const {
  const geom::GroundRange here = ground(region, reach_);
  const double off = geom::add_up(geom::add_up(error_, error_), kUnsaid);
  TerrainRange out{geom::add_down(geom::add_down(here.low, -at_home_.high), -off),
                   geom::add_up(geom::add_up(here.high, -at_home_.low), off)};
  const double away = furthest(region);
  if (away <= spacing_) {
    const double most = kUnsaid + slope_ * away * (1 + 1e-12);
    out.low = std::max(out.low, -most);
    out.high = std::min(out.high, most);
  }
  return out;
}

}  // namespace traj
