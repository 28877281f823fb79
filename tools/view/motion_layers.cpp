#include <algorithm>
#include <cmath>

#include "knots.h"
#include "layers.h"
#include "traj/curve/yaw.h"
#include "traj/figure/clearance.h"
#include "traj/proof/clearance.h"
#include "traj/record/duration_bound.h"

namespace view {
namespace {

using geom::Vec3;

Json added(const std::vector<float>& values, Bundle& bundle) {
  return bundle.add(std::span<const float>(values));
}

void add_vehicle(Json& out, const std::optional<geom::Vehicle>& vehicle, geom::Axes axes) {
  if (!vehicle) return;
  out["vehicle"] = {{"name", vehicle->name}, {"half", as_json(geom::to_enu(axes, vehicle->half))}};
}

// Steps side by side: the least distance of each, and when it ends (the first begins at 0).
void add_clearance(Json& out, const std::vector<traj::ClearanceSpan>& spans, Bundle& bundle) {
  if (spans.empty()) return;
  std::vector<float> least, end;
  for (const traj::ClearanceSpan& span : spans) {
    least.push_back(static_cast<float>(span.clearance));
    end.push_back(static_cast<float>(span.end));
  }
  out["clearance"] = added(least, bundle);
  out["clearance_end"] = added(end, bundle);
}

std::vector<float> joints(const traj::Trajectory& trajectory) {
  std::vector<float> times;
  double t = 0;
  for (const traj::Segment& s : trajectory.segments) {
    times.push_back(static_cast<float>(t += s.duration));
  }
  times.pop_back();
  return times;
}

// Indices of `count` rows or fewer, evenly spread, the first and the last among them.
std::vector<std::size_t> spread(std::size_t rows, std::size_t count) {
  const std::size_t kept = std::min(rows, std::max<std::size_t>(count, 2));
  std::vector<std::size_t> out(kept);
  for (std::size_t i = 0; i < kept; ++i) out[i] = kept < 2 ? 0 : i * (rows - 1) / (kept - 1);
  return out;
}

double tracking_error(const traj::FlightSample& s) {
  return (s.position - s.setpoint_position).norm();
}

// Of all rows, not of those that are shown.
Json flight_summary(const traj::FlightLog& log) {
  double worst = 0;
  double squares = 0;
  std::size_t asked = 0;
  std::size_t saturated = 0;
  bool motors = true;
  for (const traj::FlightSample& s : log.samples) {
    saturated += s.saturated;
    motors = motors && !std::isnan(s.motors[0]);
    if (!traj::is_known(s.setpoint_position)) continue;
    const double error = tracking_error(s);
    worst = std::max(worst, error);
    squares += error * error;
    ++asked;
  }
  Json out = {{"rows", log.samples.size()}};
  if (asked > 0) out["error_max"] = worst;
  if (asked > 0) out["error_rms"] = std::sqrt(squares / static_cast<double>(asked));
  if (motors) {
    out["saturated"] = static_cast<double>(saturated) / static_cast<double>(log.samples.size());
  }
  return out;
}

// Whether the log says it in any row, and in all.
bool is_known(const std::vector<float>& values) {
  return std::any_of(values.begin(), values.end(), [](float v) { return !std::isnan(v); });
}

bool is_whole(const std::vector<float>& values) {
  return std::none_of(values.begin(), values.end(), [](float v) { return std::isnan(v); });
}

// The arrays of a flight, by name.
struct Columns {
  std::vector<float> time, position, velocity, attitude, rates, setpoint, setpoint_velocity, error,
      motors;
  std::vector<std::uint8_t> saturated;

  void add(const traj::FlightSample& s, double start, const LocalFrame& enu) {
    time.push_back(static_cast<float>(s.time - start));
    append(position, enu.at(s.position));
    append(velocity, s.velocity);
    append(attitude, s.attitude.vec());
    attitude.push_back(static_cast<float>(s.attitude.w()));
    append(rates, s.body_rates);
    append(setpoint, enu.at(s.setpoint_position));
    append(setpoint_velocity, s.setpoint_velocity);
    error.push_back(static_cast<float>(tracking_error(s)));
    for (const double m : s.motors) motors.push_back(static_cast<float>(m));
    saturated.push_back(s.saturated);
  }

  void write(Json& out, Bundle& bundle) const {
    out["time"] = added(time, bundle);
    out["position"] = added(position, bundle);
    const auto add = [&](const char* name, const std::vector<float>& values) {
      if (is_known(values)) out[name] = added(values, bundle);
    };
    add("velocity", velocity);
    if (is_whole(attitude)) add("attitude", attitude);
    add("rates", rates);
    add("setpoint", setpoint);
    add("setpoint_velocity", setpoint_velocity);
    add("error", error);
    add("motors", motors);
    out["saturated"] = bundle.add(std::span<const std::uint8_t>(saturated));
  }
};

constexpr double kStepsOfMany = 100;  // of the clearance, where there are many flights
constexpr std::size_t kYawsOfMany = 100;

double instant(double end, std::size_t i, std::size_t count) {
  return end * static_cast<double>(i) / static_cast<double>(count - 1);
}

void add_samples(Json& out, const traj::Trajectory& trajectory, std::size_t samples,
                 const LocalFrame& frame, Bundle& bundle) {
  const double end = traj::duration(trajectory);
  std::vector<float> position, velocity, acceleration, jerk;
  for (std::size_t i = 0; i < samples; ++i) {
    const traj::State s = traj::evaluate(trajectory, instant(end, i, samples));
    append(position, frame.at(s.position));
    append(velocity, geom::to_enu(frame.axes, s.velocity));
    append(acceleration, geom::to_enu(frame.axes, s.acceleration));
    append(jerk, geom::to_enu(frame.axes, s.jerk));
  }
  out["position"] = added(position, bundle);
  out["velocity"] = added(velocity, bundle);
  out["acceleration"] = added(acceleration, bundle);
  out["jerk"] = added(jerk, bundle);
}

// Evenly spread; nothing where a segment has none.
void add_yaw(Json& out, const traj::Trajectory& trajectory, const Sampling& sampling,
             geom::Axes axes, Bundle& bundle) {
  const std::size_t samples = sampling.joints ? kYawsOfMany : sampling.count;
  const double end = traj::duration(trajectory);
  std::vector<float> yaw;
  for (std::size_t i = 0; i < samples; ++i) {
    const auto angle = traj::yaw_at(trajectory, instant(end, i, samples));
    if (!angle) return;
    yaw.push_back(static_cast<float>(geom::yaw_to_enu(axes, *angle)));
  }
  out["yaw"] = added(yaw, bundle);
}

}  // namespace

Json trajectory_layer(const cli::Read<traj::TrajectoryRecord>& read, const Sampling& sampling,
                      const LocalFrame& frame, Clearance& clearance, Bundle& bundle) {
  const traj::TrajectoryRecord& record = read.record;
  const double end = traj::duration(record.trajectory);
  Json out = {{"kind", "trajectory"}, {"id", record.id}, {"duration", end}};
  if (!sampling.joints) out["samples"] = sampling.count;
  if (record.rung) out["rung"] = name(*record.rung);
  if (const auto gap = traj::duration_gap(record)) out["slower"] = traj::slower_words(*gap);
  out["segments"] = record.trajectory.segments.size();
  out["limits"] = as_json(traj::limits_of(record));
  if (sampling.joints) {
    add_knots(out, knots_of(record.trajectory, sampling.count), frame, bundle);
  } else {
    add_samples(out, record.trajectory, sampling.count, frame, bundle);
  }
  add_yaw(out, record.trajectory, sampling, frame.axes, bundle);
  out["joints"] = added(joints(record.trajectory), bundle);
  if (const auto* scene = clearance.scene_for(record.provenance, read.source, read.line)) {
    const double steps = sampling.joints ? kStepsOfMany : static_cast<double>(sampling.count - 1);
    add_clearance(out, traj::clearance_profile(*scene, record.trajectory, end / steps), bundle);
  }
  add_vehicle(out, clearance.vehicle(record.provenance), frame.axes);
  return out;
}

Json flight_layer(const cli::Read<traj::FlightLog>& read, std::size_t samples,
                  const geom::Provenance& made_for, const LocalFrame& frame, Clearance& clearance,
                  Bundle& bundle) {
  const traj::FlightLog& log = read.record;
  Columns columns;
  const double start = log.samples.front().time;
  const std::vector<std::size_t> kept = spread(log.samples.size(), samples);
  for (const std::size_t i : kept) columns.add(log.samples[i], start, frame.of(geom::Axes::enu));
  Json out = {{"kind", "flight"},
              {"id", log.id},
              {"duration", log.samples.back().time - start},
              {"samples", kept.size()},
              {"summary", flight_summary(log)}};
  columns.write(out, bundle);
  if (const auto* scene = clearance.scene_for(made_for, read.source, read.line)) {
    add_clearance(out, traj::figure::clearance_of(*scene, log, kept), bundle);
  }
  add_vehicle(out, clearance.vehicle(made_for), frame.axes);
  return out;
}

}  // namespace view
