#include "traj/home/return_sweeps.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "traj/home/return_heights.h"

namespace traj {
namespace {

using Plan = std::vector<Vec2>;

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kVerticalBraking = 2.5;  // m/s2, less than autopilots brake with
constexpr double kRoomAtRest = 0.3;       // m beside a rest by which it may be off
constexpr double kSlowestLanding = 0.3;   // m/s, of both firmwares near the ground

// All points within `by` metres of those along each axis.
Plan widened(const Plan& plan, double by) {
  if (by == 0) return plan;
  return plan_sum(plan, {{-by, -by}, {by, -by}, {by, by}, {-by, by}});
}

Plan hull_of_both(Plan a, const Plan& b) {
  a.insert(a.end(), b.begin(), b.end());
  return plan_hull(std::move(a));
}

// The largest horizontal speed, m/s, that the vehicle may have in the plan. It has sped up since
// its last rest, gains a little more while its acceleration fades, and can still slow down to its
// next rest.
double speed_at(const ReturnModel& model, const Velocity& velocity, const Plan& plan) {
  double speed = velocity.value.head<2>().norm();
  const auto reached = [&](const Vec3& rest) {
    const double away = furthest(plan, rest.head<2>()) + kRoomAtRest;
    return std::sqrt(2 * model.deceleration * away);
  };
  const double gains = model.deceleration * model.fading / 2;
  if (velocity.since) speed = std::min(speed, reached(*velocity.since) + gains);
  if (velocity.until) speed = std::min(speed, reached(*velocity.until));
  return speed;
}

// On the legs of a mission, seconds that it goes on before it slows down: if it may be speeding up,
// until its acceleration has faded. It speeds up no further from a rest than an S-curve is long. (A
// curve is flown by setpoints; from these PX4 begins its way to rest with no acceleration,
// FlightTaskAuto::activate.)
double lateness(const ReturnModel& model, const Velocity& velocity, const Plan& plan,
                double speed) {
  if (!velocity.since) return model.fading;
  const double ramp = speed * (speed / model.deceleration + model.fading) / 2 + kRoomAtRest;
  return distance(plan, velocity.since->head<2>()) > ramp ? 0 : model.fading;
}

// The most that it goes on, m, until it rests: it slows down to rest where it is to rest anyway.
double way_to_rest(const ReturnModel& model, const Velocity& velocity, const Plan& plan,
                   double speed) {
  if (!velocity.until) return std::numeric_limits<double>::infinity();
  const double left = furthest(plan, velocity.until->head<2>());
  return left + speed * (model.reaction + model.overshoot_time) + model.stop_length;
}

// Whether all are along one line in plan. A velocity between two that are not has a direction of
// its own, in which its stop is as much further as theirs are.
bool one_way(const std::vector<Velocity>& velocities) {
  Vec2 along = Vec2::Zero();
  for (const Velocity& v : velocities) {
    const Vec2 way = v.value.head<2>();
    if (way.norm() < 1e-6) continue;  // at rest, to rounding
    if (along.isZero(0)) along = way;
    const double aside = std::abs(along.x() * way.y() - along.y() * way.x());
    if (aside > 1e-9 * along.norm() * way.norm()) return false;
  }
  return true;
}

// How fast it is across, and up.
struct Pace {
  double speed = 0;  // m/s
  double rate = 0;   // m/s
};

// The largest product of rate and seconds on the way from one pace to another.
double most_on_way(double rate, double seconds, double other_rate, double other_seconds) {
  const double more = other_rate - rate;
  const double later = other_seconds - seconds;
  double most = std::max(rate * seconds, other_rate * other_seconds);
  if (more * later >= 0) return most;
  const double share = std::clamp(-(more * seconds + rate * later) / (2 * more * later), 0.0, 1.0);
  return std::max(most, (rate + share * more) * (seconds + share * later));
}

// m that it still rises (sign 1) or sinks (-1), at any pace between these.
double vertical_way(const ReturnModel& model, const std::vector<Pace>& paces, double sign,
                    double late) {
  double rate = 0;
  for (const Pace& one : paces) rate = std::max(rate, sign * one.rate);
  double most = rate * model.reaction + rate * rate / (2 * kVerticalBraking) +
                rate * kVerticalBraking / (2 * model.jerk);
  if (!model.stops_on_line) return most;
  for (std::size_t i = 0; i < paces.size(); ++i) {
    for (std::size_t k = i; k < paces.size(); ++k) {
      most = std::max(
          most, most_on_way(sign * paces[i].rate, braking_factor(model, paces[i].speed) + late,
                            sign * paces[k].rate, braking_factor(model, paces[k].speed) + late));
    }
  }
  return most;
}

double overshot(const ReturnModel& model) {
  return model.overshoot_time * model.speed + model.overshoot;
}

// The part of a plan on the left of the line from a to b.
Plan left_of(const Plan& plan, const Vec2& a, const Vec2& b) {
  const auto side = [&](const Vec2& p) {
    const Vec2 way = b - a;
    return way.x() * (p.y() - a.y()) - way.y() * (p.x() - a.x());
  };
  Plan out;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const Vec2& p = plan[i];
    const Vec2& q = plan[(i + 1) % plan.size()];
    const double here = side(p);
    const double there = side(q);
    if (here >= 0) out.push_back(p);
    if ((here < 0) != (there < 0)) out.push_back(p + (q - p) * (here / (here - there)));
  }
  return plan_hull(std::move(out));
}

// No point of the plan within `radius` of the middle is left out: an octagon around the circle.
Plan within(Plan plan, const Vec2& middle, double radius) {
  const double far = radius * (1 + 1e-9);
  const double near = far * (std::sqrt(2.0) - 1);
  const Vec2 corners[] = {{far, -near}, {far, near},   {near, far},   {-near, far},
                          {-far, near}, {-far, -near}, {-near, -far}, {near, -far}};
  for (std::size_t i = 0; i < std::size(corners) && !plan.empty(); ++i) {
    plan = left_of(plan, middle + corners[i], middle + corners[(i + 1) % std::size(corners)]);
  }
  return plan;
}

// The return of one stage to one place.
class Return {
 public:
  Return(const ReturnModel& model, const FlightStage& stage, const ReturnPlace& place)
      : model_(model),
        stage_(stage),
        place_(place),
        target_(place.ground.head<2>()),
        braking_(braking_region(model, stage)),
        end_(widened({target_}, overshot(model))),
        way_(hull_of_both(braking_.plan, end_)) {
    set_heights();
  }

  std::vector<ReturnSweep> sweeps() const {
    const double ground = place_.ground.z();
    std::vector<ReturnSweep> out{{braking_, ReturnPhase::braking, stage_.stands_on}};
    out.push_back({{braking_.plan, braking_.low, top_}, ReturnPhase::climb, stage_.stands_on});
    out.push_back({{way_, low_, top_}, ReturnPhase::way, stage_.stands_on});
    add_sinking(out);
    out.push_back({{end_, std::min(ground, low_), top_}, ReturnPhase::descent, ground});
    return out;
  }

 private:
  // The firmware measures its height and its distance when it is told to return, or at the place
  // where it will rest; it may be off the stage by `around`.
  void set_heights() {
    const double ground = place_.ground.z();
    base_ = model_.rally_adds ? ground + place_.above_ground : ground;
    const double full =
        model_.rally_adds ? model_.height : std::max(model_.height, place_.above_ground);
    const double off = model_.around.head<2>().norm();
    nearest_ = std::max(0.0, distance(braking_.plan, target_) - off);
    const double furthest = traj::furthest(braking_.plan, target_) + off;
    const double whole = model_.rally_adds ? full : std::max(model_.height, std::floor(full));
    HeightRange climbs = return_heights(model_, full, nearest_, furthest);
    climbs.least =
        return_heights(model_, whole, nearest_, furthest).least;  // it keeps metres alone
    const double ceiling = model_.ceiling ? ground + *model_.ceiling : kNone;
    const double own = braking_.low + std::max(0.0, model_.least_climb - model_.under);
    low_ = std::max(own, base_ + climbs.least - model_.under);
    low_ = std::max(braking_.low, std::min(low_, ceiling - model_.under));
    top_ = std::max(base_ + climbs.most, braking_.high + model_.least_climb);
    if (model_.keeps_below_ceiling) top_ = std::min(top_, ceiling);
    top_ = std::max(braking_.high, top_);
    if (sinks_to_descend()) low_ = std::min(low_, base_ + model_.cone.descend);
  }

  bool sinks_to_descend() const { return model_.cone.px4_1_11 && nearest_ <= model_.cone.near; }

  // Sinking begins within the radius of the place, from any side from which it may come, and goes
  // on while it comes nearer: a cone, in steps that all reach up. If it is there when it is told to
  // return, it sinks while it slows down, and on its way back.
  void add_sinking(std::vector<ReturnSweep>& out) const {
    const bool at_once = nearest_ <= model_.acceptance;
    const double ground = place_.ground.z();
    const double begin = model_.aslant ? std::min(low_, base_ + model_.cone.descend) : low_;
    const double fall = model_.fall + (at_once ? model_.descent * seconds_back() : 0);
    const double end = std::min(low_, std::max(ground, begin - fall));
    constexpr int kSteps = 3;
    for (int i = 0; i < kSteps; ++i) {
      const double radius = model_.acceptance * (kSteps - i) / kSteps;
      Plan plan = within(way_, target_, radius + overshot(model_));
      plan.insert(plan.end(), end_.begin(), end_.end());
      if (at_once) plan.insert(plan.end(), braking_.plan.begin(), braking_.plan.end());
      const double low = low_ + (end - low_) * (i + 1) / kSteps;
      out.push_back({{plan_hull(std::move(plan)), low, top_}, ReturnPhase::descent, ground});
    }
  }

  // From the order until it is back above its place: to rest, and the way with the usual speed.
  double seconds_back() const {
    double fastest = 0;
    for (const Velocity& v : stage_.velocity) {
      fastest = std::max(fastest, v.value.head<2>().norm());
    }
    const double rest =
        model_.reaction + fastest / model_.deceleration + model_.deceleration / model_.jerk;
    const double faster = model_.speed / model_.deceleration + model_.deceleration / model_.jerk;
    return rest + faster + furthest(braking_.plan, target_) / model_.speed;
  }

  const ReturnModel& model_;
  const FlightStage& stage_;
  const ReturnPlace& place_;
  Vec2 target_;
  Prism braking_;
  Plan end_;  // above its place
  Plan way_;
  double base_ = 0;     // the height above which the firmware counts
  double nearest_ = 0;  // m from its place
  double low_ = 0;      // the least at which it goes across
  double top_ = 0;      // the greatest to which it climbs
};

}  // namespace

Sweep sweep_of(const ReturnSweep& one, const FlightPart& part) {
  return {corners(one.region), part, one.stands_on};
}

Prism braking_region(const ReturnModel& model, const FlightStage& stage) {
  Prism out = prism_around(stage.where);
  const Plan begin = out.plan;
  double fastest = 0;
  for (const Velocity& v : stage.velocity) fastest = std::max(fastest, speed_at(model, v, begin));
  const double factor = braking_factor(model, fastest);
  double latest = 0;
  std::vector<Pace> paces;
  Plan ways = {Vec2::Zero()};  // from any place of the stage
  for (const Velocity& v : stage.velocity) {
    const double speed = speed_at(model, v, begin);
    const double late = stage.legs.empty() ? 0 : lateness(model, v, begin, speed);
    paces.push_back({speed, v.value.z()});
    latest = std::max(latest, late);
    if (speed == 0) continue;
    const Vec2 along = v.value.head<2>().normalized();
    const double whole = speed * (factor + late) + model.stop_length;
    const double way = std::min(whole, way_to_rest(model, v, begin, speed));
    ways.push_back(along * way);
    ways.push_back(-along * (speed * model.overshoot_time));
  }
  out.plan = plan_sum(begin, plan_hull(std::move(ways)));
  const double turned = one_way(stage.velocity) ? 0 : model.stop_length;
  const double beside = fastest > 0 ? model.overshoot + turned + model.sideways * fastest : 0;
  out.plan = widened(out.plan, beside);
  out.low -= vertical_way(model, paces, -1, latest);
  out.high += vertical_way(model, paces, 1, latest);
  if (stage.stands_on)
    out.low = std::max(out.low, std::min(prism_around(stage.where).low, *stage.stands_on));
  return out;
}

std::vector<ReturnSweep> return_sweeps(const ReturnModel& model, const FlightStage& stage,
                                       const ReturnPlace& place) {
  return Return(model, stage, place).sweeps();
}

std::vector<ReturnSweep> holding_sweeps(const ReturnModel& model, const FlightStage& stage) {
  return {{braking_region(model, stage), ReturnPhase::braking, stage.stands_on}};
}

std::vector<ReturnSweep> landing_sweeps(const ReturnModel& model, const FlightStage& stage,
                                        double ground, double floor) {
  ReturnModel lands = model;
  lands.reaction += model.landing_later;
  lands.fading += model.landing_later;
  std::vector<ReturnSweep> out = holding_sweeps(lands, stage);
  const Prism& braking = out.front().region;
  out.push_back(
      {{braking.plan, std::min(floor, braking.low), braking.high}, ReturnPhase::descent, ground});
  return out;
}

double longest_seconds(const ReturnModel& model, std::span<const ReturnSweep> sweeps) {
  double seconds = 0;
  double descent = 0;  // the longest: the others are its beginning
  for (const ReturnSweep& one : sweeps) {
    const double up = one.region.high - one.region.low;
    if (one.phase == ReturnPhase::descent) {
      descent = std::max(descent, up / std::min(kSlowestLanding, model.descent));
    } else if (one.phase == ReturnPhase::way) {
      seconds += furthest(one.region.plan, one.region.plan.front()) / model.speed;
    } else {
      seconds += up / model.climb;
    }
  }
  return 2 * (seconds + descent) + 60;
}

}  // namespace traj
