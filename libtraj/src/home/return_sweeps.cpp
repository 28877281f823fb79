#include "traj/home/return_sweeps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace traj {
namespace {

using Plan = std::vector<Vec2>;

constexpr double kVerticalBraking = 2.5;  // m/s2, less than autopilots brake with
constexpr double kSteepestSure = 2;       // of a cone: PX4 keeps to it near the place
constexpr double kRoomAtRest = 0.3;       // m beside a rest by which it may be off
constexpr double kSlowestLanding = 0.3;   // m/s, of both firmwares near the ground

// All points within `by` metres of those along each axis.
Plan widened(const Plan& plan, double by) {
  if (by == 0) return plan;
  Plan out;
  for (const Vec2& p : plan) {
    for (const Vec2& corner : {Vec2(by, by), Vec2(-by, by), Vec2(-by, -by), Vec2(by, -by)}) {
      out.push_back(p + corner);
    }
  }
  return plan_hull(std::move(out));
}

Plan hull_of_both(Plan a, const Plan& b) {
  a.insert(a.end(), b.begin(), b.end());
  return plan_hull(std::move(a));
}

// m that it still rises or sinks.
double vertical_way(const ReturnModel& model, double rate) {
  return rate * model.reaction + rate * rate / (2 * kVerticalBraking) +
         rate * kVerticalBraking / (2 * model.jerk);
}

// The most that it is fast across, m/s, in a region of this plan: what it reaches since its rest,
// and from what it can slow down to its next.
double speed_at(const ReturnModel& model, const Velocity& velocity, const Plan& plan) {
  double speed = velocity.value.head<2>().norm();
  for (const std::optional<Vec3>& rest : {velocity.since, velocity.until}) {
    if (!rest) continue;
    const double away = furthest(plan, rest->head<2>()) + kRoomAtRest;
    speed = std::min(speed, std::sqrt(2 * model.deceleration * away));
  }
  return speed;
}

// The most that it goes on, m, until it rests: it slows down to rest where it is to rest anyway.
double way_to_rest(const ReturnModel& model, const Velocity& velocity, const Plan& plan,
                   double speed) {
  if (!velocity.until) return std::numeric_limits<double>::infinity();
  const double left = furthest(plan, velocity.until->head<2>());
  return left + speed * (model.reaction + model.overshoot_time);
}

double overshot(const ReturnModel& model) {
  return model.overshoot_time * model.speed + model.overshoot;
}

// The return of one stage to one place.
class Return {
 public:
  Return(const ReturnModel& model, const FlightStage& stage, const ReturnPlace& place)
      : model_(model),
        stage_(stage),
        place_(place),
        target_(place.ground.head<2>()),
        braking_(braking_region(model, stage)) {
    const double height = model.rally_adds || place.above_ground == 0
                              ? place.ground.z() + place.above_ground + model.height
                              : place.ground.z() + std::max(model.height, place.above_ground);
    top_low_ = std::max(height, braking_.low + model.least_climb);
    top_high_ = std::max(height, braking_.high + model.least_climb);
    low_ = lowest(height);
  }

  std::vector<ReturnSweep> sweeps() const {
    std::vector<ReturnSweep> out{{braking_, ReturnPhase::braking, stage_.stands_on}};
    out.push_back({{braking_.plan, braking_.low, top_high_}, ReturnPhase::climb, stage_.stands_on});
    const Plan end = widened({target_}, overshot(model_));
    out.push_back(
        {{hull_of_both(braking_.plan, end), low_, top_high_}, ReturnPhase::way, stage_.stands_on});
    out.push_back({sinking(), ReturnPhase::descent, place_.ground.z()});
    out.push_back({{end, std::min(place_.ground.z(), low_), top_high_},
                   ReturnPhase::descent,
                   place_.ground.z()});
    return out;
  }

 private:
  // The lowest that it may go across: at the return's height, or in the cone at what that is there;
  // and as far below as it counts as there.
  double lowest(double height) const {
    const double away = distance(braking_.plan, target_);
    double low = top_low_;
    if (model_.low_within > 0 && away < model_.low_within) low = braking_.low;
    if (model_.slope > 0) {
      const double cone = place_.ground.z() + std::min(model_.slope, kSteepestSure) * away;
      low = std::min(low, std::max(braking_.low, std::min(height, cone)));
    }
    return std::max(low - model_.under, braking_.low);
  }

  // Sinking begins within the radius of the place, from any side from which it may come, and goes
  // on while it comes nearer.
  Prism sinking() const {
    const double side = overshot(model_);
    Plan plan = widened({target_}, side);
    for (const Vec2& from : braking_.plan) {
      const Vec2 way = from - target_;
      const double length = way.norm();
      const double share = length > model_.acceptance ? model_.acceptance / length : 1;
      const Plan begin = widened({target_ + share * way}, side);
      plan.insert(plan.end(), begin.begin(), begin.end());
    }
    const double ground = place_.ground.z();
    return {plan_hull(std::move(plan)), std::min(low_, std::max(ground, low_ - model_.fall)),
            top_high_};
  }

  const ReturnModel& model_;
  const FlightStage& stage_;
  const ReturnPlace& place_;
  Vec2 target_;
  Prism braking_;
  double top_low_ = 0;   // the least height to which it climbs
  double top_high_ = 0;  // and the greatest
  double low_ = 0;       // the least at which it goes across
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
  double rise = 0;
  double sink = 0;
  for (const Velocity& v : stage.velocity) {
    rise = std::max(rise, v.value.z());
    sink = std::max(sink, -v.value.z());
    const double speed = speed_at(model, v, begin);
    if (speed == 0) continue;
    const Vec2 along = v.value.head<2>().normalized();
    const double way = std::min(speed * factor, way_to_rest(model, v, begin, speed));
    for (const Vec2& p : begin) {
      out.plan.push_back(p + along * way);
      out.plan.push_back(p - along * (speed * model.overshoot_time));
    }
  }
  out.plan = widened(plan_hull(std::move(out.plan)), fastest > 0 ? model.overshoot : 0);
  out.low -= vertical_way(model, sink);
  out.high += vertical_way(model, rise);
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
  std::vector<ReturnSweep> out = holding_sweeps(model, stage);
  const Prism& braking = out.front().region;
  out.push_back(
      {{braking.plan, std::min(floor, braking.low), braking.high}, ReturnPhase::descent, ground});
  return out;
}

double longest_seconds(const ReturnModel& model, std::span<const ReturnSweep> sweeps) {
  double seconds = 0;
  for (const ReturnSweep& one : sweeps) {
    const double up = one.region.high - one.region.low;
    const bool sinks = one.phase == ReturnPhase::descent;
    const double across = furthest(one.region.plan, one.region.plan.front());
    const double vertical = up / (sinks ? std::min(kSlowestLanding, model.descent) : model.climb);
    const double level = one.phase == ReturnPhase::way ? across / model.speed : 0;
    seconds += one.phase == ReturnPhase::way ? level : vertical;
  }
  return 2 * seconds + 60;
}

}  // namespace traj
