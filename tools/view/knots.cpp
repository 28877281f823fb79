#include "knots.h"

namespace view {
namespace {

using traj::State;

// What single precision keeps apart, about: metres, and metres over seconds, squared and cubed.
bool meet(const State& a, const State& b) {
  return (a.position - b.position).norm() < 1e-5 && (a.velocity - b.velocity).norm() < 1e-4 &&
         (a.acceleration - b.acceleration).norm() < 1e-3 && (a.jerk - b.jerk).norm() < 1e-2;
}

std::vector<Knot> at_joints(const traj::Trajectory& trajectory) {
  std::vector<Knot> knots;
  for (const traj::Segment& segment : trajectory.segments) {
    const State begin = evaluate(segment, 0);
    if (knots.empty() || !meet(knots.back().state, begin)) knots.push_back({0, begin});
    knots.push_back({segment.duration, evaluate(segment, segment.duration)});
  }
  return knots;
}

}  // namespace

std::vector<Knot> knots_of(const traj::Trajectory& trajectory, std::size_t most) {
  std::vector<Knot> knots = at_joints(trajectory);
  if (knots.size() <= most) return knots;
  const double step = duration(trajectory) / static_cast<double>(most - 1);
  knots.clear();
  for (std::size_t i = 0; i < most; ++i) {
    knots.push_back({i ? step : 0, evaluate(trajectory, step * static_cast<double>(i))});
  }
  return knots;
}

void add_knots(Json& out, const std::vector<Knot>& knots, const LocalFrame& frame, Bundle& bundle) {
  std::vector<float> step, position, velocity, acceleration, jerk;
  for (const Knot& knot : knots) {
    step.push_back(static_cast<float>(knot.step));
    append(position, frame.at(knot.state.position));
    append(velocity, geom::to_enu(frame.axes, knot.state.velocity));
    append(acceleration, geom::to_enu(frame.axes, knot.state.acceleration));
    append(jerk, geom::to_enu(frame.axes, knot.state.jerk));
  }
  const auto added = [&](const std::vector<float>& v) {
    return bundle.add(std::span<const float>(v));
  };
  out["knots"] = knots.size();
  out["step"] = added(step);
  out["position"] = added(position);
  out["velocity"] = added(velocity);
  out["acceleration"] = added(acceleration);
  out["jerk"] = added(jerk);
}

}  // namespace view
