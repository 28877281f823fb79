#include "traj/mission/dji/dji_flight.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geom/base/error.h"
#include "mission/flown/flown_regions.h"
#include "surface_heights.h"

namespace traj {
namespace {

constexpr double kRises = 50;           // m from home: nearer, some return without a rise
constexpr double kUsualRise = 3;        // m/s, where the airframe is not known
constexpr double kReturns = 20;         // m from home: nearer, some land where they are
constexpr double kSlack = 0.01;         // m, by which turns of a leg may seem to meet
constexpr double kHomeOff = 5;          // m, of the height model's ground from the take-off's
constexpr double kPiece = 5;            // m, of a leg over the surface that has one band of heights
constexpr int kStartsLow[] = {60, 89};  // M300, M350: they do not rise to the security height

// Holds a turn through its waypoint, which may swing wide.
Hull through_hull(const Vec3& from, const Vec3& corner, const Vec3& to, double radius) {
  double low = corner.z();
  double high = corner.z();
  for (const Vec3& p : {before_corner(from, corner, radius), before_corner(to, corner, radius)}) {
    low = std::min(low, p.z());
    high = std::max(high, p.z());
  }
  const double swing = high - low;
  Hull hull;
  for (const double x : {-radius, radius}) {
    for (const double y : {-radius, radius}) {
      hull.emplace_back(corner.x() + x, corner.y() + y, low - swing);
      hull.emplace_back(corner.x() + x, corner.y() + y, high + swing);
    }
  }
  return hull;
}

class DjiFlight {
 public:
  DjiFlight(const DjiMission& mission, const MissionFrame& frame, const DjiRules& rules,
            std::string_view source)
      : mission_(mission), frame_(frame), rules_(rules), earth_(frame.origin), source_(source) {
    set_surface();
    set_home();
    if (surface_) require_same_zero();
  }

  FlownDji fly() {
    require_same_return();
    const DjiWaypoint* last = nullptr;
    for (const DjiWayline& wayline : mission_.waylines) {
      last ? go_on(wayline, *last) : begin(wayline);
      fly(wayline);
      last = &wayline.waypoints.back();
    }
    end();
    for (const Turn& turn : turns_) sweep(turn);
    if (const DjiAirframe* airframe = airframe_of(mission_.aircraft)) {
      flown_.climb = airframe->climb;
      flown_.descent = airframe->descent;
    }
    flown_.path_stray = kMissionStray;
    flown_.idle_items = mission_.actions;
    flown_.return_height = mission_.return_height;
    flown_.returns_if_lost = mission_.without_link == "goBack";
    claim_surface();
    estimate_time();
    return std::move(flown_);
  }

 private:
  // At a point of the way.
  struct Turn {
    std::size_t at = 0;
    std::size_t item = 0;
    const DjiWaypoint* waypoint = nullptr;
  };

  [[noreturn]] void refuse(const DjiWaypoint& waypoint, geom::Fault fault) const {
    throw geom::InputError(source_, waypoint.line, std::move(fault));
  }

  Vec3 on_map(double latitude, double longitude, double z, std::size_t line) const {
    if (!is_near(frame_.origin, latitude, longitude)) {
      throw geom::InputError(
          source_, line,
          {.expected = fmt::format("a place near the origin {} {}", frame_.origin.latitude,
                                   frame_.origin.longitude),
           .found = fmt::format("{} {}", latitude, longitude)});
    }
    Vec3 p = earth_.enu({latitude, longitude, 0});
    p.z() = z;
    return p;
  }

  // The aircraft takes the file's height when the mission is loaded, whatever was set before.
  void require_same_return() const {
    const auto& said = mission_.return_height;
    const auto& asked = rules_.return_height;
    if (!said || !asked || *said == *asked) return;
    throw geom::InputError(
        source_, {.expected = fmt::format("globalRTHHeight {:g}, as --return-height says", *asked),
                  .found = fmt::format("{:g}", *said),
                  .advice = "the aircraft returns at the file's height: leave the option out"});
  }

  const DjiWaypoint& first_waypoint() const { return mission_.waylines.front().waypoints.front(); }

  // Where its waylines follow the surface.
  void set_surface() {
    const auto follows = [](const DjiWayline& one) {
      return one.heights == DjiHeights::above_surface;
    };
    const DjiWaypoint& first = first_waypoint();
    const auto& waylines = mission_.waylines;
    if (std::none_of(waylines.begin(), waylines.end(), follows)) return;
    if (!std::all_of(waylines.begin(), waylines.end(), follows)) {
      refuse(first, {.expected = "waylines that all follow the surface, or none",
                     .found = "some that do (executeHeightMode realTimeFollowSurface)"});
    }
    if (!rules_.surface || !rules_.surface->surface) {
      refuse(first,
             {.expected = "heights above the ellipsoid or the take-off (executeHeightMode WGS84 or "
                          "relativeToStartPoint)",
              .found = "heights above the surface as the aircraft sees it",
              .advice = "no file says how well it keeps them: say between which heights "
                        "over a height model it stays (--ground-model, --surface-band)"});
    }
    if (!airframe_of(mission_.aircraft)) {
      refuse(first, {.expected = "an aircraft of which is known how fast it climbs",
                     .found = fmt::format("type {}", mission_.aircraft.type),
                     .advice = "it climbs and sinks as the surface does"});
    }
    surface_.emplace(*rules_.surface, kMissionStray.x() + rules_.around, source_);
  }

  // The band counts from the model, and all else from the take-off.
  void require_same_zero() const {
    const SurfaceRange over = heights_at(home_);
    const double low = over.low - rules_.surface->surface->low;
    const double high = over.high - rules_.surface->surface->high;
    if (home_.z() >= low - kHomeOff && home_.z() <= high + kHomeOff) return;
    refuse(first_waypoint(),
           {.expected = fmt::format(
                "a take-off within {} m of the height model's ground, {:.1f} to {:.1f} m there",
                kHomeOff, low, high),
            .found = fmt::format("one at {:.1f} m", home_.z()),
            .advice = "both must count from the zero of the map (--ground, --ground-model)"});
  }

  // What the band of heights came from.
  void claim_surface() {
    if (!surface_) return;
    const geom::GroundModel& ground = *rules_.surface->ground;
    flown_.climb_holds_in_band = true;  // it is the airframe's
    flown_.terrain = TerrainClaim{.model = ground.is_flat() ? "flat" : ground.spec().hash,
                                  .band = widest_,
                                  .surface = rules_.surface->surface};
  }

  // Level ways at their speeds, then all that it rises and sinks, and where it hovers.
  void estimate_time() {
    const DjiAirframe* airframe = airframe_of(mission_.aircraft);
    double rise = flown_.path.front().z() - home_.z();
    for (std::size_t i = 1; i < flown_.path.size(); ++i) {
      rise += std::abs(flown_.path[i].z() - flown_.path[i - 1].z());
    }
    const bool comes_down = flown_.lands_below || flown_.ends.landing_on.has_value();
    if (comes_down) rise += std::max(0.0, flown_.path.back().z() - home_.z());
    for (const double hold : flown_.hold) seconds_ += hold;
    for (const DjiWayline& wayline : mission_.waylines) seconds_ += wayline.hover_before;
    flown_.least_seconds =
        seconds_ + rise / (airframe ? std::min(airframe->climb, airframe->descent) : kUsualRise);
  }

  void set_home() {
    const DjiWaypoint& first = first_waypoint();
    const auto& planned = mission_.takeoff;
    if (!rules_.ground && !(planned && frame_.height_known)) {
      refuse(first, {.says = fmt::format(
                         "heights count from the take-off, and {}",
                         planned ? "the map does not say how high above the ellipsoid its z = 0 is"
                                 : "the file does not say where that is"),
                     .advice = "give the map's z of the ground there (--ground)"});
    }
    const double z = rules_.ground ? *rules_.ground : planned->height - frame_.origin.height;
    flown_.home_is_said = planned.has_value();
    geom::GeodeticPlace& at = flown_.home_place;
    at = planned ? *planned : geom::GeodeticPlace{first.latitude, first.longitude, 0};
    at.height = z + frame_.origin.height;
    home_ = on_map(at.latitude, at.longitude, z, planned ? 0 : first.line);
    flown_.home = home_;
    flown_.ends.takeoff_from = z;
  }

  Vec3 place(const DjiWayline& wayline, const DjiWaypoint& waypoint) const {
    if (surface_) {
      const Vec3 p = on_map(waypoint.latitude, waypoint.longitude, 0, waypoint.line);
      return at_height(p, heights_at(p).middle());
    }
    const bool above_takeoff = wayline.heights == DjiHeights::above_takeoff;
    if (!above_takeoff && !frame_.height_known) {
      refuse(
          waypoint,
          {.expected = "heights above the take-off",
           .found =
               "one above the ellipsoid, and the map does not say how high above it its z = 0 is",
           .advice = "give --origin latitude,longitude,height"});
    }
    const double zero = above_takeoff ? home_.z() : -frame_.origin.height;
    return on_map(waypoint.latitude, waypoint.longitude, zero + waypoint.height, waypoint.line);
  }

  static Vec3 at_height(const Vec3& p, double z) { return {p.x(), p.y(), z}; }

  SurfaceRange heights_at(const Vec3& p) const { return surface_->over(std::array{p}); }

  void go(const Vec3& p, Manoeuvre manoeuvre, double hold) {
    if (surface_ && !flown_.path.empty()) flown_.leg_band.push_back(0);
    flown_.path.push_back(p);
    flown_.hold.push_back(hold);
    flown_.legs.push_back({item_, manoeuvre});
    way_.push_back(p);
  }

  // A straight leg at heights over the surface, in pieces: each has its band around the path.
  void go_along_surface(const Vec3& to, double hold) {
    const Vec3 from = flown_.path.back();
    const double pieces = std::max(1.0, std::ceil((to - from).head<2>().norm() / kPiece));
    for (double k = 1; k <= pieces; ++k) {
      const Vec3 before = flown_.path.back();
      Vec3 p = k == pieces ? to : Vec3(from + (to - from) * (k / pieces));
      p.z() = heights_at(p).middle();
      const SurfaceRange heights = surface_->over(std::array{before, p});
      flown_.path.push_back(p);
      flown_.hold.push_back(k == pieces ? hold : 0);
      flown_.legs.push_back({item_, Manoeuvre::leg});
      flown_.leg_band.push_back(std::max(heights.high - std::min(before.z(), p.z()),
                                         std::max(before.z(), p.z()) - heights.low));
      widest_ = std::max(widest_, heights.high - heights.low);
    }
    way_.push_back(to);
  }

  // Anywhere in an upright face between two places, at a height that nobody knows.
  void sweep_face(const Vec3& a, const SurfaceRange& over_a, const Vec3& b,
                  const SurfaceRange& over_b, Manoeuvre manoeuvre) {
    flown_.sweeps.push_back({{at_height(a, over_a.low), at_height(a, over_a.high),
                              at_height(b, over_b.low), at_height(b, over_b.high)},
                             {item_, manoeuvre}});
  }

  // To a place where it may be already.
  void reach(const Vec3& p, Manoeuvre manoeuvre) {
    if (flown_.path.empty() || flown_.path.back() != p) go(p, manoeuvre, 0);
  }

  void begin(const DjiWayline& wayline) {
    const DjiWaypoint& waypoint = wayline.waypoints.front();
    const Vec3 first = place(wayline, waypoint);
    const double security = home_.z() + mission_.security_height;
    const bool safely = mission_.approach == DjiApproach::safely;
    const bool starts_low = std::find(std::begin(kStartsLow), std::end(kStartsLow),
                                      mission_.aircraft.type) != std::end(kStartsLow);
    const SurfaceRange over_first =
        surface_ ? heights_at(first) : SurfaceRange{first.z(), first.z()};
    if (starts_low && (!safely || over_first.low < security)) {
      refuse(waypoint, {.says = fmt::format(
                            "an aircraft of type {} does not rise to takeOffSecurityHeight before "
                            "it flies to the first waypoint: expected flyToWaylineMode safely, and "
                            "that waypoint at least {} m above the take-off",
                            mission_.aircraft.type, mission_.security_height)});
    }
    if (surface_) {
      const double top = std::max(security, over_first.high);
      reach(at_height(home_, security), Manoeuvre::takeoff);
      reach(at_height(first, security), Manoeuvre::leg);
      go(first, Manoeuvre::leg, 0);
      // It rises to a height that the surface decides, before or after it goes there.
      sweep_face(home_, {security, top}, first, {std::min(security, over_first.low), top},
                 Manoeuvre::leg);
      return say_speed(mission_.transit_speed, first - home_);
    }
    const double rises_to = safely ? std::max(security, first.z()) : security;
    reach(at_height(home_, rises_to), Manoeuvre::takeoff);
    if (safely || first.z() < security) reach(at_height(first, rises_to), Manoeuvre::leg);
    reach(first, Manoeuvre::leg);
    if (flown_.path.size() > 1) say_speed(mission_.transit_speed, first - home_);
  }

  void go_on(const DjiWayline& wayline, const DjiWaypoint& last) {
    const Vec3 from = way_.back();
    const std::size_t begun = way_.size() - 1;
    const Vec3 first = place(wayline, wayline.waypoints.front());
    if (surface_) {
      // It may follow the surface here, or fly level or straight between any heights of the ends.
      const SurfaceRange all = surface_->over(std::array{from, first});
      sweep_face(from, all, first, all, Manoeuvre::leg);
      go_along_surface(first, 0);
      require_room(begun, last, wayline.waypoints.front());
      return say_speed(mission_.transit_speed, first - from);
    }
    if (mission_.approach == DjiApproach::safely) {
      const double z = std::max(from.z(), first.z());
      reach(at_height(from, z), Manoeuvre::climb);
      reach(at_height(first, z), Manoeuvre::leg);
    }
    reach(first, Manoeuvre::leg);
    require_room(begun, last, wayline.waypoints.front());
    say_speed(mission_.transit_speed, first - from);
  }

  // Of a leg; over the surface of its plan, which is never longer.
  double length(const Vec3& leg) const { return surface_ ? leg.head<2>().norm() : leg.norm(); }

  // For turns where one wayline ends and the next begins.
  void require_room(std::size_t begun, const DjiWaypoint& last, const DjiWaypoint& first) const {
    const auto leg = [&](std::size_t to) { return length(way_[to] - way_[to - 1]); };
    const std::size_t end = way_.size() - 1;
    if (end == begun) {
      require_apart(last, first, 0);
    } else if (end == begun + 1) {
      require_apart(last, first, leg(end));
    } else {
      require_apart(last, {}, leg(begun + 1));
      require_apart({}, first, leg(end));
    }
  }

  void fly(const DjiWayline& wayline) {
    const auto& waypoints = wayline.waypoints;
    flown_.hold.back() += waypoints.front().hover;
    take_turn(waypoints.front());
    for (std::size_t i = 1; i < waypoints.size(); ++i) {
      const Vec3 p = place(wayline, waypoints[i]);
      require_apart(waypoints[i - 1], waypoints[i], length(p - way_.back()));
      if (surface_) {
        go_along_surface(p, waypoints[i].hover);
      } else {
        go(p, Manoeuvre::leg, waypoints[i].hover);
      }
      take_turn(waypoints[i]);
      say_speed(waypoints[i - 1].speed, p - way_[way_.size() - 2]);
    }
  }

  void require_apart(const DjiWaypoint& a, const DjiWaypoint& b, double leg) const {
    const double turns = a.damping + b.damping;
    if (turns <= leg + kSlack || turns == 0) return;
    refuse(b, {.expected = "turns that do not meet",
               .found = fmt::format(
                   "a leg of {:.2f} m, of which turns take {} m (waypointTurnDampingDist)", leg,
                   turns)});
  }

  // At the waypoint where it is; counts it.
  void take_turn(const DjiWaypoint& waypoint) {
    if (waypoint.turn != DjiTurn::stop) {
      turns_.push_back({way_.size() - 1, item_, &waypoint});
    }
    ++item_;
  }

  void sweep(const Turn& turn) {
    if (turn.at == 0 || turn.at + 1 >= way_.size()) return;
    Vec3 from = way_[turn.at - 1];
    const Vec3& corner = way_[turn.at];
    Vec3 to = way_[turn.at + 1];
    if (surface_) from.z() = to.z() = corner.z();  // how steep its legs are is not known
    const double radius = turn.waypoint->damping;
    const bool early = turn.waypoint->turn == DjiTurn::early;
    Hull hull =
        early ? corner_hull(from, corner, to, radius, 0) : through_hull(from, corner, to, radius);
    if (surface_) hull = surface_->raised(hull);
    flown_.sweeps.push_back({std::move(hull), {turn.item, Manoeuvre::corner}});
  }

  // Of a leg, for an estimate of the time.
  void say_speed(double speed, const Vec3& leg = Vec3::Zero()) {
    flown_.speed = std::max(flown_.speed.value_or(0), speed);
    seconds_ += leg.head<2>().norm() / speed;
  }

  void end() {
    --item_;  // the last waypoint
    flown_.lands_below = mission_.finish == DjiFinish::land;
    flown_.returns = mission_.finish == DjiFinish::first_waypoint;
    flown_.ends_at_home = mission_.finish == DjiFinish::go_home;
    if (flown_.ends_at_home) return_home();
    if (flown_.lands_below || flown_.ends.landing_on) {
      flown_.legs.push_back({item_, Manoeuvre::landing});
    }
  }

  void return_home() {
    const auto height = mission_.return_height ? mission_.return_height : rules_.return_height;
    const Vec3 last = flown_.path.back();
    const double away = (last - home_).head<2>().norm();
    flown_.returns = !height || away < kReturns;
    if (flown_.returns) return;
    if (surface_) return return_from_surface(last, *height);
    const double z = std::max(last.z(), home_.z() + *height);
    reach(at_height(last, z), Manoeuvre::climb);
    reach(at_height(home_, z), Manoeuvre::return_home);
    if (away < kRises && z > last.z()) {
      const Hull heights{last, at_height(last, z), at_height(home_, last.z()), at_height(home_, z)};
      flown_.sweeps.push_back({heights, {item_, Manoeuvre::return_home}});
    }
    flown_.ends.landing_on = home_.z();
    flown_.returns_at = height;
    flown_.speed_before_return = flown_.speed;
    flown_.speed.reset();  // that of the return is the aircraft's own
  }

  // It begins anywhere in the band there, and so returns at any of the heights to which it rises.
  void return_from_surface(const Vec3& last, double height) {
    const SurfaceRange begins = heights_at(last);
    const SurfaceRange returns{std::max(begins.low, home_.z() + height),
                               std::max(begins.high, home_.z() + height)};
    reach(at_height(last, returns.high), Manoeuvre::climb);
    reach(at_height(home_, returns.high), Manoeuvre::return_home);
    const bool near = (last - home_).head<2>().norm() < kRises;
    sweep_face(last, {begins.low, returns.high}, home_,
               {near ? begins.low : returns.low, returns.high}, Manoeuvre::return_home);
    flown_.ends.landing_on = home_.z();
    flown_.returns_at = height;
    flown_.speed_before_return = flown_.speed;
    flown_.speed.reset();  // that of the return is the aircraft's own
  }

  const DjiMission& mission_;
  const MissionFrame& frame_;
  const DjiRules& rules_;
  geom::GeographicFrame earth_;
  std::string source_;
  Vec3 home_ = Vec3::Zero();  // where it stands before
  std::size_t item_ = 0;      // the waypoint that it flies to
  std::vector<Turn> turns_;
  geom::Polyline way_;  // the path without the points between which the surface is followed
  std::optional<SurfaceHeights> surface_;
  double widest_ = 0;   // m, of its bands
  double seconds_ = 0;  // that it takes over the surface, an estimate
  FlownDji flown_;
};

}  // namespace

FlownDji flown_dji(const DjiMission& mission, const MissionFrame& frame, const DjiRules& rules,
                   std::string_view source) {
  return DjiFlight(mission, frame, rules, source).fly();
}

}  // namespace traj
