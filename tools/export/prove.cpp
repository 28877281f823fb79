#include "prove.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geom/base/error.h"
#include "geom/record/made_for_another.h"
#include "traj/curve/to_enu.h"
#include "traj/drone_file/straight_legs.h"
#include "traj/proof/flown.h"

namespace exporting {
namespace {

constexpr int kAttempts = 10;     // of tolerances, halved each time
constexpr double kEndGap = 0.02;  // m: how well straight legs must meet the ends

// m: more than centimetres and 1e-7 degrees round a point by, and what vehicles make of those
// degrees.
double rounding_of(const std::string& format) {
  const bool mission = format == "wpl" || format == "qgc-plan" || format == "dji-wpml";
  return mission ? 0.03 : 0.012;
}

// What the bytes make the drone fly, judged.
traj::CheckResult judge(const geom::CollisionScene& scene, const Task& task,
                        const Written& written) {
  const geom::Frame& frame = scene.map().spec().frame;
  cli::DroneFileOptions reading = written.reading;
  reading.autopilot = task.autopilot;
  const auto read = cli::read_drone_file(written.text, "what was written", reading, frame);
  if (read.size() != 1) throw geom::InputError("what was written", "expected one flight");
  const traj::Flown& flown = read.front().flown;
  traj::CheckResult result =
      traj::check_flown(scene, flown, task.limits, traj::Clearance::left_out);
  if (!result.ok || flown.path.empty()) return result;
  const geom::Vec3 end = geom::to_enu(frame.axes, task.enu.segments.back().point[traj::kDegree]);
  const double missed = (flown.path.back() - end).norm();
  if (missed <= kEndGap) return result;
  result.ok = false;
  result.reason = traj::Reason::end;
  result.time = static_cast<double>(flown.path.size() - 1);
  result.place = flown.path.back();
  result.worst = missed;
  return result;
}

geom::Polyline pushed_legs(const geom::CollisionScene& scene, const Task& task,
                           const geom::Polyline& legs, double distance) {
  return traj::to_enu(task.frame.axes,
                      traj::pushed_off(scene, traj::to_enu(task.frame.axes, legs), distance));
}

using Proved = std::pair<Written, traj::CheckResult>;

// Turns without a stop that would be refused are made shorter, or stops.
Proved judge_dji(const geom::CollisionScene& scene, Task task, const geom::Polyline& legs) {
  std::vector<double>& turns = task.dji.turns;
  if (task.turns) turns.assign(legs.size(), *task.turns);
  while (true) {
    Written written = exporting::write(task, legs);
    const traj::CheckResult result = judge(scene, task, written);
    const bool turn = result.part && result.part->manoeuvre == traj::Manoeuvre::corner;
    if (result.ok || !turn || result.part->item >= turns.size() || turns[result.part->item] == 0) {
      return {std::move(written), result};
    }
    double& most = turns[result.part->item];
    most = most > 2 * traj::kDjiLeastTurn ? most / 2 : 0;
  }
}

// What a mission that was refused changes: a waypoint that is passed becomes a rest; before a stop
// that is overshot too far, the vehicle slows down. False where neither would help.
bool change_mission(const Written& written, const traj::CheckResult& result, Task& task) {
  using traj::Manoeuvre;
  constexpr double kSlowest = 1;  // m/s
  if (!result.part || result.part->item < 1 || result.part->item > written.points.size()) {
    return false;
  }
  const std::size_t point = written.points[result.part->item - 1];
  const Manoeuvre manoeuvre = result.part->manoeuvre;
  if (manoeuvre == Manoeuvre::corner && task.passed[point]) {
    task.passed[point] = false;
    return true;
  }
  const bool overshoots = manoeuvre == Manoeuvre::overshoot || manoeuvre == Manoeuvre::landing;
  const double usual = exporting::mission_speed(task).value_or(0);
  double& speed = task.approach[point];
  if (!overshoots || result.strayed.empty() || usual <= kSlowest || speed == kSlowest) return false;
  speed = std::max(kSlowest, (speed > 0 ? speed : std::min(usual, 8.0)) / 2);
  return true;
}

// At first no waypoint is a rest, but where the path has so many that trying each would take long.
Proved judge_mission(const geom::CollisionScene& scene, Task task, const geom::Polyline& legs) {
  constexpr std::size_t kMostTried = 200;
  task.passed.assign(legs.size(), legs.size() <= kMostTried);
  task.approach.assign(legs.size(), 0);
  while (true) {
    Written written = exporting::write(task, legs);
    const traj::CheckResult result = judge(scene, task, written);
    if (result.ok || !change_mission(written, result, task)) return {std::move(written), result};
  }
}

// Writes the legs, and judges what was written.
Proved write_and_judge(const geom::CollisionScene& scene, const Task& task,
                       const geom::Polyline& legs) {
  if (task.format == "dji-wpml") return judge_dji(scene, task, legs);
  if (task.format == "wpl" || task.format == "qgc-plan") return judge_mission(scene, task, legs);
  Written written = exporting::write(task, legs);
  const traj::CheckResult result = judge(scene, task, written);
  return {std::move(written), result};
}

}  // namespace

std::pair<Written, traj::CheckResult> write_proved(const geom::CollisionScene& scene,
                                                   const Task& task) {
  std::pair<Written, traj::CheckResult> made;
  const auto attempt = [&](const geom::Polyline& legs) {
    made = write_and_judge(scene, task, legs);
    const traj::Reason reason = made.second.reason;
    return reason != traj::Reason::collision && reason != traj::Reason::bounds &&
           reason != traj::Reason::end;
  };
  if (!exporting::has_legs(task.format)) {
    attempt({});
    return made;
  }
  const double rounding = rounding_of(task.format);
  if (!task.path.empty()) {
    if (attempt(task.path)) return made;
    for (double off = rounding; off <= task.tolerance; off *= 2) {
      if (attempt(pushed_legs(scene, task, task.path, off))) break;
    }
    return made;
  }
  double tolerance = task.tolerance;
  for (int i = 0; i < kAttempts; ++i, tolerance /= 2) {
    const geom::Polyline legs = traj::straight_legs(task.enu, tolerance);
    if (attempt(legs)) break;
    if (attempt(pushed_legs(scene, task, legs, tolerance + rounding))) break;
  }
  return made;
}

std::string in_words(std::string_view quantity) {
  std::string out(quantity);
  std::replace(out.begin(), out.end(), '_', ' ');
  return out;
}

namespace {

// What would go wrong, after "flown as the file says, " or its like.
std::string fault(const traj::CheckResult& result) {
  using traj::Reason;
  for (const traj::LimitKind& kind : traj::kLimitKinds) {
    const std::string quantity = in_words(kind.quantity);
    if (result.reason == traj::broken(kind.limit)) {
      return fmt::format("the {} would be {}, above its limit", quantity,
                         geom::in_words(kind, result.worst));
    }
    if (result.reason == traj::unmeasured(kind.limit)) {
      return fmt::format("the {} would be unknown, and it has a limit", quantity);
    }
  }
  switch (result.reason) {
    case Reason::collision:
      return fmt::format("the vehicle would touch an obstacle, {:.3g} m deep", result.worst);
    case Reason::bounds:
      return fmt::format("the vehicle would leave the bounds by {:.3g} m", result.worst);
    case Reason::takeoff:
      return fmt::format("the vehicle would begin only {:.3g} m above the ground", result.worst);
    case Reason::landing:
      return result.worst == 0
                 ? "the vehicle would land on an edge, not on level ground"
                 : fmt::format("the vehicle would land on ground {:.3g} m {} than the file says",
                               std::abs(result.worst), result.worst > 0 ? "lower" : "higher");
    case Reason::ceiling:
      return fmt::format("the vehicle would be {:.3g} m high, above its ceiling", result.worst);
    case Reason::range:
      return fmt::format("the vehicle would be {:.3g} m from home, out of its range", result.worst);
    case Reason::endurance:
      return fmt::format("the vehicle would fly for {:.4g} s, longer than it can", result.worst);
    case Reason::end:
      return fmt::format("the vehicle would end {:.3g} m from the end of the trajectory",
                         result.worst);
    default:
      return fmt::format("the check would say \"{}\" ({:.3g})", name(result.reason), result.worst);
  }
}

constexpr double kHighestRate = 10000;  // Hz, of --rate

// What it touched, where that is in the map for a time only.
bool is_timed(const geom::CollisionScene& scene, const traj::CheckResult& result) {
  return result.reason == traj::Reason::collision && result.box &&
         !scene.map().time(*result.box).always();
}

// What to do about it.
std::string remedy(const geom::CollisionScene& scene, const Task& task,
                   const traj::CheckResult& result) {
  using traj::Reason;
  if (is_timed(scene, result)) {
    return "that obstacle is there for a time only, and counts as always there for what is "
           "exported: prove the flight by time on this map (skyway-check), then export it with the "
           "map as it was before boxes with times were added, and depart at its start";
  }
  const bool near = result.reason == Reason::collision || result.reason == Reason::bounds;
  const bool setpoints = task.format == "setpoints";
  const bool limit = std::any_of(
      traj::kLimitKinds.begin(), traj::kLimitKinds.end(),
      [&](const traj::LimitKind& kind) { return result.reason == traj::broken(kind.limit); });
  if (setpoints && (near || limit) && task.rate < kHighestRate) {
    return fmt::format("write more setpoints a second (--rate {:g})",
                       std::min(4 * task.rate, kHighestRate));
  }
  if (near && !result.strayed.empty()) {
    return fmt::format(
        "make the path anew with {:g} m more margin (skyway-plan --margin), or fly slower "
        "(--speed)",
        std::ceil(100 * result.worst) / 100);
  }
  if (near) {
    const double spare = std::ceil(100 * result.worst) / 100;  // in whole centimetres
    return "make the path anew with more room (skyway-plan --margin)" +
           (spare <= scene.margin()
                ? fmt::format(", or ask for {:g} m less than its margin (--spare {:g})", spare,
                              spare)
                : "");
  }
  if (limit && exporting::has_legs(task.format)) return "fly slower (--speed)";
  if (limit) return "solve it again with stricter limits (skyway-traj)";
  if (result.reason == Reason::takeoff) {
    return task.format == "tello" ? "take off higher (--takeoff-height)"
                                  : "begin the path higher, or say where the ground is (--ground)";
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

std::string refusal(const geom::CollisionScene& scene, const Task& task,
                    const traj::CheckResult& result) {
  const std::string advice = remedy(scene, task, result);
  const std::string when = exporting::has_legs(task.format)
                               ? fmt::format("on leg {:.0f}", std::floor(result.time))
                               : fmt::format("at t = {:.3f} s", result.time);
  const std::string how = result.strayed.empty() ? "as the file says"
                          : result.part ? "by " + result.strayed + ", which may stray from its way"
                                        : "with what is allowed for " + result.strayed;
  return fmt::format("{}: refused: flown {}, {}; {}, near [{:.3f}, {:.3f}, {:.3f}]{}{}", task.id,
                     how, fault(result), when, result.place[0], result.place[1], result.place[2],
                     advice.empty() ? "" : ": ", advice);
}

}  // namespace exporting
