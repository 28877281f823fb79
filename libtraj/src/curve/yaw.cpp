#include "traj/curve/yaw.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "halves.h"
#include "portable_math.h"

namespace traj {
namespace {

constexpr double kSlow = 0.1;            // m/s
constexpr double kClose = 0.1;           // metres
constexpr double kSteepest = 35.0 / 16;  // of a smoothstep of degree 7, over its mean
constexpr double kSlack = 0.999;         // for what the bound of a smoothstep is above its peak

// The direction across the ground, unless it is shorter than that.
std::optional<double> direction(const Vec3& v, double shortest) {
  if (v.x() * v.x() + v.y() * v.y() < shortest * shortest) return std::nullopt;
  return angle_of(v.x(), v.y());
}

// `ahead` is the way to the next joint.
std::optional<double> wanted(const YawOptions& options, const State& state, const Vec3& ahead) {
  switch (options.kind) {
    case YawOptions::Kind::fixed:
      return options.angle;
    case YawOptions::Kind::towards:
      return direction(options.target - state.position, kClose);
    default:
      const auto moving = direction(state.velocity, kSlow);
      return moving ? moving : direction(ahead, kClose);
  }
}

std::vector<State> joint_states(const Trajectory& trajectory) {
  std::vector<State> out;
  for (const Segment& s : trajectory.segments) out.push_back(evaluate(s, 0));
  out.push_back(evaluate(trajectory.segments.back(), trajectory.segments.back().duration));
  return out;
}

// The way from a to b that is at most half a turn.
double turn(double a, double b) {
  const double d = b - a;
  return d - 2 * kPi * std::round(d / (2 * kPi));
}

// Yaw at the joints: what is wanted, each as near as the rate allows after the one before.
std::vector<double> at_joints(const YawOptions& options, const Trajectory& trajectory) {
  std::vector<std::optional<double>> look;
  const std::vector<State> joints = joint_states(trajectory);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const State& next = joints[std::min(i + 1, joints.size() - 1)];
    look.push_back(wanted(options, joints[i], next.position - joints[i].position));
  }
  const auto first =
      std::find_if(look.begin(), look.end(), [](const auto& l) { return l.has_value(); });
  std::vector<double> yaw = {first == look.end() ? 0 : **first};
  for (std::size_t i = 1; i < look.size(); ++i) {
    const double most = options.rate * trajectory.segments[i - 1].duration / kSteepest * kSlack;
    const double step = look[i] ? turn(yaw.back(), *look[i]) : 0;
    yaw.push_back(yaw.back() + std::clamp(step, -most, most));
  }
  return yaw;
}

// Bernstein values with these ends and rates, and no second and third derivative there.
struct Turn {
  double angle;
  double rate;
};

std::array<double, kPoints> between(const Turn& begin, const Turn& end, double t) {
  const double a = begin.angle;
  const double b = end.angle;
  const double up = begin.rate * t / kDegree;
  const double down = end.rate * t / kDegree;
  return {a, a + up, a + 2 * up, a + 3 * up, b - 3 * down, b - 2 * down, b - down, b};
}

// Of the absolute values of the curve, from above: by the control points of 2^depth parts.
double largest(const std::array<double, kDegree>& b, int depth) {
  if (depth == 0) {
    double most = 0;
    for (const double v : b) most = std::max(most, std::abs(v));
    return most;
  }
  const auto [left, right] = halves(b);
  return std::max(largest(left, depth - 1), largest(right, depth - 1));
}

}  // namespace

double yaw_rate_bound(const Segment& segment) {
  if (!segment.yaw) return 0;
  std::array<double, kDegree> rate;
  for (std::size_t i = 0; i < kDegree; ++i) {
    rate[i] = ((*segment.yaw)[i + 1] - (*segment.yaw)[i]) * kDegree / segment.duration;
  }
  return largest(rate, 8);
}

void add_yaw(const YawOptions& options, Trajectory& trajectory) {
  auto& segments = trajectory.segments;
  const std::vector<double> yaw = at_joints(options, trajectory);
  const auto mean = [&](std::size_t i) { return (yaw[i + 1] - yaw[i]) / segments[i].duration; };
  std::vector<double> rate(yaw.size());
  for (std::size_t i = 1; i + 1 < yaw.size(); ++i) {
    const double before = mean(i - 1);
    const double after = mean(i);
    if (before * after > 0) {
      rate[i] = std::abs(before) < std::abs(after) ? before : after;
    }
  }
  const auto set = [&](std::size_t i) {
    segments[i].yaw = between({yaw[i], rate[i]}, {yaw[i + 1], rate[i + 1]}, segments[i].duration);
  };
  for (std::size_t i = 0; i < segments.size(); ++i) set(i);
  // A segment that would turn too fast comes to rest at its ends, where it surely does not.
  for (std::size_t i = 0; i < segments.size();) {
    const bool rests = rate[i] == 0 && rate[i + 1] == 0;
    if (rests || yaw_rate_bound(segments[i]) <= options.rate) {
      ++i;
      continue;
    }
    rate[i] = rate[i + 1] = 0;
    for (std::size_t k = i > 0 ? i - 1 : 0; k < std::min(i + 2, segments.size()); ++k) set(k);
    i = i > 0 ? i - 1 : 0;
  }
}

std::optional<Heading> heading(const Segment& segment, double u) {
  if (!segment.yaw) return std::nullopt;
  auto b = *segment.yaw;
  for (int m = kDegree; m > 1; --m) {
    for (int i = 0; i < m; ++i) b[i] += u * (b[i + 1] - b[i]);
  }
  return Heading{b[0] + u * (b[1] - b[0]), kDegree * (b[1] - b[0]) / segment.duration};
}

std::optional<double> yaw_at(const Trajectory& trajectory, double t) {
  double begin = 0;
  for (const Segment& s : trajectory.segments) {
    const bool last = &s == &trajectory.segments.back();
    if (t < begin + s.duration || last) {
      const auto found = heading(s, std::clamp((t - begin) / s.duration, 0.0, 1.0));
      return found ? std::optional(found->yaw) : std::nullopt;
    }
    begin += s.duration;
  }
  return std::nullopt;
}

}  // namespace traj
