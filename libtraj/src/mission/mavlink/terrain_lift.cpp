#include "terrain_lift.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "geom/base/error.h"
#include "mission/flown/flown_regions.h"
#include "mission_autopilots.h"
#include "mission_jumps.h"
#include "mission_places.h"
#include "split_hull.h"
#include "terrain_difference.h"

namespace traj {
namespace {

using geom::Rectangle;
using geom::Vec2;

constexpr double kPiece = 25;    // m: regions are cut until they are no longer than this
constexpr double kAtHome = 2;    // m from home, along the axes, where its ground counts
constexpr double kReaction = 1;  // s until an autopilot that slows down does

// What the heights of all its legs count from.
bool sets_height(const MissionItem& item) {
  return MissionPlaces::is_there(item) && item.command != kLand;
}

void require_told(const MissionItem& item, std::string_view source) {
  if (item.command == kLoiterToHeight || item.command == kPayloadPlace) {
    refuse_item(source, item,
                {.expected = "no climb (31) and no payload's place (94) in a mission above terrain",
                 .found = fmt::format("command {}", item.command),
                 .advice = "these count from home"});
  }
  if (item.command == kLand && !MissionPlaces::is_here(item) && !counts_from_terrain(item)) {
    refuse_item(source, item,
                {.expected = "a landing's place with a height above terrain (frame 10)",
                 .found = fmt::format("frame {}", item.frame),
                 .advice = "an autopilot flies there at one height above home, whatever the "
                           "terrain"});
  }
  if (!sets_height(item)) return;
  if (!counts_from_terrain(item)) {
    refuse_item(source, item,
                {.expected = "a height above terrain, as another waypoint of the mission has",
                 .found = fmt::format("frame {}", item.frame),
                 .advice = "how high the way between them is depends on where the autopilot looks "
                           "at its terrain"});
  }
  if (MissionPlaces::keeps_height(item)) {
    refuse_item(source, item, {.expected = "a height above terrain", .found = "0"});
  }
}

// Cuts a flat flight, remembers the terrain under each piece, and raises the pieces when all of the
// terrain is known.
class Raising {
 public:
  Raising(FlownMavlink flat, const MissionRules& rules, double latitude, std::string_view source)
      : flown_(std::move(flat)), rules_(*rules.terrain) {
    double reach = 0;
    for (const Autopilot& one : rules.autopilots) {
      claim_.spacing = std::max(claim_.spacing, one.terrain_spacing);
      claim_.lag = std::max(claim_.lag, one.terrain_lag);
      slowest_rise_ = std::min({slowest_rise_, one.climb, one.descent});
      arrival_ = std::max(arrival_, one.acceptance);
    }
    for (std::size_t i = 0; i < rules.autopilots.size(); ++i) {
      const double speed = std::max(rules.autopilots[i].speed, flown_.drift[i].speed);
      reach = std::max(reach, s_curve_length(rules.autopilots[i], speed) + kReaction * speed);
    }
    const Vec2 home = flown_.home->head<2>();
    difference_.emplace(rules_, home, latitude, claim_.spacing, reach, source);
    find_return(rules.autopilots);
    claim_.error = rules_.error.value();
    claim_.model = rules_.ground->is_flat() ? "flat" : rules_.ground->spec().hash;
  }

  FlownMavlink run() {
    std::vector<LegPiece> legs = cut_path();
    const std::vector<SweepPiece> sweeps = cut(flown_.sweeps);
    std::vector<std::vector<SweepPiece>> drifts;
    for (const Drift& drift : flown_.drift) drifts.push_back(cut(drift.sweeps));
    // Now all of the terrain that the vehicle may have been over is known.
    settle_circles();
    settle_return();
    settle_time();
    raise_path(legs);
    set_landing();
    flown_.sweeps = raised(sweeps);
    for (std::size_t i = 0; i < drifts.size(); ++i) {
      flown_.drift[i].sweeps = raised(drifts[i]);
      flown_.drift[i].legs.clear();
    }
    flown_.terrain = claim_;
    return std::move(flown_);
  }

 private:
  struct SweepPiece {
    const Sweep* of = nullptr;
    Hull hull;
    TerrainRange terrain;
    bool at_home = false;
  };
  struct LegPiece {
    std::size_t leg = 0;  // to this point of the path
    Vec3 a;
    Vec3 b;
    TerrainRange terrain;
    bool returns = false;
  };
  // A return counts from home: up from the last place over terrain, across, and down.
  struct Return {
    std::size_t begin = 0;  // the point of the path where it begins
    double low = 0;         // its z, over flat ground
    double top = 0;         // z at which it is flown
    double turn = 0;        // m below that where it may go across already
    double climb = 0;       // m that it climbs at least
    TerrainRange terrain;   // where it begins
  };

  void find_return(std::span<const Autopilot> autopilots) {
    const auto begins = std::find_if(
        flown_.legs.begin(), flown_.legs.end(),
        [](const FlightPart& part) { return part.manoeuvre == Manoeuvre::return_home; });
    if (begins == flown_.legs.begin() || begins == flown_.legs.end()) return;
    Return& out = return_.emplace();
    out.begin = static_cast<std::size_t>(begins - flown_.legs.begin()) - 1;
    out.low = flown_.path[out.begin].z();
    out.top = flown_.path.back().z();
    for (const Autopilot& one : autopilots) {
      out.turn = std::max({out.turn, s_curve_length(one, one.climb), one.height_acceptance});
      out.climb = std::max(out.climb, one.return_climb);
    }
    out.terrain = look(region_of(std::span(flown_.path).subspan(out.begin, 1)));
  }

  bool is_of_return(const FlightPart& part) const {
    return return_ &&
           (part.manoeuvre == Manoeuvre::return_home || part.manoeuvre == Manoeuvre::landing);
  }

  // The vehicle does not slow down for its terrain on a circle (AC_Circle::update_cms). So it may
  // leave a circle with a height that is behind by all of the terrain.
  void settle_circles() {
    const bool any =
        std::any_of(flown_.legs.begin(), flown_.legs.end(),
                    [](const FlightPart& part) { return part.manoeuvre == Manoeuvre::circle; });
    if (any) claim_.lag = std::max(claim_.lag, all_.high - all_.low);
  }

  // Where it begins too high for the height at which it returns, nobody knows that height.
  void settle_return() {
    if (!return_) return;
    return_->terrain = with_lag(return_->terrain, flown_.legs[return_->begin]);
    if (return_->low + return_->terrain.high + return_->climb > return_->top) flown_.returns = true;
  }

  // The time over flat ground, and the time in which the vehicle rises and sinks with the ground.
  void settle_time() {
    double level = flown_.least_seconds;
    for (const Drift& drift : flown_.drift) {
      if (!drift.legs.empty()) level = std::max(level, drift.legs.back().until);
    }
    flown_.least_seconds = level + rise_ / slowest_rise_;
  }

  // Points at the height where a return begins are as high or low as the terrain there may be.
  Hull raised_return(const Hull& hull) const {
    Hull out = hull;
    for (const Vec3& p : hull) {
      if (std::abs(p.z() - return_->low) < 1e-6) {
        out.push_back(p + Vec3(0, 0, return_->terrain.low));
        out.push_back(p + Vec3(0, 0, return_->terrain.high));
      } else if (p.z() > return_->top - return_->turn && p.z() < return_->top) {
        out.emplace_back(p.x(), p.y(), return_->top - return_->turn);
      }
    }
    return out;
  }

  static Rectangle region_of(std::span<const Vec3> hull) {
    const geom::Aabb box = *geom::bounds(hull);
    return {box.min.head<2>(), box.max.head<2>()};
  }

  TerrainRange look(const Rectangle& region) {
    const TerrainRange terrain = difference_->over(region);
    all_ = all_.with(terrain);
    return terrain;
  }

  std::vector<LegPiece> cut_path() {
    std::vector<LegPiece> out;
    const geom::Polyline& path = flown_.path;
    look(region_of(std::span(path).first(1)));
    for (std::size_t i = 1; i < path.size(); ++i) {
      if (return_ && i > return_->begin) {
        out.push_back({i, path[i - 1], path[i], {}, true});
        continue;
      }
      const Vec3 way = path[i] - path[i - 1];
      const double pieces = std::max(1.0, std::ceil(way.head<2>().norm() / kPiece));
      for (double k = 0; k < pieces; ++k) {
        LegPiece piece{
            i, path[i - 1] + way * (k / pieces), path[i - 1] + way * ((k + 1) / pieces), {}};
        if (k + 1 == pieces) piece.b = path[i];
        piece.terrain = look(region_of(std::array{piece.a, piece.b}));
        rise_ += std::abs(ground_at(piece.b.head<2>()) - ground_at(piece.a.head<2>()));
        out.push_back(piece);
      }
    }
    return out;
  }

  std::vector<SweepPiece> cut(const std::vector<Sweep>& sweeps) {
    std::vector<SweepPiece> out;
    for (const Sweep& sweep : sweeps) {
      if (is_of_return(sweep.part)) {
        out.push_back({&sweep, sweep.hull, {}});
        continue;
      }
      for (Hull& hull : split_hull(sweep.hull, kPiece)) {
        const Rectangle region = region_of(hull);
        const bool at_home =
            sweep.part.manoeuvre == Manoeuvre::takeoff && difference_->furthest(region) <= kAtHome;
        out.push_back({&sweep, std::move(hull), look(region), at_home});
      }
    }
    return out;
  }

  // The vehicle is behind the terrain by no more than the lag, and no higher or lower over the
  // ground's than all of the terrain on its way. To a landing it goes as high as it was within the
  // radius of the last waypoint (ModeAuto::shift_alt_to_current_alt).
  TerrainRange with_lag(const TerrainRange& terrain, const FlightPart& part) const {
    const double more = part.manoeuvre == Manoeuvre::landing ? arrival_ : 0;
    return {std::max(terrain.low - claim_.lag, all_.low) - more,
            std::min(terrain.high + claim_.lag, all_.high) + more};
  }

  void raise_path(const std::vector<LegPiece>& legs) {
    const std::size_t count = legs.size();
    std::vector<TerrainRange> bands;
    for (const LegPiece& piece : legs) {
      bands.push_back(piece.returns ? TerrainRange{}
                                    : with_lag(piece.terrain, flown_.legs[piece.leg]));
    }
    const auto middle = [&](std::size_t vertex) {  // before the piece of that number
      if (vertex == 0 && (flown_.takes_off || count == 0)) return 0.0;
      const bool first = vertex == 0;
      if (!first && legs[vertex - 1].returns) return 0.0;
      const bool last = vertex == count || legs[vertex].returns;
      const TerrainRange& one = bands[last ? vertex - 1 : vertex];
      const TerrainRange both = first ? one : one.with(bands[vertex - 1]);
      return (both.low + both.high) / 2;
    };
    const std::vector<FlightPart> parts = std::move(flown_.legs);
    const std::vector<double> hold = std::move(flown_.hold);
    const std::size_t points = flown_.path.size();
    flown_.path = {flown_.path.front() + Vec3(0, 0, middle(0))};
    flown_.legs = {parts.front()};
    flown_.hold = {hold.front()};
    for (std::size_t k = 0; k < count; ++k) {
      const double from = middle(k);
      const double to = middle(k + 1);
      flown_.path.push_back(legs[k].b + Vec3(0, 0, to));
      flown_.legs.push_back(parts[legs[k].leg]);
      const bool ends = k + 1 == count || legs[k + 1].leg != legs[k].leg;
      flown_.hold.push_back(ends ? hold[legs[k].leg] : 0);
      // A return goes up from wherever it begins: what is below the path is of the leg before.
      const double band =
          std::max(bands[k].high - std::min(from, to), std::max(from, to) - bands[k].low);
      flown_.leg_band.push_back(legs[k].returns ? 0 : band);
      claim_.band = std::max(claim_.band, bands[k].high - bands[k].low);
    }
    flown_.legs.insert(flown_.legs.end(), parts.begin() + static_cast<long>(points), parts.end());
  }

  // A landing sinks to the ground, which the model knows better than the autopilot.
  void set_landing() {
    if (!flown_.ends.landing_on) return;
    const Vec2 at = flown_.path.back().head<2>();
    flat_landing_ = *flown_.ends.landing_on;
    landing_ = difference_->furthest({at, at}) > kAtHome ? ground_at(at) : flown_.home->z();
    flown_.ends.landing_on = landing_;
  }

  // The middle of what the model says of a place that was looked at.
  double ground_at(Vec2 at) const {
    if (rules_.axes != geom::Axes::enu) std::swap(at.x(), at.y());
    const geom::GroundRange ground = rules_.ground->range({at, at});
    return (ground.low + ground.high) / 2;
  }

  std::vector<Sweep> raised(const std::vector<SweepPiece>& pieces) const {
    std::vector<Sweep> out;
    for (const SweepPiece& piece : pieces) {
      if (is_of_return(piece.of->part)) {
        out.push_back({raised_return(piece.hull), piece.of->part, piece.of->stands_on});
        continue;
      }
      const bool lands = piece.of->stands_on && piece.of->part.manoeuvre == Manoeuvre::landing;
      const TerrainRange by =
          piece.at_home ? piece.terrain : with_lag(piece.terrain, piece.of->part);
      Hull hull = lands ? sunk(piece.hull, by) : raised(piece.hull, by);
      if (piece.of->stands_on && !lands) keep_above(*piece.of->stands_on, hull);
      out.push_back(
          {std::move(hull), piece.of->part, lands ? std::optional(landing_) : piece.of->stands_on});
    }
    return out;
  }

  static Hull raised(const Hull& hull, const TerrainRange& by) {
    Hull out;
    for (const Vec3& p : hull) {
      out.push_back(p + Vec3(0, 0, by.low));
      if (by.high > by.low) out.push_back(p + Vec3(0, 0, by.high));
    }
    return out;
  }

  static void keep_above(double ground, Hull& hull) {
    for (Vec3& p : hull) p.z() = std::max(p.z(), ground);
  }

  // Down to the ground.
  Hull sunk(const Hull& hull, const TerrainRange& by) const {
    Hull out;
    for (const Vec3& p : hull) {
      out.emplace_back(p.x(), p.y(), landing_);
      if (p.z() <= flat_landing_) continue;
      for (const double raise : {by.low, by.high}) {
        out.emplace_back(p.x(), p.y(), std::max(landing_, p.z() + raise));
      }
    }
    return out;
  }

  FlownMavlink flown_;
  TerrainRules rules_;
  std::optional<TerrainDifference> difference_;
  TerrainClaim claim_;
  TerrainRange all_;    // of all the terrain on the way, home's included
  double arrival_ = 0;  // m: the radius of a waypoint
  double rise_ = 0;     // m that the ground under the legs rises and sinks, all together
  double slowest_rise_ = std::numeric_limits<double>::infinity();  // m/s
  std::optional<Return> return_;
  double landing_ = 0;
  double flat_landing_ = 0;  // before it was raised
};

}  // namespace

bool counts_from_terrain(const Mission& mission) {
  return std::any_of(mission.items.begin(), mission.items.end(),
                     [](const MissionItem& one) { return counts_from_terrain(one); });
}

bool counts_from_terrain(const Mission& mission, const MissionRules& rules,
                         std::string_view source) {
  if (!rules.terrain) return false;
  if (!counts_from_terrain(mission)) return false;
  if (!rules.terrain->error) {
    throw geom::InputError(
        source, {.says = "its heights count from terrain, and nobody says how far the autopilot's "
                         "own may be off the ground",
                 .advice = "give --terrain-error"});
  }
  for (const Autopilot& one : rules.autopilots) {
    if (one.follows_terrain) continue;
    throw geom::InputError(
        source,
        {.expected =
             "an autopilot that follows its terrain (TERRAIN_ENABLE 1, TERRAIN_OFS_MAX above "
             "0, and no rangefinder or WPNAV_RFND_USE 0)",
         .found = "parameters with which it does not",
         .advice = "its height is unknown if it follows a rangefinder, or terrain that counts from "
                   "the sea"});
  }
  if (!mission.home && mission.items.front().command != kTakeoff) {
    throw geom::InputError(source, {.expected = "home or a take-off as its first item, since the "
                                                "autopilot's terrain counts from home",
                                    .found = "neither"});
  }
  for (const MissionItem& item : mission.items) {
    if (!moves_nothing(item.command)) require_told(item, source);
  }
  return true;
}

FlownMavlink raised_over_terrain(FlownMavlink flat, const MissionRules& rules, double latitude,
                                 std::string_view source) {
  return Raising(std::move(flat), rules, latitude, source).run();
}

}  // namespace traj
