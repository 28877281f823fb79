#pragma once

// Trajectories: positions (and yaw) over time as degree-7 polynomials in Bernstein form.
//
// Example:
//   const traj::State end{.position = {4, 0, 0}};
//   const traj::Trajectory hop{{traj::hermite(traj::State{}, end, 2)}};  // from rest to rest
//   assert(traj::duration(hop) == 2);
//   const traj::State middle = traj::evaluate(hop, 1);
//   assert(std::abs(middle.position.x() - 2) < 1e-12);

#include <array>
#include <optional>
#include <vector>

#include "geom/base/vec3.h"

namespace traj {

using geom::Vec3;

inline constexpr int kDegree = 7;
inline constexpr int kPoints = kDegree + 1;

// One polynomial on [0, duration]: sum over i of point[i] B(7, i)(t / duration).
struct Segment {
  double duration = 0;                             // seconds, > 0
  std::array<Vec3, kPoints> point{};               // Bernstein control points, metres
  std::optional<std::array<double, kPoints>> yaw;  // radians, unwrapped
};

struct Trajectory {
  std::vector<Segment> segments;
};

struct State {
  Vec3 position = Vec3::Zero();      // m
  Vec3 velocity = Vec3::Zero();      // m/s
  Vec3 acceleration = Vec3::Zero();  // m/s2
  Vec3 jerk = Vec3::Zero();          // m/s3
};

double duration(const Trajectory& trajectory);  // seconds

// The state `t` seconds into the segment, 0 <= t <= duration.
State evaluate(const Segment& segment, double t);

// The state at time t, clamped to [0, duration]. At a joint: the later segment. The trajectory
// has at least one segment. O(number of segments).
State evaluate(const Trajectory& trajectory, double t);

// The segment with these states at its ends and this duration: the one degree-7 polynomial.
Segment hermite(const State& from, const State& to, double duration);

}  // namespace traj
