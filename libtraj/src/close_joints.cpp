#include "traj/close_joints.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/error.h"

namespace traj {
namespace {

void require_close(const State& end, const State& begin, double gap, std::size_t segment,
                   double time, std::string_view source) {
  const auto require = [&](double found, double most, const char* what, const char* unit) {
    if (found <= most) return;
    throw geom::InputError(
        source,
        fmt::format("a jump: {} steps by {:.6g} {} where segment {} begins, at t = {:.6g} s; "
                    "expected at most {:.6g}",
                    what, found, unit, segment, time, most));
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
  double time = 0;
  for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
    time += segments[i].duration;
    require_close(ends[i], begins[i + 1], gap, i + 1, time, source);
    closed.largest_gap =
        std::max(closed.largest_gap, (begins[i + 1].position - ends[i].position).norm());
    meet(ends[i], begins[i + 1]);
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    closed.trajectory.segments[i].point = hermite(begins[i], ends[i], segments[i].duration).point;
  }
  return closed;
}

}  // namespace traj
