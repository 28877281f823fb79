#include "refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geom/map/wider_bounds.h"
#include "traj/record/verdict.h"

namespace traj {
namespace {

// What it touched, where that is in the map for a time only.
bool is_timed(const geom::CollisionScene& scene, const CheckResult& result) {
  return result.reason == Reason::collision && result.box &&
         !scene.map().time(*result.box).always();
}

// Where it leaves the bounds: which face, and the map that would do.
std::string or_wider(const geom::CollisionScene& scene, const CheckResult& result) {
  if (result.reason != Reason::bounds) return "";
  geom::WiderBounds wider(scene.map().spec().bounds);
  wider.add(result.place, scene.half(), result.worst);
  return fmt::format("; that is {}: {}", wider.in_words(), wider.advice());
}

// What to do about it.
std::string remedy(const geom::CollisionScene& scene, const MissionTask& task,
                   const CheckResult& result) {
  if (is_timed(scene, result)) {
    return "that obstacle is there for a time only, and counts as always there for what is "
           "exported: prove the flight by time on this map (skyway-check), then export it with the "
           "map as it was before boxes with times were added, and depart at its start";
  }
  const bool near = result.reason == Reason::collision || result.reason == Reason::bounds;
  const bool limit =
      std::any_of(kLimitKinds.begin(), kLimitKinds.end(),
                  [&](const LimitKind& kind) { return result.reason == broken(kind.limit); });
  if (task.format->remedy) {
    const std::string own = task.format->remedy(task, result);
    if (!own.empty()) return own;
  }
  if (near && !result.strayed.empty()) {
    return fmt::format(
               "make the path anew with {:g} m more margin (skyway-plan --margin), or fly slower "
               "(--speed)",
               std::ceil(100 * result.worst) / 100) +
           or_wider(scene, result);
  }
  if (near) {
    const double spare = std::ceil(100 * result.worst) / 100;  // in whole centimetres
    return "make the path anew with more room (skyway-plan --margin)" +
           (spare <= scene.margin()
                ? fmt::format(", or ask for {:g} m less than its margin (--spare {:g})", spare,
                              spare)
                : "") +
           or_wider(scene, result);
  }
  if (limit && task.format->has_legs) return "fly slower (--speed)";
  if (limit) return "solve it again with stricter limits (skyway-traj)";
  if (result.reason == Reason::takeoff) {
    return "begin the path higher, or say where the ground is (--ground)";
  }
  if (result.reason == Reason::takeoff_ground) {
    return "say where the ground is (--ground), or put the ground into the map (skyway-map join)";
  }
  if (result.reason == Reason::landing) {
    return "end the path over level ground, or end the mission hovering (--hover)";
  }
  if (result.reason == Reason::ceiling) return "plan a lower path";
  if (result.reason == Reason::range || result.reason == Reason::endurance) {
    return "cut the flight into shorter ones";
  }
  return "";
}

}  // namespace

std::string refusal(const geom::CollisionScene& scene, const MissionTask& task,
                    const CheckResult& result) {
  const std::string advice = remedy(scene, task, result);
  const std::string when = task.format->has_legs
                               ? fmt::format("on leg {:.0f}", std::floor(result.time))
                               : fmt::format("at t = {:.3f} s", result.time);
  const std::string how = result.strayed.empty() ? "as the file says"
                          : result.part ? "by " + result.strayed + ", which may stray from its way"
                                        : "with what is allowed for " + result.strayed;
  return fmt::format("flown {}, {}; {}, near [{:.3f}, {:.3f}, {:.3f}]{}{}", how,
                     fault_in_words(result, scene.map(), {task.limits, scene.half()}), when,
                     result.place[0], result.place[1], result.place[2], advice.empty() ? "" : ": ",
                     advice);
}

}  // namespace traj
