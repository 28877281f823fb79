#include "traj/solve/close_joints.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geom/base/error.h"

namespace traj {
namespace {

// Where segments meet.
struct Joint {
  std::size_t segment;  // that begins
  double time;
  double gap;  // by which they may miss each other
  std::string_view source;
};

void require_close(const State& end, const State& begin, const Joint& joint) {
  const auto& [segment, time, gap, source] = joint;
  const auto require = [&](double found, double most, const char* what, const char* unit) {
    if (found <= most) return;
    throw geom::InputError(source,
                           {.says = fmt::format("a jump: {} steps by {:.6g} {} where segment {} "
                                                "begins, at t = {:.6g} s; expected at most {:.6g}",
                                                what, found, unit, segment, time, most)});
  };
  require((begin.position - end.position).norm(), gap, "position", "m");
  require((begin.velocity - end.velocity).norm(), 10 * gap, "velocity", "m/s");
  require((begin.acceleration - end.acceleration).norm(), 100 * gap, "acceleration", "m/s2");
}

void meet(State& end, State& begin) {
  const auto mean = [](Vec3& a, Vec3& b) { a = b = 0.5 * (a + b); };
  mean(end.position, begin.position);
  mean(end.velocity, begin.velocity);
  mean(end.acceleration, begin.acceleration);
}

// Later yaws, by whole turns, as near to the earlier as they come.
void unwrap(Trajectory& trajectory) {
  for (std::size_t i = 1; i < trajectory.segments.size(); ++i) {
    const auto& before = trajectory.segments[i - 1].yaw;
    auto& after = trajectory.segments[i].yaw;
    if (!before || !after) continue;
    constexpr double kTurn = 2 * std::numbers::pi;
    const double turns = std::round((after->front() - before->back()) / kTurn) * kTurn;
    if (turns == 0) continue;
    for (double& yaw : *after) yaw -= turns;
  }
}

// Makes yaw and its rate meet.
void close_yaw(Segment& before, Segment& after, const Joint& joint) {
  const auto& [segment, time, gap, source] = joint;
  if (!before.yaw || !after.yaw) return;
  auto& a = *before.yaw;
  auto& b = *after.yaw;
  const double a_rate = kDegree * (a[7] - a[6]) / before.duration;
  const double b_rate = kDegree * (b[1] - b[0]) / after.duration;
  const double step = std::max(std::abs(b[0] - a[7]), 0.1 * std::abs(b_rate - a_rate));
  if (step > gap) {
    throw geom::InputError(
        source, {.says = fmt::format(
                     "a jump: yaw steps by {:.6g} rad, its rate by {:.6g} rad/s where segment {} "
                     "begins, at t = {:.6g} s; expected at most {:.6g} and {:.6g}",
                     b[0] - a[7], b_rate - a_rate, segment, time, gap, 10 * gap)});
  }
  const double rate = 0.5 * (a_rate + b_rate);
  a[7] = b[0] = 0.5 * (a[7] + b[0]);
  a[6] = a[7] - rate * before.duration / kDegree;
  b[1] = b[0] + rate * after.duration / kDegree;
}

}  // namespace

ClosedJoints close_joints(const Trajectory& trajectory, double gap, std::string_view source) {
  const auto& segments = trajectory.segments;
  std::vector<State> begins;
  std::vector<State> ends;
  for (const Segment& s : segments) {
    begins.push_back(evaluate(s, 0));
    ends.push_back(evaluate(s, s.duration));
  }
  ClosedJoints closed{trajectory, 0};
  unwrap(closed.trajectory);
  double time = 0;
  for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
    time += segments[i].duration;
    const Joint joint{i + 1, time, gap, source};
    require_close(ends[i], begins[i + 1], joint);
    closed.largest_gap =
        std::max(closed.largest_gap, (begins[i + 1].position - ends[i].position).norm());
    meet(ends[i], begins[i + 1]);
    close_yaw(closed.trajectory.segments[i], closed.trajectory.segments[i + 1], joint);
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    closed.trajectory.segments[i].point = hermite(begins[i], ends[i], segments[i].duration).point;
  }
  return closed;
}

}  // namespace traj
