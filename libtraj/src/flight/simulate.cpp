#include "traj/flight/simulate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "flight/geometric_controller.h"
#include "traj/proof/limits.h"

namespace traj {
namespace {

constexpr double kLostDistance = 100;  // m
constexpr double kLostRate = 100;      // rad/s

QuadrotorState start_state(const ReferenceTrack& track, const FlightOptions& options,
                           const Quadrotor& vehicle) {
  std::size_t cursor = 0;
  const Reference first = track.at(options.hover > 0 ? -1 : 0, cursor);
  QuadrotorState state;
  state.position = first.position;
  state.velocity = first.velocity;
  state.attitude = Eigen::AngleAxisd(first.yaw, Vec3::UnitZ());
  state.thrust = Motors::Constant(
      std::clamp(vehicle.mass * kGravity / 4, vehicle.motor_least, vehicle.motor_most));
  return state;
}

template <class Controller>
class Simulation {
 public:
  Simulation(const ReferenceTrack& track, const FlightOptions& options, const FlightKeep& keep)
      : track_(track),
        options_(options),
        keep_(keep),
        vehicle_(true_vehicle(options)),
        controller_(options.quadrotor, options.gains, options.periods),
        wind_(options.wind, options.seed * 2 + 1),
        state_(start_state(track, options, vehicle_)),
        sensors_(options.sensors, state_, options.seed * 2 + 2),
        before_(std::lround(options.hover / kStep)),
        during_(std::lround(track.duration() / kStep)),
        steps_(std::lround((track.duration() + options.settle) / kStep)) {
    flight_.error.reserve(steps_ / kStepsPerSample + 1);
    flight_.tilt.reserve(steps_ / kStepsPerSample + 1);
    if (keep.log_period) flight_.samples.reserve(steps_ / keep.log_period + 1);
    if (keep.path) flight_.path.reserve(steps_ + 1);
  }

  Flight run() {
    for (long n = -before_; n <= steps_ && !flight_.lost; ++n) step(n);
    if (flight_.lost) keep_what_was_sampled();
    const double samples = static_cast<double>(flight_.error.size());
    if (samples > 0) flight_.saturated /= samples;
    if (velocity_samples_ > 0) {
      flight_.velocity_error = std::sqrt(velocity_squares_ / velocity_samples_);
    }
    flight_.final_distance = (state_.position - reference_.position).norm();
    return std::move(flight_);
  }

 private:
  // Past the last sample nothing may be finite.
  void keep_what_was_sampled() {
    const std::size_t samples = flight_.error.size();
    const std::size_t most = samples ? (samples - 1) * kStepsPerSample + 1 : 0;
    if (flight_.path.size() > most) flight_.path.resize(most);
  }

  void step(long n) {
    const long since_start = n + before_;
    const LoopPeriods& periods = options_.periods;
    if (since_start % periods.position == 0 || since_start % periods.attitude == 0 ||
        n % kStepsPerSample == 0) {
      reference_ = track_.at(static_cast<double>(n) * kStep, cursor_);
    }
    if (since_start % kStepsPerSample == 0) {
      input_.wind = wind_.step(state_.position, state_.velocity, kSamplePeriod);
    }
    input_.command = controller_.command(since_start, reference_, sensors_.read(state_));
    if (n >= 0) observe(n);
    if (n < steps_) state_ = integrate(vehicle_, state_, input_, kStep);
  }

  void observe(long n) {
    const Eigen::Quaterniond& q = state_.attitude;
    upright_ = std::min(upright_, 1 - 2 * (q.x() * q.x() + q.y() * q.y()));
    if (keep_.path) flight_.path.push_back(state_.position);
    if (n % kStepsPerSample == 0) sample(n);
    if (keep_.log_period && n % keep_.log_period == 0 && !flight_.lost) log(n);
  }

  void sample(long n) {
    const double error = (state_.position - reference_.position).norm();
    // Written so that what is not finite is lost too.
    if (!(error <= kLostDistance && state_.body_rates.norm() <= kLostRate)) {
      flight_.lost = static_cast<double>(n) * kStep;
      return;
    }
    flight_.error.push_back(error);
    flight_.tilt.push_back(std::acos(std::clamp(upright_, -1.0, 1.0)));
    upright_ = 1;
    if (n <= during_) {
      velocity_squares_ += (state_.velocity - reference_.velocity).squaredNorm();
      ++velocity_samples_;
    }
    flight_.fastest_air = std::max(flight_.fastest_air, (state_.velocity - input_.wind).norm());
    const Motors load = (state_.thrust * (4 / (options_.quadrotor.mass * kGravity))).cwiseMax(0);
    flight_.hover_seconds += kSamplePeriod * load.cwiseProduct(load.cwiseSqrt()).sum() / 4;
    const bool saturated = controller_.take_saturated();
    flight_.saturated += saturated;
    log_saturated_ |= saturated;
  }

  void log(long n) {
    FlightSample s;
    s.time = static_cast<double>(n) / 1000;  // the double nearest to the decimal
    s.position = state_.position;
    s.velocity = state_.velocity;
    s.attitude = state_.attitude;
    s.body_rates = state_.body_rates;
    s.setpoint_position = reference_.position;
    s.setpoint_velocity = reference_.velocity;
    s.setpoint_yaw = reference_.yaw;
    for (int i = 0; i < 4; ++i) s.motors[i] = input_.command[i] / vehicle_.motor_most;
    s.saturated = std::exchange(log_saturated_, false);
    flight_.samples.push_back(s);
  }

  const ReferenceTrack& track_;
  const FlightOptions& options_;
  FlightKeep keep_;
  Quadrotor vehicle_;
  Controller controller_;
  Wind wind_;
  QuadrotorState state_;
  Sensors sensors_;
  long before_;  // steps before the start,
  long during_;  // along the trajectory,
  long steps_;   // and from the start to the very end
  QuadrotorInput input_;
  Reference reference_;
  std::size_t cursor_ = 0;
  double upright_ = 1;  // cosine of the largest tilt since the last sample
  double velocity_squares_ = 0;
  double velocity_samples_ = 0;
  bool log_saturated_ = false;
  Flight flight_;
};

}  // namespace

Quadrotor true_vehicle(const FlightOptions& options) {
  Quadrotor out = options.quadrotor;
  out.mass *= 1 + options.mass_error;
  out.drag *= 1 + options.drag_error;
  out.motor_time_constant *= 1 + options.motor_lag_error;
  out.inertia = out.inertia.cwiseProduct(Vec3::Ones() + options.inertia_error);
  return out;
}

Flight simulate(const ReferenceTrack& track, const FlightOptions& options, const FlightKeep& keep) {
  if (options.law == ControlLaw::geometric) {
    return Simulation<GeometricController>(track, options, keep).run();
  }
  return Simulation<CascadeController>(track, options, keep).run();
}

}  // namespace traj
