#include "traj/solve/min_snap.h"

#include <Eigen/Cholesky>
#include <array>
#include <cassert>
#include <vector>

#include "curve/hermite_form.h"

namespace traj {
namespace {

using Mat3 = Eigen::Matrix3d;

enum End { kStart = 0, kEnd = 4 };  // columns of the Hermite tables

// duration^-e for e = 0..6.
std::array<double, 7> inverse_powers(double duration) {
  std::array<double, 7> power;
  power[0] = 1;
  for (std::size_t e = 1; e < power.size(); ++e) power[e] = power[e - 1] / duration;
  return power;
}

// The block of the snap form between (v, a, j) at two ends of a leg.
Mat3 block(const std::array<double, 7>& inverse, End row, End column) {
  Mat3 m;
  for (int q = 1; q <= 3; ++q) {
    for (int r = 1; r <= 3; ++r) {
      m(q - 1, r - 1) = kSnapForm[row + q][column + r] * inverse[7 - q - r];
    }
  }
  return m;
}

// What a step from one end of a leg to the other pulls on (v, a, j): one column an axis. The form
// does not see a common shift, so the step is all that counts, and large coordinates cost nothing.
Mat3 pull(const std::array<double, 7>& inverse, End row, const Vec3& step) {
  Mat3 m;
  for (int q = 1; q <= 3; ++q) {
    m.row(q - 1) = -kSnapForm[row + q][kEnd] * inverse[7 - q] * step.transpose();
  }
  return m;
}

// (v, a, j) at a waypoint in units of time `unit`: what is fixed, and which rows stay free.
struct Joint {
  Mat3 fixed = Mat3::Zero();  // rows v, a, j; columns x, y, z; zero in free rows
  Vec3 free = Vec3::Ones();   // 1 or 0
  bool all_free = true;
};

Joint joint_of(const Waypoint& waypoint, bool stops, double unit) {
  Joint joint;
  const auto fix = [&](int row, const std::optional<Vec3>& value, double scale) {
    if (!stops && !value) return;
    joint.fixed.row(row) = value.value_or(Vec3::Zero()).transpose() * scale;
    joint.free[row] = 0;
    joint.all_free = false;
  };
  fix(0, waypoint.velocity, unit);
  fix(1, waypoint.acceleration, unit * unit);
  fix(2, waypoint.jerk, unit * unit * unit);
  return joint;
}

std::vector<Joint> joints_of(const Legs& legs, double unit) {
  std::vector<Joint> joints;
  const std::size_t n = legs.times.size();
  joints.reserve(n + 1);
  for (std::size_t i = 0; i <= n; ++i) {
    const Waypoint& waypoint = legs.waypoints[i];
    joints.push_back(joint_of(waypoint, i == 0 || i == n || waypoint.hold > 0, unit));
  }
  return joints;
}

// One waypoint of the symmetric block-tridiagonal system. Cholesky needs no pivots and is
// indifferent to the scale of single unknowns, so very unequal legs do no harm.
struct Inner {
  Mat3 to_next;  // the factored diagonal's inverse times the coupling to the next waypoint
  Mat3 value;    // rows v, a, j; columns x, y, z
};

// (v, a, j) at the inner waypoints. What is fixed moves to the right side, and its rows and columns
// become those of the identity, which keeps the system symmetric and definite.
std::vector<Inner> solve_inner(const Legs& legs, const std::vector<Joint>& joints, double unit) {
  const std::size_t n = legs.times.size();
  std::vector<Inner> inner(n - 1);
  const auto step = [&](std::size_t leg) {
    return Vec3(legs.waypoints[leg + 1].position - legs.waypoints[leg].position);
  };
  Mat3 carried = Mat3::Zero();
  Mat3 carried_pull = Mat3::Zero();
  std::array<double, 7> before = inverse_powers(legs.times[0] / unit);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const std::array<double, 7> after = inverse_powers(legs.times[i + 1] / unit);
    const Joint& here = joints[i + 1];
    const Joint& next = joints[i + 2];
    Mat3 own = block(before, kEnd, kEnd) + block(after, kStart, kStart);
    Mat3 to_next = block(after, kStart, kEnd);
    Mat3 right = pull(before, kEnd, step(i)) + pull(after, kStart, step(i + 1));
    if (!joints[i].all_free) right -= block(before, kEnd, kStart) * joints[i].fixed;
    if (!next.all_free) {
      right -= to_next * next.fixed;
      to_next = to_next * next.free.asDiagonal();
    }
    if (!here.all_free) {
      const auto free = here.free.asDiagonal();
      right = free * (right - own * here.fixed) + here.fixed;
      own = free * own * free;
      own.diagonal() += Vec3::Ones() - here.free;
      to_next = free * to_next;
    }
    const Eigen::LLT<Mat3> factor(own - carried);
    inner[i].to_next = factor.solve(to_next);
    inner[i].value = factor.solve(right - carried_pull);
    carried = to_next.transpose() * inner[i].to_next;
    carried_pull = to_next.transpose() * inner[i].value;
    before = after;
  }
  for (std::size_t i = inner.size() - 1; i-- > 0;) {
    inner[i].value -= inner[i].to_next * inner[i + 1].value;
  }
  return inner;
}

State state_of(const Vec3& p, const Mat3& value, double unit) {
  return {p, value.row(0).transpose() / unit, value.row(1).transpose() / (unit * unit),
          value.row(2).transpose() / (unit * unit * unit)};
}

// The states at the waypoints, what is given there bit for bit.
std::vector<State> states_of(const Legs& legs) {
  const std::size_t n = legs.times.size();
  double unit = 0;  // the mean leg: keeps the powers of time in range
  for (const double t : legs.times) unit += t / static_cast<double>(n);
  const std::vector<Joint> joints = joints_of(legs, unit);
  const std::vector<Inner> inner = n > 1 ? solve_inner(legs, joints, unit) : std::vector<Inner>{};
  std::vector<State> states;
  states.reserve(n + 1);
  for (std::size_t i = 0; i <= n; ++i) {
    const Waypoint& waypoint = legs.waypoints[i];
    const bool at_end = i == 0 || i == n;
    State s = state_of(waypoint.position, at_end ? joints[i].fixed : inner[i - 1].value, unit);
    s.velocity = waypoint.velocity.value_or(s.velocity);
    s.acceleration = waypoint.acceleration.value_or(s.acceleration);
    s.jerk = waypoint.jerk.value_or(s.jerk);
    states.push_back(s);
  }
  return states;
}

}  // namespace

std::vector<Waypoint> waypoints_at(std::span<const Vec3> points) {
  std::vector<Waypoint> waypoints;
  waypoints.reserve(points.size());
  for (const Vec3& p : points) waypoints.push_back({.position = p});
  return waypoints;
}

Legs without_repeats(std::span<const Waypoint> waypoints, std::span<const double> times) {
  assert(!waypoints.empty() && times.size() + 1 == waypoints.size());
  Legs legs;
  legs.waypoints.reserve(waypoints.size());
  legs.times.reserve(times.size());
  legs.waypoints.push_back(waypoints[0]);
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    const Waypoint& next = waypoints[i];
    Waypoint& last = legs.waypoints.back();
    if (next.position != last.position) {
      legs.waypoints.push_back(next);
      legs.times.push_back(times[i - 1]);
      continue;
    }
    last.hold += times[i - 1] + next.hold;
    if (!last.velocity) last.velocity = next.velocity;
    if (!last.acceleration) last.acceleration = next.acceleration;
    if (!last.jerk) last.jerk = next.jerk;
  }
  for (Waypoint& w : legs.waypoints) {
    if (w.hold > 0) w = {.position = w.position, .hold = w.hold};
  }
  return legs;
}

Trajectory min_snap(std::span<const Waypoint> waypoints, std::span<const double> times) {
  const Legs legs = without_repeats(waypoints, times);
  const std::size_t n = legs.times.size();
  Trajectory trajectory;
  trajectory.segments.reserve(n);
  const auto rest = [&](const Waypoint& at, double seconds) {
    trajectory.segments.push_back(hermite({at.position}, {at.position}, seconds));
  };
  const std::vector<State> states = n > 0 ? states_of(legs) : std::vector<State>{};
  for (std::size_t i = 0; i <= n; ++i) {
    if (legs.waypoints[i].hold > 0) rest(legs.waypoints[i], legs.waypoints[i].hold);
    if (i < n) trajectory.segments.push_back(hermite(states[i], states[i + 1], legs.times[i]));
  }
  if (trajectory.segments.empty()) rest(legs.waypoints[0], 1);
  return trajectory;
}

Trajectory min_snap(std::span<const Vec3> points, std::span<const double> times) {
  return min_snap(waypoints_at(points), times);
}

}  // namespace traj
