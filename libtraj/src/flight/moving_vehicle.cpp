#include "traj/flight/moving_vehicle.h"

#include <algorithm>
#include <cmath>

#include "traj/curve/flatness.h"
#include "traj/curve/yaw.h"

namespace traj {
namespace {

constexpr double kMostSteps = 1e5;  // of a way: its lines are drawn, and that is finer than pixels

// What a log does not say, for pictures: the attitude of the row before, else level; the speed of
// the way to the next row.
void complete(std::vector<FlightSample>& samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    FlightSample& s = samples[i];
    if (s.attitude.coeffs().array().isNaN().any()) {
      s.attitude = i > 0 ? samples[i - 1].attitude : Eigen::Quaterniond::Identity();
    }
    if (is_known(s.velocity)) continue;
    s.velocity = Vec3::Zero();
    if (samples.size() < 2) continue;
    const std::size_t from = std::min(i, samples.size() - 2);
    s.velocity = (samples[from + 1].position - samples[from].position) /
                 (samples[from + 1].time - samples[from].time);
  }
}

Vec3 mixed(const Vec3& a, const Vec3& b, double share) { return a + share * (b - a); }

}  // namespace

MovingVehicle::MovingVehicle(std::string id, Trajectory trajectory, geom::Axes axes)
    : id_(std::move(id)), trajectory_(std::move(trajectory)), axes_(axes) {
  const bool looks = std::all_of(trajectory_.segments.begin(), trajectory_.segments.end(),
                                 [](const Segment& s) { return s.yaw.has_value(); });
  if (!looks) add_yaw({}, trajectory_);
  end_ = duration(trajectory_);
}

MovingVehicle::MovingVehicle(FlightLog flight) : id_(flight.id), flight_(std::move(flight)) {
  complete(flight_.samples);
  begin_ = flight_.samples.front().time;
  end_ = flight_.samples.back().time;
}

MovingVehicle::Between MovingVehicle::between(double t) const {
  const auto& samples = flight_.samples;
  const auto after =
      std::upper_bound(samples.begin(), samples.end(), t,
                       [](double time, const FlightSample& s) { return time < s.time; });
  if (after == samples.begin()) return {0, 0};
  const auto first = static_cast<std::size_t>(after - samples.begin()) - 1;
  if (after == samples.end()) return {first, 0};
  return {first, (t - samples[first].time) / (after->time - samples[first].time)};
}

State MovingVehicle::state(double t) const { return to_enu(axes_, evaluate(trajectory_, t)); }

geom::picture::Pose MovingVehicle::pose(double t) const {
  if (!is_flight()) {
    const State at = state(t);
    return {at.position, flat_state(at, heading_at(trajectory_, axes_, t)).attitude};
  }
  const auto [i, share] = between(t);
  const FlightSample& a = flight_.samples[i];
  if (share == 0) return {a.position, a.attitude.toRotationMatrix()};
  const FlightSample& b = flight_.samples[i + 1];
  return {mixed(a.position, b.position, share),
          a.attitude.slerp(share, b.attitude).normalized().toRotationMatrix()};
}

double MovingVehicle::speed(double t) const {
  if (!is_flight()) return state(t).velocity.norm();
  const auto [i, share] = between(t);
  const FlightSample& a = flight_.samples[i];
  if (share == 0) return a.velocity.norm();
  return mixed(a.velocity, flight_.samples[i + 1].velocity, share).norm();
}

bool MovingVehicle::has_setpoints() const {
  return is_flight() && std::all_of(flight_.samples.begin(), flight_.samples.end(),
                                    [](const auto& s) { return is_known(s.setpoint_position); });
}

double MovingVehicle::tracking_error(double t) const {
  if (!is_flight()) return 0;
  const auto [i, share] = between(t);
  const auto error = [&](std::size_t k) {
    return Vec3(flight_.samples[k].position - flight_.samples[k].setpoint_position);
  };
  return (share == 0 ? error(i) : mixed(error(i), error(i + 1), share)).norm();
}

geom::picture::FilmedVehicle MovingVehicle::filmed() const {
  geom::picture::FilmedVehicle out{begin_,
                                   end_,
                                   [this](double t) { return pose(t); },
                                   [this](double t) { return speed(t); },
                                   {}};
  if (has_setpoints()) out.tracking_error = [this](double t) { return tracking_error(t); };
  return out;
}

std::vector<Vec3> MovingVehicle::way(double step) const {
  const double count = std::clamp(std::ceil((end_ - begin_) / step), 1.0, kMostSteps);
  std::vector<Vec3> out;
  for (double k = 0; k <= count; ++k) {
    const double t = begin_ + (end_ - begin_) * (k / count);
    out.push_back(is_flight() ? pose(t).position : state(t).position);
  }
  return out;
}

}  // namespace traj
