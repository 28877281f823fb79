#include "traj/mission/mavlink/mission_flight.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geom/base/error.h"
#include "mission/flown/flown_regions.h"
#include "mission_autopilots.h"
#include "mission_circle.h"
#include "mission_clock.h"
#include "mission_jumps.h"
#include "mission_places.h"
#include "mission_speeds.h"
#include "mission_track.h"
#include "parameter_fence.h"
#include "terrain_lift.h"

namespace traj {
namespace {

constexpr double kSamePlace = 0.5;  // m: home and a take-off that mean the same

// RC_Channel::AUX_FUNC of ArduPilot: cameras, grippers, relays, a sound.
constexpr int kIdleFunctions[] = {9, 19, 28, 30, 34, 35, 36, 66, 67, 102, 166, 167, 168, 169};

bool moves_nothing(const MissionItem& item) {
  if (item.command != kAuxFunction) return traj::moves_nothing(item.command);
  const auto& all = kIdleFunctions;
  return std::find(std::begin(all), std::end(all), item.param[0]) != std::end(all);
}

// ArduPilot (AP_Mission::update) runs what follows such an item when its condition is met, or never
// if it comes to the next place before.
bool is_condition(int command) {
  return command == kConditionDelay || command == kConditionDistance || command == kConditionYaw;
}

// The path and regions of a flight, while it is being flown.
class Flight {
 public:
  Flight(const Mission& mission, const MissionFrame& frame, const MissionRules& rules,
         std::string_view source)
      : mission_(mission),
        frame_(frame),
        rules_(rules),
        places_(mission, frame, rules, source),
        source_(source),
        over_terrain_(counts_from_terrain(mission, rules, source)) {}

  FlownMavlink fly() {
    require_legs_are_kept(rules_, source_);
    order_ = flown_order(mission_, source_, flown_.endless_jumps);
    require_goes_on(mission_, order_, rules_, source_);
    if (const MissionItem* item = not_for_px4(mission_)) {
      flown_.not_for_px4 = item->command;
      flown_.above_terrain = counts_from_terrain(*item);
    }
    for (next_ = 0; next_ < order_.size();) {
      item_ = &mission_.items[order_[next_++]];
      take(*item_);
    }
    if (path().empty()) {
      throw geom::InputError(source_, {.expected = "at least one waypoint", .found = "none"});
    }
    flown_.path_stray = kMissionStray;
    flown_.counts_from_flat_ground = rules_.ground && counts_from_terrain(mission_);
    flown_.least_seconds = clock_.seconds();
    flown_.returns_if_lost = std::all_of(rules_.autopilots.begin(), rules_.autopilots.end(),
                                         [](const Autopilot& one) { return one.returns_if_lost; });
    if (flown_.endless_jumps > 0) flown_.endless = "it jumps back for ever";
    flown_.counts_from_sea = places_.counts_from_sea();
    if (flown_.counts_from_sea) flown_.path_stray.z() += frame_.sea_error();
    say_home();
    finish_track();
    add_fences();
    if (over_terrain_) {
      const double latitude = mission_.home ? mission_.home->latitude : frame_.origin.latitude;
      return raised_over_terrain(std::move(flown_), rules_, latitude, source_);
    }
    return std::move(flown_);
  }

 private:
  [[noreturn]] void refuse(geom::Fault fault) const {
    refuse_item(source_, *item_, std::move(fault));
  }

  // --- places -------------------------------------------------------------------------------

  // A take-off or landing at null is where the vehicle is; so is a take-off at 0, 0, which is
  // ArduPilot's (not_for_px4). PX4 moves to a landing's place, be it 0, 0
  // (MissionBase::handleLanding).
  Vec3 place(const MissionItem& item) const {
    const bool null = std::isnan(item.latitude) || std::isnan(item.longitude);
    const bool lands_here = null || flown_by(Firmware::ardupilot, rules_);
    const bool may_be_here = item.command == kTakeoff || (item.command == kLand && lands_here);
    if (!MissionPlaces::is_here(item)) return places_.place(item, here());
    if (!may_be_here) {
      if (item.command != kLand) require_known_start("an item without a place");
      return places_.place(item, here());
    }
    const double z = places_.height(item);
    if (!path().empty()) return {path().back().x(), path().back().y(), z};
    if (!mission_.home)
      refuse({.expected = "a place of the take-off or of home", .found = "neither"});
    return on_map(*mission_.home, z);
  }

  std::optional<Vec3> here() const {
    return path().empty() ? std::nullopt : std::optional(path().back());
  }

  Vec3 on_map(const geom::GeodeticPlace& at, double z) const {
    return places_.on_map(*item_, at, z);
  }

  // The place of the next item that has one, if there is any, after an item at `from`.
  std::optional<Vec3> place_after(const Vec3& from) const {
    for (std::size_t i = next_; i < order_.size(); ++i) {
      const MissionItem& item = mission_.items[order_[i]];
      if (moves_nothing(item) || item.command == kSpeed) continue;
      if (!MissionPlaces::is_there(item)) return std::nullopt;
      Vec3 p = places_.place(item, from);
      if (item.command == kLand) p.z() = path().back().z();
      return p;
    }
    return std::nullopt;
  }

  // --- holds and turns ----------------------------------------------------------------------

  void go(const Vec3& p, double hold, Manoeuvre manoeuvre, const Turn& turn = {}) {
    const Vec3 begin(p.x(), p.y(), places_.home().value_or(p.z()));
    clock_.go(p - (path().empty() ? begin : path().back()));
    clock_.wait(hold);
    track_.go(p, hold, {item_->number, manoeuvre}, turn);
  }

  void sweep(Hull hull, Manoeuvre manoeuvre) {
    track_.sweep(std::move(hull), {item_->number, manoeuvre});
  }

  const geom::Polyline& path() const { return track_.path(); }

  void require_known_start(const char* what) const {
    if (track_.starts_at_point()) return;
    refuse({.expected =
                fmt::format("a waypoint before {}, so that it is known where that begins", what),
            .found = "loitering, a delay, a short hold or a take-off away from home"});
  }

  double hold_of(const MissionItem& item) const {
    const double hold = std::isnan(item.param[0]) ? 0 : item.param[0];
    if (!(hold >= 0) || !std::isfinite(hold)) {
      refuse({.key = "a hold", .expected = ">= 0 s", .found = fmt::to_string(hold)});
    }
    return hold;
  }

  // To a point where it waits, and goes on from wherever it is by then.
  void go_and_wait(const Vec3& p, double hold, Manoeuvre manoeuvre, const MissionItem& item) {
    const Turn turn = turn_at(item, hold, rules_);
    go(p, hold, manoeuvre, turn);
    if (hold > 0 && turn.radius > 0) track_.leave_from(track_.reached());
  }

  // --- items --------------------------------------------------------------------------------

  void take(const MissionItem& item) {
    if (moves_nothing(item)) {
      ++flown_.idle_items;
      if (is_condition(item.command)) speeds_.begin_condition();
      return;
    }
    last_ = item.number;
    if (item.command != kSpeed) speeds_.end_condition();
    if (flown_.ended) {
      refuse(
          {.expected =
               "nothing after the end of the flight (a landing, a return, loitering without end)",
           .found = fmt::format("command {}", item.command),
           .advice = "whether a vehicle goes on is a setting of it; check each flight as a file of "
                     "its own"});
    }
    switch (item.command) {
      case kTakeoff:
        return take_off(item);
      case kWaypoint:
        return go_and_wait(place(item), hold_of(item), Manoeuvre::leg, item);
      case kSplineWaypoint:
        return fly_spline(item);
      case kLoiterTime:
      case kLoiterForever:
        return loiter(item);
      case kLoiterTurns:
        return circle(item);
      case kLoiterToHeight:
        return climb(item);
      case kLand:
        return land(item);
      case kReturn:
        return return_home();
      case kSpeed:
        return speeds_.take(item, track_, clock_);
      case kDelay:
        return wait(item);
      case kPayloadPlace:
        return place_payload(item);
      case kAuxFunction:
        refuse({.expected = fmt::format("an auxiliary function that moves nothing ({})",
                                        fmt::join(kIdleFunctions, ", ")),
                .found = fmt::to_string(item.param[0]),
                .advice = "others change the mode or stop motors"});
      default:
        refuse({.expected = "waypoints (16, 82), take-offs (22), landings (21), loitering (17, 18, "
                            "19, 31), a return (20), delays (93), payload places (94), jumps "
                            "(177), speeds (178) or what is known to move nothing",
                .found = fmt::format("command {}", item.command)});
    }
  }

  // Straight up: at home, where the file says both and they differ, and then to the place it says.
  void take_off(const MissionItem& item) {
    if (!path().empty()) {
      refuse({.expected = "one take-off, at the beginning", .found = "another command before it"});
    }
    const Vec3 p = place(item);
    flown_.takes_off = true;
    flown_.ends.takeoff_from = places_.above_home(item, 0);
    if (mission_.home) {
      const Vec3 above_home = on_map(*mission_.home, p.z());
      const double away = (above_home - p).norm();
      if (away > kSamePlace) {
        flown_.takeoff_from_home = away;
        go(above_home, 1, Manoeuvre::takeoff);  // it climbs to the height first
      }
    }
    go(p, 0, Manoeuvre::takeoff);
    // Some autopilots take no heed of the place, and go on from above home.
    if (flown_.takeoff_from_home > 0) track_.leave_from({path().front(), p});
  }

  void fly_spline(const MissionItem& item) {
    const Vec3 b = place(item);
    const double hold = hold_of(item);
    if (!path().empty()) {
      require_known_start("a spline");
      const Vec3 a = path().back();
      std::vector<Vec3> leaving;
      std::vector<Vec3> arriving;
      if (path().size() > 1) {
        const Vec3& before = path()[path().size() - 2];
        leaving = {a - before, b - before};
      }
      if (const auto after = place_after(b)) arriving = {*after - a, *after - b};
      sweep(spline_hull(a, b, leaving, arriving), Manoeuvre::spline);
    }
    go_and_wait(b, hold, Manoeuvre::spline, item);
  }

  // On the spot, or on a circle of that radius, or anywhere in it.
  void loiter(const MissionItem& item) {
    const bool forever = item.command == kLoiterForever;
    const double hold = forever ? 0 : hold_of(item);
    const double radius = std::abs(item.param[2]);
    const Vec3 centre = place(item);
    flown_.ended = forever;
    if (forever) flown_.endless = "it loiters without end";
    if (!(radius > 0)) {
      return forever ? go(centre, hold, Manoeuvre::hover)
                     : go_and_wait(centre, hold, Manoeuvre::hover, item);
    }
    Hull disc = Circle{centre, require_radius(item, radius, source_)}.disc();
    if (!path().empty()) {
      Hull in = track_.from_where();
      in.insert(in.end(), disc.begin(), disc.end());
      sweep(std::move(in), Manoeuvre::hover);
    }
    sweep(disc, Manoeuvre::hover);
    go(centre, hold, Manoeuvre::hover);
    track_.leave_from(std::move(disc));
  }

  void circle(const MissionItem& item) {
    require_whole_turns(item, source_);
    const Circle way = circle_of(item, place(item), source_);
    if (path().empty()) refuse({.expected = "a waypoint or a take-off before the circle"});
    require_known_start("a circle");
    const Hull from = track_.reached();
    require_known_entry(way, from, item, source_);
    CircleFlight flight = fly_circle(way, from);
    sweep(std::move(flight.entry), Manoeuvre::circle);
    for (Hull& arc : flight.arcs) sweep(std::move(arc), Manoeuvre::circle);
    for (const Vec3& p : flight.points) go(p, 0, Manoeuvre::circle);
    clock_.turn(item.param[0], way.radius);
    track_.leave_from(std::move(flight.leaving));
  }

  // To the place, and up or down to its height, in whichever order.
  void climb(const MissionItem& item) {
    const Vec3 p = place(item);
    if (path().empty()) refuse({.expected = "a waypoint or a take-off before the climb"});
    const double radius = require_radius(item, std::abs(item.param[1]), source_);
    const double z = path().back().z();
    Hull hull = track_.from_where();
    for (const double height : {z, p.z()}) {
      const Vec3 centre(p.x(), p.y(), height);
      hull.push_back(centre);
      const Hull disc = Circle{centre, radius}.disc();
      if (radius > 0) hull.insert(hull.end(), disc.begin(), disc.end());
    }
    sweep(std::move(hull), Manoeuvre::climb);
    go({p.x(), p.y(), z}, 0, Manoeuvre::climb);
    go(p, 1, Manoeuvre::climb);
    if (radius > 0) track_.leave_from(Circle{p, radius}.disc());
  }

  // Down until it touches, at home's height, and up again.
  void place_payload(const MissionItem& item) {
    if (path().empty()) refuse({.expected = "a waypoint or a take-off before the payload's place"});
    require_known_start("a payload's place");
    Vec3 above = path().back();
    if (!MissionPlaces::is_here(item)) {
      above = on_map({item.latitude, item.longitude, 0}, above.z());
    }
    const double ground = places_.above_home(item, 0);
    go(above, 1, Manoeuvre::landing);
    track_.sweep({above, {above.x(), above.y(), ground}}, {item.number, Manoeuvre::landing},
                 ground);
    flown_.touches.push_back(above);
  }

  // On the ground at the height it says, from the height it comes with.
  void land(const MissionItem& item) {
    require_lands_below(item, rules_, source_);
    const Vec3 ground = place(item);
    if (path().empty()) refuse({.expected = "a waypoint or a take-off before the landing"});
    // ArduPilot stops before it lands.
    const bool stops = flown_by(Firmware::ardupilot, rules_) && track_.starts_at_point();
    if (MissionPlaces::is_here(item) && !stops && !track_.rests()) {
      refuse({.expected = "the place of the landing, or a waypoint with a hold before it",
              .found = "neither",
              .advice = "it lands where it is when it takes the waypoint for reached"});
    }
    const Vec3 above(ground.x(), ground.y(), path().back().z());
    if (above != path().back()) go(above, 0, Manoeuvre::landing);
    flown_.ends.landing_on = ground.z();
    flown_.ended = true;
    clock_.go(ground - above);
  }

  void return_home() {
    flown_.ended = flown_.ends_at_home = true;
    // A mission with a landing of its own may be returned to instead of home.
    const bool lands_elsewhere =
        std::any_of(mission_.items.begin(), mission_.items.end(),
                    [](const MissionItem& item) { return item.command == kLandingStart; });
    const bool home_alone = std::all_of(rules_.autopilots.begin(), rules_.autopilots.end(),
                                        [](const Autopilot& one) { return one.returns_home; });
    // Over terrain a return begins at one place, or nobody knows how high.
    const bool begins_anywhere =
        over_terrain_ && (!mission_.rally.empty() || path().empty() || !track_.rests());
    flown_.returns = !rules_.return_height || lands_elsewhere || !home_alone || begins_anywhere;
    if (flown_.returns || path().empty()) return;
    const Vec3 end = path().back();
    const double ground = places_.above_home(*item_, 0);
    const double z = std::max(end.z() + most_return_climb(rules_), ground + *rules_.return_height);
    flown_.returns = returns_below(rules_, z - ground);
    if (flown_.returns) return;
    const Vec3 home =
        mission_.home ? on_map(*mission_.home, z) : Vec3(path().front().x(), path().front().y(), z);
    track_.say_no_speed();  // it returns with one of its own
    const Hull low = track_.from_where();
    sweep_return(low, home, ground);
    go({end.x(), end.y(), z}, 0, Manoeuvre::return_home);
    go(home, 0, Manoeuvre::return_home);
    clock_.go({0, 0, ground - home.z()});
    flown_.ends.landing_on = ground;
    for (const geom::GeodeticPlace& rally : mission_.rally) {
      const double to = ground + rally.height;
      for (const Autopilot& one : rules_.autopilots) {
        const double height =
            one.rally_adds ? std::max(end.z(), to + *rules_.return_height) : std::max(z, to);
        const Vec3 above = on_map(rally, height);
        sweep_return(low, above, ground);
        sweep({above, on_map(rally, to)}, Manoeuvre::return_home);
      }
      flown_.rally.push_back(on_map(rally, to));
    }
  }

  void sweep_return(const Hull& low, const Vec3& above, double ground) {
    for (Hull& hull : return_hulls(low, above, ground, least_return_slope(rules_))) {
      sweep(std::move(hull), Manoeuvre::return_home);
    }
  }

  // So long. ArduPilot (ModeAuto::do_nav_delay) takes what is not above 0 for a time of day, which
  // the other parameters say.
  void wait(const MissionItem& item) {
    if (path().empty()) return;
    const bool ardupilot = !flown_by(Firmware::px4, rules_);
    if (item.param[0] == -1 || (ardupilot && !(item.param[0] > 0))) {
      flown_.endless = "it waits until a time of day";
    }
    if (item.param[0] != -1) {
      track_.stay(hold_of(item));
      clock_.wait(hold_of(item));
    }
    track_.leave_when_reached();
  }

  // --- what is left -------------------------------------------------------------------------

  void finish_track() {
    const double speed = track_.most_speed(rules_.speed.value_or(kUnsaidSpeed));
    const std::vector<Autopilot> autopilots = speeds_.as_set();
    for (const Autopilot& one : autopilots) {
      flown_.climb = std::max(flown_.climb, one.climb);
      flown_.descent = std::max(flown_.descent, one.descent);
      flown_.tight_radii = std::max(flown_.tight_radii, track_.tight_radii(one));
    }
    flown_.drift = track_.drift(autopilots, {last_, Manoeuvre::landing},
                                rules_.return_height.value_or(0), flown_);
    track_.finish({last_, Manoeuvre::landing}, speed * speed / (2 * rules_.braking), flown_);
  }

  void add_fences() {
    for (const GeodeticFence& fence : mission_.fences) {
      flown_.fences.push_back(fence_on_map(fence, frame_.origin, source_));
    }
  }

  void say_home() {
    const auto z = places_.home();
    if (!z) return;
    flown_.home = mission_.home ? on_map(*mission_.home, *z) : path().front();
    flown_.home->z() = *z;
    for (const geom::GeodeticPlace& rally : mission_.rally) {
      flown_.rally_points.push_back(on_map(rally, *z + rally.height));
    }
  }

  const Mission& mission_;
  const MissionFrame& frame_;
  const MissionRules& rules_;
  MissionPlaces places_;
  std::string source_;
  bool over_terrain_ = false;
  std::vector<std::size_t> order_;
  std::size_t next_ = 0;  // into the order
  const MissionItem* item_ = nullptr;
  std::size_t last_ = 0;  // that moves something
  MissionSpeeds speeds_{rules_};
  FlownTrack track_;
  MissionClock clock_{rules_.autopilots};
  FlownMavlink flown_;  // the track's parts when it is finished
};

}  // namespace

FlownMavlink flown_mission(const Mission& mission, const MissionFrame& frame,
                           const MissionRules& rules, std::string_view source) {
  MissionRules loading = rules;
  loading.autopilots = autopilots_that_load(mission, rules, source);
  FlownMavlink flown = Flight(mission, frame, loading, source).fly();
  flown.switches_fence = switches_fence_on(mission);
  require_within_fence(flown, loading.autopilots, source);
  return flown;
}

}  // namespace traj
