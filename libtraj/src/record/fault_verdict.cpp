#include "fault_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geom/vehicle/shown_limit.h"
#include "record/return_verdict.h"
#include "traj/proof/domain.h"
#include "traj/record/verdict.h"

namespace traj {
namespace {

// The side of the bounds that a vehicle of such half sizes is furthest beyond.
std::string side(const geom::BoxMap& map, const Vec3& place, const Vec3& half) {
  const geom::Aabb& bounds = map.spec().bounds;
  constexpr std::string_view kLow[] = {"lower x", "lower y", "floor"};
  constexpr std::string_view kHigh[] = {"upper x", "upper y", "ceiling"};
  std::string out;
  double furthest = -INFINITY;
  for (int axis = 0; axis < 3; ++axis) {
    const auto take = [&](double beyond, std::string_view name, double at) {
      if (!(beyond > furthest)) return;
      furthest = beyond;
      out = fmt::format("{} of {:.6g} m", name, at);
    };
    take(bounds.min[axis] - place[axis] + half[axis], kLow[axis], bounds.min[axis]);
    take(place[axis] + half[axis] - bounds.max[axis], kHigh[axis], bounds.max[axis]);
  }
  return out;
}

// "8.765 m/s", with as many digits as tell it from its limit.
std::string shown_beside(const LimitKind& kind, double value, const std::optional<double>& limit) {
  const double in_unit = value / kind.in_unit;
  const std::string text = fmt::format("{:.4g}", in_unit);
  const bool same = limit && text == fmt::format("{:.4g}", *limit / kind.in_unit);
  return fmt::format("{} {}", same ? fmt::format("{:.12g}", in_unit) : text, kind.unit);
}

std::string limit_fault(const LimitKind& kind, const CheckResult& result, const Limits& limits) {
  const auto& held = limits[kind.limit];
  return fmt::format("the {} is {}, above its limit{}", spoken(kind.quantity),
                     shown_beside(kind, result.worst, held),
                     held ? " of " + geom::shown(kind, *held) : "");
}

// `high`: metres above what the map has there.
std::string takeoff_ground_fault(double high) {
  return high > 0 ? fmt::format("the take-off is in the air, {:.3g} m above what the map has there",
                                high)
                  : fmt::format("the take-off is {:.3g} m below the map", -high);
}

std::string landing_fault(double worst) {
  if (worst == 0) return "the vehicle lands on an edge, not on level ground";
  return fmt::format("the vehicle lands on ground {:.3g} m {} than the file says", std::abs(worst),
                     worst > 0 ? "lower" : "higher");
}

// What is wrong with numbers that no check can judge.
std::string domain_fault(const CheckResult& result) {
  switch (result.reason) {
    case Reason::duration:
      return fmt::format("a segment lasts {:g} s; expected from {:g} s to {:g} s for all together",
                         result.worst, kShortestSegment, kLongestTrajectory);
    case Reason::coordinates:
      return fmt::format("a coordinate is {:g}; expected at most {:g} m", result.worst,
                         geom::kLargestCoordinate);
    case Reason::limits:
      return fmt::format(
          "a limit is {:g}; expected from {:g} to {:g}, a tilt below 90 degrees, and a thrust "
          "above "
          "{:g} m/s2",
          result.worst, kLeastLimit, kLargestLimit, kGravity);
    default:
      return "the vehicle's half sizes or margin are no lengths that can be judged";
  }
}

std::string claim_fault(double worst) {
  if (worst == 0) return "the record claims a bound on its length or duration that cannot be";
  return fmt::format(
      "the record claims that nothing is shorter than {:.6g}, and it is shorter itself", worst);
}

}  // namespace

std::string spoken(std::string_view quantity) {
  std::string out(quantity);
  std::replace(out.begin(), out.end(), '_', ' ');
  return out;
}

HeldTo held_of(const geom::Provenance& provenance, const Limits& limits) {
  if (!provenance.vehicle) return {limits};
  const double margin = provenance.margin.value_or(0);
  return {limits, provenance.vehicle->half + Vec3::Constant(margin)};
}

std::string fault_in_words(const CheckResult& result, const geom::BoxMap& map, const HeldTo& held) {
  for (const LimitKind& kind : kLimitKinds) {
    if (result.reason == broken(kind.limit)) return limit_fault(kind, result, held.limits);
    if (result.reason == unmeasured(kind.limit)) {
      return fmt::format("the {} is unknown, and it has a limit", spoken(kind.quantity));
    }
  }
  const double worst = result.worst;
  switch (result.reason) {
    case Reason::none:
      return "nothing is refused";
    case Reason::no_path:
      return "there is no path to fly";
    case Reason::infeasible:
      return "there is no trajectory: none was found that keeps clear and inside the limits";
    case Reason::stopped:
      return "there is no trajectory: the solver was stopped";
    case Reason::discontinuous:
      return fmt::format(
          "two segments do not meet: their step in position, velocity, acceleration or yaw is "
          "{:.3g}",
          worst);
    case Reason::bounds:
      return fmt::format("the vehicle leaves the map's bounds{} ({})",
                         worst > 0 ? fmt::format(" by {:.3g} m", worst) : "",
                         side(map, result.place, held.half));
    case Reason::collision:
      return worst > 0 ? fmt::format("the vehicle reaches {:.3g} m into {}", worst,
                                     obstacle_in_words(map, result.box))
                       : "the vehicle touches " + obstacle_in_words(map, result.box);
    case Reason::undecided:
      return "it could not be shown that the way is clear";
    case Reason::takeoff:
      return fmt::format("the vehicle begins {:.3g} m above the ground that it takes off from",
                         worst);
    case Reason::takeoff_ground:
      return takeoff_ground_fault(worst);
    case Reason::landing:
      return landing_fault(worst);
    case Reason::ceiling:
      return fmt::format("the vehicle is {:.3g} m high, above its ceiling", worst);
    case Reason::range:
      return fmt::format("the vehicle is {:.3g} m from home, out of its range", worst);
    case Reason::endurance:
      return fmt::format("the vehicle flies for {:.4g} s, longer than it can", worst);
    case Reason::return_home:
      return worst == 0 ? "the height of the return to home is not known"
                        : fmt::format("a rally point's ground is {:.3g} m {} than home's",
                                      std::abs(worst), worst > 0 ? "higher" : "lower");
    case Reason::end:
      return fmt::format("the vehicle ends {:.3g} m from the end of the trajectory", worst);
    case Reason::fence:
      return worst > 0 ? fmt::format("the vehicle leaves the fence by {:.3g} m", worst)
                       : "the vehicle touches the fence";
    case Reason::duration_bound:
      return claim_fault(worst);
    default:
      return domain_fault(result);
  }
}

}  // namespace traj
