#include "motion_profile.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "figure.h"
#include "geom/text/counted.h"
#include "palette.h"
#include "traj/curve/flatness.h"
#include "traj/record/duration_bound.h"

namespace plot {
namespace {

constexpr int kSamples = 1500;
constexpr double kDegrees = 57.29577951308232;

using Value = std::function<double(const traj::State&)>;

std::vector<Point> curve(const traj::TrajectoryRecord& record, geom::Axes axes,
                         const Value& value) {
  const double end = traj::duration(record.trajectory);
  std::vector<Point> points;
  for (int i = 0; i <= kSamples; ++i) {
    const double t = end * i / kSamples;
    points.push_back({t, value(traj::to_enu(axes, traj::evaluate(record.trajectory, t)))});
  }
  return points;
}

std::vector<Level> level(const char* name, const std::optional<double>& limit, double scale = 1) {
  if (!limit) return {};
  return {{fmt::format("{} {:.4g}", name, *limit * scale), *limit * scale}};
}

// How much faster another flight could be, where the record has a bound.
std::string gap_words(const traj::TrajectoryRecord& record) {
  const auto gap = traj::duration_gap(record);
  return gap ? ", " + traj::slower_words(*gap) : "";
}

double tilt(const traj::State& s) {
  const traj::FlatState flat = traj::flat_state(s, {});
  return std::acos(std::min(1.0, flat.attitude(2, 2))) * kDegrees;
}

}  // namespace

std::string motion_profile(const traj::TrajectoryRecord& record, std::string_view note) {
  const geom::Axes axes = record.provenance.frame.value_or(geom::Axes::enu);
  const traj::Limits limits = traj::limits_of(record);
  const auto of = [&](const Value& value, const char* label, std::size_t i) {
    return Series{label, colour(i), curve(record, axes, value)};
  };
  Panel position;
  position.label = "position, m";
  position.from_zero = false;
  constexpr const char* kNames[] = {"east", "north", "up"};
  for (int i = 0; i < 3; ++i) {
    const auto part = [i](const traj::State& s) { return s.position[i]; };
    position.series.push_back(of(part, kNames[i], static_cast<std::size_t>(i)));
  }
  Panel speed{"speed, m/s", {}, level("vmax", limits[traj::Limit::speed])};
  speed.series.push_back(of([](const traj::State& s) { return s.velocity.norm(); }, "speed", 0));
  const auto sideways = [](const traj::State& s) { return s.velocity.head<2>().norm(); };
  const auto upward = [](const traj::State& s) { return std::abs(s.velocity.z()); };
  if (limits[traj::Limit::horizontal_speed] || limits[traj::Limit::vertical_speed]) {
    speed.series.push_back(of(sideways, "horizontal", 1));
    speed.series.push_back(of(upward, "vertical", 2));
    for (const Level& l : level("vmax_h", limits[traj::Limit::horizontal_speed]))
      speed.levels.push_back(l);
    for (const Level& l : level("vmax_v", limits[traj::Limit::vertical_speed]))
      speed.levels.push_back(l);
  }
  const auto acceleration = [](const traj::State& s) { return s.acceleration.norm(); };
  const auto jerk = [](const traj::State& s) { return s.jerk.norm(); };
  const auto thrust = [](const traj::State& s) { return traj::flat_state(s, {}).thrust; };
  Figure figure;
  figure.title = fmt::format("{}: {:.2f} s, {}{}", record.id, traj::duration(record.trajectory),
                             geom::counted(record.trajectory.segments.size(), "segment"),
                             record.rung ? fmt::format(", {}", name(*record.rung)) : "");
  figure.title += gap_words(record);
  figure.title += note;
  figure.x_label = "time, s";
  figure.panels = {
      position,
      speed,
      {"acceleration, m/s\u00b2",
       {of(acceleration, "", 0)},
       level("amax", limits[traj::Limit::acceleration])},
      {"jerk, m/s\u00b3", {of(jerk, "", 0)}, level("jmax", limits[traj::Limit::jerk])},
      {"thrust/mass, m/s\u00b2",
       {of(thrust, "", 0)},
       level("thrust", limits[traj::Limit::thrust]),
       {},
       false},
      {"tilt, \u00b0", {of(tilt, "", 0)}, level("tilt", limits[traj::Limit::tilt], kDegrees)}};
  if (limits[traj::Limit::body_rate]) {
    const auto rate = [](const traj::State& state) {
      return traj::flat_state(state, {}).body_rate.head<2>().norm();
    };
    figure.panels.push_back({"body rate, rad/s",
                             {of(rate, "", 0)},
                             level("body_rate", limits[traj::Limit::body_rate])});
  }
  double t = 0;
  for (const traj::Segment& s : record.trajectory.segments) {
    figure.joints.push_back(std::min(t += s.duration, traj::duration(record.trajectory)));
  }
  return drawn(figure);
}

}  // namespace plot
