#include "traj/home/flight_stage.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "curve/halves.h"
#include "geom/shape/aabb.h"
#include "traj/curve/control_points.h"
#include "traj/home/prism.h"

namespace traj {
namespace {

using Hull = std::vector<Vec3>;

constexpr double kShortest = 1e-6;  // m: a stage that is no longer is one place

// --- times on legs --------------------------------------------------------------------------

struct Span {
  double from = std::numeric_limits<double>::infinity();
  double until = -std::numeric_limits<double>::infinity();

  void add(double a, double b) {
    from = std::min(from, a);
    until = std::max(until, b);
  }
};

double distance_to(const TimedLeg& leg, const Vec3& p) {
  const Vec3 way = leg.b - leg.a;
  const double squared = way.squaredNorm();
  const double s = squared > 0 ? std::clamp((p - leg.a).dot(way) / squared, 0.0, 1.0) : 0;
  return (leg.a + s * way - p).norm();
}

// No point of the hull is further from the leg.
double furthest_from(const TimedLeg& leg, const Hull& hull) {
  double most = 0;
  for (const Vec3& p : hull) most = std::max(most, distance_to(leg, p));
  return most;
}

// No point of the hull is nearer to the leg.
double nearest_to(const TimedLeg& leg, const geom::Aabb& hull) {
  const geom::Aabb box = geom::merged({leg.a, leg.a}, {leg.b, leg.b});
  return (hull.min - box.max).cwiseMax(box.min - hull.max).cwiseMax(0).norm();
}

// When the vehicle passes along a leg what lies beside it.
void add_time(const Hull& hull, const TimedLeg& leg, Span& span) {
  const Vec3 way = leg.b - leg.a;
  const double squared = way.squaredNorm();
  if (squared == 0) return span.add(leg.from, leg.until);
  const double lasts = leg.until - leg.from;
  for (const Vec3& p : hull) {
    const double s = std::clamp((p - leg.a).dot(way) / squared, 0.0, 1.0);
    span.add(leg.from + s * lasts, leg.from + s * lasts);
  }
}

// A place counts as passed at the instant of the way's point that is nearest to it. So legs count
// that may be the nearest to some place of the stage.
void set_time(FlightStage& stage) {
  const geom::Aabb box = *geom::bounds(stage.where);
  double sure = std::numeric_limits<double>::infinity();
  for (const TimedLeg& leg : stage.legs) sure = std::min(sure, furthest_from(leg, stage.where));
  Span span;
  for (const TimedLeg& leg : stage.legs) {
    if (nearest_to(leg, box) <= sure + kShortest) add_time(stage.where, leg, span);
  }
  stage.from = span.from;
  stage.until = span.until;
}

// --- cutting --------------------------------------------------------------------------------

// From one to the other of the two points that are furthest apart.
Vec3 longest_way(const Hull& hull) {
  Vec3 way = Vec3::Zero();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    for (std::size_t k = i + 1; k < hull.size(); ++k) {
      const Vec3 between = hull[k] - hull[i];
      if (between.squaredNorm() > way.squaredNorm()) way = between;
    }
  }
  return way;
}

// Points of the plane through the middle, on the ways from points on one side to points on the
// other; of these, the corners of their hull.
Hull crossing(const Hull& low, const Hull& high, const Vec3& along, double middle) {
  Hull points;
  for (const Vec3& a : low) {
    for (const Vec3& b : high) {
      const double begin = a.dot(along);
      const double end = b.dot(along);
      points.push_back(a + (b - a) * ((middle - begin) / (end - begin)));
    }
  }
  if (points.size() < 4) return points;
  const Vec3 u = along.unitOrthogonal();
  const Vec3 w = along.cross(u);
  std::vector<Vec2> plan;
  for (const Vec3& p : points)
    plan.emplace_back((p - points.front()).dot(u), (p - points.front()).dot(w));
  Hull out;
  for (const Vec2& p : plan_hull(plan)) {
    out.push_back(
        points[static_cast<std::size_t>(std::find(plan.begin(), plan.end(), p) - plan.begin())]);
  }
  return out;
}

std::pair<Hull, Hull> cut(const Hull& hull, const Vec3& way) {
  const Vec3 along = way.normalized();
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const Vec3& p : hull) {
    least = std::min(least, p.dot(along));
    most = std::max(most, p.dot(along));
  }
  const double middle = 0.5 * (least + most);
  std::pair<Hull, Hull> parts;
  for (const Vec3& p : hull) (p.dot(along) < middle ? parts.first : parts.second).push_back(p);
  const Hull between = crossing(parts.first, parts.second, along, middle);
  parts.first.insert(parts.first.end(), between.begin(), between.end());
  parts.second.insert(parts.second.end(), between.begin(), between.end());
  return parts;
}

FlightStage part_of(const FlightStage& stage, Hull where) {
  FlightStage out = stage;
  out.where = std::move(where);
  set_time(out);
  return out;
}

// --- curves ---------------------------------------------------------------------------------

FlightStage curve_stage(const Segment& segment, double from, double until) {
  FlightStage out;
  out.from = from;
  out.until = until;
  out.where.assign(segment.point.begin(), segment.point.end());
  for (std::size_t i = 1; i < kPoints; ++i) {
    out.velocity.push_back(
        {(segment.point[i] - segment.point[i - 1]) * (kDegree / segment.duration)});
  }
  out.curve = segment;
  return out;
}

std::pair<FlightStage, FlightStage> halves_of_curve(const FlightStage& stage) {
  const auto [early, late] = halves(stage.curve->point);
  const double middle = 0.5 * (stage.from + stage.until);
  const double lasts = 0.5 * stage.curve->duration;
  const auto part = [&](const std::array<Vec3, kPoints>& points, double from, double until) {
    FlightStage out = curve_stage({lasts, points, {}}, from, until);
    out.part = stage.part;
    return out;
  };
  return {part(early, stage.from, middle), part(late, middle, stage.until)};
}

// --- missions -------------------------------------------------------------------------------

// Holds all velocities that are no faster, in any direction.
std::vector<Velocity> any_direction(double across, double climb, double descent) {
  return {{{across, across, 0}},  {{-across, across, 0}}, {{-across, -across, 0}},
          {{across, -across, 0}}, {{0, 0, climb}},        {{0, 0, -descent}}};
}

// It waits where a leg ends until the next begins: as a leg that leads nowhere.
std::optional<TimedLeg> wait_after(const std::vector<TimedLeg>& legs, std::size_t i) {
  if (i + 1 >= legs.size() || legs[i].until >= legs[i + 1].from) return std::nullopt;
  return TimedLeg{legs[i].b, legs[i].b, legs[i].until, legs[i + 1].from, legs[i].part};
}

// Those that a sweep is beside: the ones that it names, or all of its item, or all.
std::vector<std::size_t> indices_beside(const Sweep& sweep, const std::vector<TimedLeg>& legs) {
  std::vector<std::size_t> all;
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    all.push_back(i);
    const bool beside = sweep.motion ? sweep.motion->first_leg <= i && i <= sweep.motion->last_leg
                                     : legs[i].part.item == sweep.part.item;
    if (beside) out.push_back(i);
  }
  if (!out.empty()) return out;
  return sweep.motion ? std::vector{legs.size() - 1} : all;
}

// With the waits before and behind them: it may be beside a point for as long as it waits there.
std::vector<TimedLeg> legs_beside(const Sweep& sweep, const std::vector<TimedLeg>& legs) {
  std::vector<TimedLeg> out;
  for (const std::size_t i : indices_beside(sweep, legs)) {
    const auto before = i > 0 ? wait_after(legs, i - 1) : std::nullopt;
    const auto behind = wait_after(legs, i);
    if (before) out.push_back(*before);
    out.push_back(legs[i]);
    if (behind) out.push_back(*behind);
  }
  return out;
}

FlightStage sweep_stage(const Sweep& sweep, const std::vector<TimedLeg>& legs,
                        const std::vector<Velocity>& any) {
  FlightStage out;
  out.where = sweep.hull;
  out.velocity = sweep.motion ? sweep.motion->velocity : any;
  out.part = sweep.part;
  out.stands_on = sweep.stands_on;
  out.legs = legs_beside(sweep, legs);
  set_time(out);
  return out;
}

void add_waits(const std::vector<TimedLeg>& legs, std::vector<FlightStage>& stages) {
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const auto wait = wait_after(legs, i);
    if (!wait) continue;
    FlightStage stage;
    stage.from = wait->from;
    stage.until = wait->until;
    stage.where = {wait->a};
    stage.part = wait->part;
    stage.legs = {*wait};
    stages.push_back(std::move(stage));
  }
}

std::vector<TimedPlace> timeline(const std::vector<TimedLeg>& legs) {
  std::vector<TimedPlace> out;
  const auto add = [&](double time, const Vec3& place) {
    if (out.empty() || out.back().time != time || out.back().place != place)
      out.push_back({time, place});
  };
  for (const TimedLeg& leg : legs) {
    if (leg.part.manoeuvre == Manoeuvre::return_home) continue;
    add(leg.from, leg.a);
    add(leg.until, leg.b);
  }
  return out;
}

// Seconds from a to b.
double seconds(const Vec3& a, const Vec3& b, const FlownMission& mission, double speed) {
  const double rise = b.z() - a.z();
  const double vertical = rise > 0 ? mission.climb : mission.descent;
  const double along = (b - a).norm() / speed;
  return vertical > 0 ? std::max(along, std::abs(rise) / vertical) : along;
}

std::vector<TimedLeg> timed_legs(const FlownMission& mission, double speed) {
  const Vec3& first = mission.path.front();
  const double ground = std::min(first.z(), mission.ends.takeoff_from.value_or(first.z()));
  const auto part = [&](std::size_t i) {
    return mission.legs.empty() ? FlightPart{} : mission.legs[std::min(i, mission.legs.size() - 1)];
  };
  std::vector<TimedLeg> legs;
  double now = 0;
  const auto go = [&](const Vec3& a, const Vec3& b, std::size_t i) {
    const double arrives = now + seconds(a, b, mission, speed);
    legs.push_back({a, b, now, arrives, part(i)});
    now = arrives;
    if (i < mission.hold.size()) now += mission.hold[i];
  };
  go({first.x(), first.y(), ground}, first, 0);
  for (std::size_t i = 1; i < mission.path.size(); ++i) {
    go(mission.path[i - 1], mission.path[i], i);
  }
  const Vec3& last = mission.path.back();
  if (mission.ends.landing_on) {
    go(last, {last.x(), last.y(), *mission.ends.landing_on}, mission.path.size());
  }
  return legs;
}

// The legs themselves, each in its direction. The first leg, and a landing, touch the ground.
void add_legs(const FlownMission& mission, const std::vector<TimedLeg>& legs,
              std::vector<FlightStage>& stages) {
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const TimedLeg& leg = legs[i];
    if (leg.part.manoeuvre == Manoeuvre::return_home) continue;
    FlightStage stage;
    stage.where = {leg.a, leg.b};
    if (leg.until > leg.from) stage.velocity = {{(leg.b - leg.a) / (leg.until - leg.from)}};
    stage.part = leg.part;
    if (i == 0) stage.stands_on = mission.ends.takeoff_from;
    if (i == mission.path.size()) stage.stands_on = mission.ends.landing_on;
    stage.legs = {leg};
    set_time(stage);
    stages.push_back(std::move(stage));
  }
}

}  // namespace

std::optional<std::pair<FlightStage, FlightStage>> halves(const FlightStage& stage) {
  const Vec3 way = longest_way(stage.where);
  if (!(way.norm() > kShortest)) return std::nullopt;
  if (stage.curve) return halves_of_curve(stage);
  auto [low, high] = cut(stage.where, way);
  std::pair parts{part_of(stage, std::move(low)), part_of(stage, std::move(high))};
  if (parts.first.from > parts.second.from) std::swap(parts.first, parts.second);
  return parts;
}

std::optional<std::pair<FlightStage, FlightStage>> ends_of(const FlightStage& stage) {
  const Vec3 way = longest_way(stage.where);
  if (!(way.norm() > kShortest)) return std::nullopt;
  std::pair ends{stage, stage};
  if (stage.curve) {
    ends.first.where = {stage.where.front()};
    ends.second.where = {stage.where.back()};
    ends.first.velocity = {stage.velocity.front()};
    ends.second.velocity = {stage.velocity.back()};
    ends.first.until = stage.from;
    ends.second.from = stage.until;
    ends.first.curve.reset();
    ends.second.curve.reset();
    return ends;
  }
  const auto along = [&](const Vec3& p) { return p.dot(way) / way.norm(); };
  const auto before = [&](const Vec3& a, const Vec3& b) { return along(a) < along(b); };
  const auto [least, most] = std::minmax_element(stage.where.begin(), stage.where.end(), before);
  const auto near = [&](const Vec3& end) {
    Hull where;
    for (const Vec3& p : stage.where) {
      if (std::abs(along(p) - along(end)) <= kShortest) where.push_back(p);
    }
    return where;
  };
  ends.first = part_of(stage, near(*least));
  ends.second = part_of(stage, near(*most));
  return ends;
}

double extent(const FlightStage& stage) { return longest_way(stage.where).norm(); }

std::vector<FlightStage> stages_of(const Trajectory& trajectory) {
  std::vector<FlightStage> out;
  double now = 0;
  for (const Segment& segment : trajectory.segments) {
    const double end = now + segment.duration;
    out.push_back(curve_stage(segment, now, end));
    now = end;
  }
  return out;
}

std::vector<FlightStage> stages_of(const Drift& drift) {
  double climb = 0;
  double descent = 0;
  for (const TimedLeg& leg : drift.legs) {
    if (leg.until <= leg.from) continue;
    const double rate = (leg.b.z() - leg.a.z()) / (leg.until - leg.from);
    climb = std::max(climb, rate);
    descent = std::max(descent, -rate);
  }
  const auto any = any_direction(drift.speed, climb, descent);
  std::vector<FlightStage> out;
  for (const Sweep& sweep : drift.sweeps) {
    if (sweep.part.manoeuvre == Manoeuvre::return_home) continue;
    out.push_back(sweep_stage(sweep, drift.legs, any));
  }
  add_waits(drift.legs, out);
  return out;
}

std::vector<FlightStage> stages_of(const FlownMission& mission, double speed) {
  const std::vector<TimedLeg> legs = timed_legs(mission, speed);
  const auto any =
      any_direction(speed, std::max(mission.climb, speed), std::max(mission.descent, speed));
  std::vector<FlightStage> out;
  add_legs(mission, legs, out);
  for (const Sweep& sweep : mission.sweeps) {
    if (sweep.part.manoeuvre == Manoeuvre::return_home) continue;
    out.push_back(sweep_stage(sweep, legs, any));
  }
  add_waits(legs, out);
  return out;
}

std::vector<TimedPlace> timeline_of(const Drift& drift) { return timeline(drift.legs); }

std::vector<TimedPlace> timeline_of(const FlownMission& mission, double speed) {
  return timeline(timed_legs(mission, speed));
}

}  // namespace traj
