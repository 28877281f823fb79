#include "mission_drift.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drift_way.h"
#include "mission/flown/flown_regions.h"

namespace traj {
namespace {

// A leg that is not followed swings by so much, m: of radii below half a metre, and of others.
constexpr double kWideSwing = 3.3;
constexpr double kSwing = 1.4;
constexpr double kTightRadius = 0.5;  // m

constexpr double kPastLanding = 0.5;  // m beyond the place where it comes to sink

class DriftMaker {
 public:
  DriftMaker(const Autopilot& autopilot, const DriftTask& task)
      : pilot_(autopilot), task_(task), way_(autopilot, task) {}

  Drift make() {
    for (const Sweep& sweep : task_.sweeps) {
      const bool bends = sweep.part.manoeuvre == Manoeuvre::spline;
      out_.push_back({bends ? around(sweep.hull, way_.furthest_overshoot()) : sweep.hull,
                      sweep.part, sweep.stands_on});
      if (sweep.stands_on) set_down(sweep);
    }
    if (task_.ends.takeoff_from) take_off();
    for (std::size_t i = 0; i < task_.path.size(); ++i) {
      if (i > 0) leg(i);
      if (i > 0 && task_.legs[i].manoeuvre == Manoeuvre::climb) climb(i);
      if (i > 0 && i + 1 < task_.path.size()) way_.stops(i) ? stop(i) : pass(i);
    }
    task_.ends.landing_on ? land() : end();
    return_home();
    Drift drift{pilot_.name, std::move(out_), pilot_.tracking, way_.timed_legs()};
    for (std::size_t i = 1; i < task_.path.size(); ++i) {
      drift.speed = std::max(drift.speed, way_.speed_at_end(i));
    }
    return drift;
  }

 private:
  const Vec3& at(std::size_t i) const { return task_.path[i]; }

  void add(Hull hull, const FlightPart& part, std::optional<Motion> motion = {}) {
    out_.push_back({std::move(hull), part, {}, std::move(motion)});
  }
  void add_to_ground(Hull hull, const FlightPart& part, double ground,
                     std::optional<Motion> motion = {}) {
    out_.push_back({std::move(hull), part, ground, std::move(motion)});
  }

  // --- pieces -------------------------------------------------------------------------------

  void leg(std::size_t i) {
    Hull hull{at(i - 1), at(i)};
    const double r = way_.radius(i);
    if (way_.is_leg(i) && r < pilot_.least_radius) {
      hull.push_back({at(i - 1).x(), at(i - 1).y(), at(i).z()});
      hull = around(hull, r < kTightRadius ? kWideSwing : kSwing);
    }
    add(std::move(hull), task_.legs[i], way_.along(i, i));
    if (pilot_.climbs_ahead && way_.is_leg(i) && (i == 1 || way_.stops(i - 1))) climb_ahead(i);
  }

  // While it speeds up from a rest, the height is where it would be at full speed.
  void climb_ahead(std::size_t i) {
    const Vec3 way = at(i) - at(i - 1);
    const double across = level(way).norm();
    if (across == 0 || way.z() == 0) return;
    const double fast = way_.speed(i);
    const double share = std::min(1.0, fast * fast / (2 * pilot_.acceleration * across));
    const Vec3 up(0, 0, share * way.z());
    const Vec3 beyond = at(i - 1) + way_.overshoot(i - 1);
    add({at(i - 1), at(i - 1) + up, beyond, beyond + up, at(i) - share * level(way), at(i)},
        task_.legs[i], way_.along(i, i));
  }

  // A climb begins, and ends, where the place is within the radius, and stays so far off.
  void climb(std::size_t i) {
    const double r = way_.radius(i);
    Hull hull;
    for (const Vec3& p : {at(i - 1), at(i)}) {
      for (const Vec3& by : {Vec3(r, r, 0), Vec3(-r, r, 0)}) {
        hull.push_back(p + by);
        hull.push_back(p - by);
      }
    }
    if (i + 1 < task_.path.size())
      hull.push_back(way_.settled(i, way_.speed(i + 1), pilot_.from_corner));
    add(std::move(hull), task_.legs[i], way_.along(i, i + 1));
  }

  static Hull around(const Hull& hull, double by) {
    Hull out;
    for (const Vec3& p : hull) {
      for (int corner = 0; corner < 8; ++corner) {
        out.push_back(p + by * Vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1));
      }
    }
    return out;
  }

  void take_off() {
    const Vec3& top = at(0);
    const Vec3 ground(top.x(), top.y(), *task_.ends.takeoff_from);
    const double high = std::max(top.z(), ground.z() + pilot_.takeoff_height);
    add_to_ground({ground, {top.x(), top.y(), high}}, task_.legs[0], ground.z(), way_.along(0, 0));
    if (task_.path.size() < 2) return;
    const double low =
        std::min(pilot_.height_acceptance, std::max(0.0, (top.z() - ground.z()) / 2));
    const Vec3 up(0, 0, 1.25 * pilot_.height_acceptance);
    const Vec3 down(0, 0, low);
    Hull hull{top - down, Vec3(top.x(), top.y(), high) + up,
              way_.settled(0, way_.speed(1), pilot_.from_corner)};
    // Away from home: some go on from above home.
    const bool away = task_.path.size() > 2 && task_.legs[1].manoeuvre == Manoeuvre::takeoff;
    if (away) {
      hull.insert(hull.end(),
                  {at(1) - down, at(1) + up, way_.settled(1, way_.speed(2), pilot_.from_corner)});
    }
    add(std::move(hull), task_.legs[0], way_.along(0, away ? 2 : 1));
  }

  // Beyond the stop, and from there onto the next leg.
  void stop(std::size_t i) {
    const Vec3 beyond = way_.overshoot(i);
    if (beyond.isZero(0)) return;
    const double fast = way_.speed(i);
    add({at(i), at(i) + beyond, way_.settled(i, fast, pilot_.from_stop)},
        {task_.legs[i].item, Manoeuvre::overshoot}, way_.along(i, i + 1));
  }

  void pass(std::size_t i) {
    const FlightPart part{task_.legs[i].item, Manoeuvre::corner};
    const Vec3& p = at(i);
    const double fast = std::max(way_.speed_at_end(i), way_.speed(i + 1));
    cut_short_leg(i, part);
    if (pilot_.turns_by_s_curve) return pass_by_s_curve(i, fast, part);
    const double begin = std::hypot(way_.radius(i), pilot_.height_acceptance);
    Hull hull{before_corner(at(i - 1), p, begin), p, way_.settled(i, fast, pilot_.from_corner)};
    Motion motion = way_.along(i, i + 1);
    for (const Vec3& from : task_.turns[i].from) {
      hull.push_back(before_corner(from, p, begin));
      const Vec3 way = p - from;
      if (!way.isZero(0)) motion.velocity.push_back({way * (fast / way.norm())});
    }
    add(std::move(hull), part, std::move(motion));
    swing(i, fast, part);
    bulge(i, part);
    if (task_.hold[i] > 0) {
      add({before_corner(at(i - 1), p, begin),
           p + way_.direction(i) * (pilot_.run_on * way_.speed(i)),
           way_.settled(i, fast, pilot_.from_corner)},
          part, way_.along(i, i + 1));
    }
  }

  // Behind a leg so short that a corner has not decayed on it, it may come to the next leg from
  // anywhere between.
  void cut_short_leg(std::size_t i, const FlightPart& part) {
    constexpr double kShort = 12;  // m
    if (i + 2 >= task_.path.size() || way_.length(i + 1) > kShort || way_.stops(i + 1)) return;
    const double begin = std::hypot(way_.radius(i), pilot_.height_acceptance);
    add({before_corner(at(i - 1), at(i), begin), at(i), at(i + 1),
         way_.settled(i + 1, way_.speed(i + 2), pilot_.from_corner)},
        part, way_.along(i, i + 2));
  }

  // While it speeds up it swings to either side of the new leg, most from 10 m to 40 m behind the
  // corner, and half as far up or down; less behind sharp turns, which are flown slowly.
  void bulge(std::size_t i, const FlightPart& part) {
    constexpr double kBegin = 5;  // m
    constexpr double kEnd = 40;
    const Vec3& p = at(i);
    const Vec3 out = way_.direction(i + 1);
    const double long_leg = way_.length(i + 1);
    const double fast = way_.speed(i + 1);
    const double gentle = std::clamp((1 + way_.direction(i).dot(out)) / 1.5, 0.4, 1.0);
    const Vec3 aside = Vec3(-out.y(), out.x(), 0) * (gentle * pilot_.bulge * fast * fast);
    const Vec3 begin = p + out * std::min(kBegin, long_leg);
    const Vec3 end = p + out * std::min(kEnd, long_leg);
    Hull hull{p, way_.settled(i, fast, pilot_.from_corner)};
    for (const Vec3& at : {begin, end}) {
      for (const Vec3& by : {aside, Vec3(0, 0, aside.norm() / 2)}) {
        hull.push_back(at + by);
        hull.push_back(at - by);
      }
    }
    add(std::move(hull), part, way_.along(i, i + 1));
  }

  // The blend of two S-curves bends one way: it leaves the old leg where that begins to slow down,
  // passes within the radius, and joins the new leg where that is up to speed. So it stays in two
  // triangles.
  void pass_by_s_curve(std::size_t i, double fast, const FlightPart& part) {
    const Vec3& p = at(i);
    const Vec3 in = way_.direction(i);
    const Vec3 out = way_.direction(i + 1);
    const double blend = s_curve_length(pilot_, fast);
    const Vec3 begin = before_corner(at(i - 1), p, blend);
    const Vec3 end = before_corner(at(i + 1), p, std::max(blend, pilot_.from_corner.distance));
    const Vec3 inward = out - in;
    const double turn = inward.norm();
    const Vec3 nearest = turn > 0 ? Vec3(p + inward * (pilot_.acceptance / turn)) : p;
    add({begin, p, nearest}, part, way_.along(i, i + 1));
    add({p, end, nearest}, part, way_.along(i, i + 1));
    swing(i, fast, part);
  }

  // Behind a passed point it swings outward, as a stop is overshot.
  void swing(std::size_t i, double fast, const FlightPart& part) {
    const Vec3& p = at(i);
    const Vec3 in = way_.direction(i);
    const Vec3 out = way_.direction(i + 1);
    const double far = pilot_.overshoot_time * fast + pilot_.overshoot;
    const Vec3 across = in - out * in.dot(out);
    const double turned = across.norm();
    Hull hull{p, p + in * far, way_.settled(i, fast, pilot_.from_stop)};
    if (turned > 0) {
      const Vec3 outward = across * (std::min(1.0, turned * 2) * far / turned);
      hull.push_back(p + outward);
      hull.push_back(hull[2] + outward);
    }
    add(std::move(hull), part, way_.along(i, i + 1));
  }

  // A payload's place: it sinks at once, off by what its stop was overshot.
  void set_down(const Sweep& column) {
    for (std::size_t i = 1; i < task_.path.size(); ++i) {
      if (task_.legs[i] != column.part) continue;
      const double ground = *column.stands_on;
      Hull cone = sinking(at(i), at(i), 0, ground);
      add_overshoot(i, ground, cone);
      add_to_ground(std::move(cone), column.part, ground);
    }
  }

  void add_overshoot(std::size_t i, double ground, Hull& cone) const {
    const Vec3 beyond = at(i) + way_.overshoot(i);
    cone.push_back(beyond);
    cone.push_back({beyond.x(), beyond.y(), std::max(ground, at(i).z() - pilot_.fall / 3)});
  }

  // Sinking begins when the place is within the radius, and goes on while it still comes nearer.
  void land() {
    const std::size_t last = task_.path.size() - 1;
    const Vec3& above = at(last);
    const double ground = *task_.ends.landing_on;
    const Motion motion = way_.along(last, last + 1);
    add_to_ground({above, {above.x(), above.y(), ground}}, task_.landing, ground, motion);
    if (last == 0) return;
    const bool moves = task_.legs[last].manoeuvre == Manoeuvre::landing || way_.returns(last);
    const bool rests = !moves && task_.turns[last].kind == Turn::rest;
    const Vec3& before = rests ? above : at(last - 1);
    Hull cone = way_.returns(last) ? returned(above, before, way_.radius(last), ground, ground)
                                   : sinking(above, before, way_.radius(last), ground);
    add_overshoot(last, ground, cone);
    add_to_ground(std::move(cone), task_.landing, ground, motion);
    if (!way_.returns(last) || last < 2 || at(last - 2).z() >= above.z()) return;
    // Within the cone of returns it comes back as low as it was.
    const double low = at(last - 2).z();
    const Vec3 home(above.x(), above.y(), low);
    const Vec3 from(at(last - 1).x(), at(last - 1).y(), low);
    add_to_ground(returned(home, from, way_.radius(last), ground, ground), task_.landing, ground);
  }

  // As `sinking`; the landing of a return may first go aslant to a height above `place`.
  Hull returned(const Vec3& above, const Vec3& from, double radius, double ground,
                double place) const {
    Hull cone = sinking(above, from, radius, ground);
    const double low = std::max(ground, place + pilot_.return_descend);
    if (pilot_.descends_aslant && low < above.z()) cone.push_back({above.x(), above.y(), low});
    return cone;
  }

  Hull sinking(const Vec3& above, const Vec3& from, double radius, double ground) const {
    Hull cone{above, {above.x(), above.y(), std::max(ground, above.z() - pilot_.fall)}};
    const Vec3 way = above - from;
    const double length = way.norm();
    if (length == 0) return cone;
    cone.push_back(before_corner(from, above, radius));
    cone.push_back(above + way * (kPastLanding / length));
    return cone;
  }

  // A return begins where the stop before it ended, and goes up and across from there. At a rally
  // point it sinks as it does at home.
  void return_home() {
    const std::size_t last = task_.path.size() - 1;
    if (last < 1 || !way_.returns(last)) return;
    const bool climbs = last > 1 && way_.returns(last - 1);  // else it is as high as home asks for
    const std::size_t stop = climbs ? last - 2 : last - 1;
    const Vec3& top = at(last - 1);
    const Vec3 beyond = way_.overshoot(stop);
    if (climbs) climb_home(at(stop), top, beyond);
    for (const Vec3& rally : task_.rally) return_to(rally, at(stop), top, beyond);
  }

  void climb_home(const Vec3& low, const Vec3& top, const Vec3& beyond) {
    const std::size_t last = task_.path.size() - 1;
    const FlightPart part = task_.legs[last];
    if (!beyond.isZero(0)) {
      add({low, low + beyond, top, top + beyond}, part);
      add({top, top + beyond, at(last)}, part);
    }
    go_across(top, beyond, low, at(last), part);
  }

  // It goes across as soon as the height counts as reached, or by an S-curve.
  void go_across(const Vec3& top, const Vec3& beyond, const Vec3& low, const Vec3& to,
                 const FlightPart& part) {
    const double before =
        pilot_.turns_by_s_curve ? s_curve_length(pilot_, pilot_.climb) : pilot_.height_acceptance;
    const Vec3 under(0, 0, std::min(before, std::max(top.z() - low.z(), pilot_.height_acceptance)));
    add({top - under, top + beyond - under, top, top + beyond, to}, part);
  }

  // `top`: where it would return home from, above `low`, where it stopped and may be `beyond`.
  void return_to(const Vec3& rally, const Vec3& low, const Vec3& top, const Vec3& beyond) {
    const std::size_t last = task_.path.size() - 1;
    const FlightPart part = task_.legs[last];
    const double height = pilot_.rally_adds ? std::max(low.z(), rally.z() + task_.return_height)
                                            : std::max(top.z(), rally.z());
    const Vec3 from(top.x(), top.y(), height);
    const Vec3 above(rally.x(), rally.y(), height);
    add({low, low + beyond, from, from + beyond}, part);
    go_across(from, beyond, low, above, part);
    sink_to(rally, above, from, part);
    // Within the cone of returns it comes back as low as it was.
    if (low.z() >= height) return;
    const Vec3 flat(rally.x(), rally.y(), std::max(low.z(), rally.z()));
    sink_to(rally, flat, {low.x(), low.y(), flat.z()}, part);
  }

  void sink_to(const Vec3& rally, const Vec3& above, const Vec3& from, const FlightPart& part) {
    const double ground = task_.ends.landing_on.value_or(rally.z());
    Hull cone = returned(above, from, pilot_.acceptance, ground, rally.z());
    const Vec3 way = level(above - from);
    const double length = way.norm();
    if (length > 0) {
      const double past =
          pilot_.overshoot_time * way_.speed(task_.path.size() - 1) + pilot_.overshoot;
      cone.push_back(above + way * (past / length));
    }
    add_to_ground(std::move(cone), part, ground);
    add_to_ground({above, {above.x(), above.y(), ground}}, part, ground);
  }

  void end() {
    const std::size_t last = task_.path.size() - 1;
    if (last == 0) return;
    add({at(last), at(last) + way_.overshoot(last)}, {task_.legs[last].item, Manoeuvre::overshoot},
        way_.along(last, last));
  }

  const Autopilot& pilot_;
  const DriftTask& task_;
  DriftWay way_;
  std::vector<Sweep> out_;
};

}  // namespace

Drift drift_of(const Autopilot& autopilot, const DriftTask& task) {
  return DriftMaker(autopilot, task).make();
}

}  // namespace traj
