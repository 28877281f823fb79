#include "motion_profile.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "figure.h"
#include "geom/text/counted.h"
#include "palette.h"
#include "traj/curve/flatness.h"
#include "traj/curve/smoothness.h"
#include "traj/record/duration_bound.h"

namespace plot {
namespace {

constexpr int kSamples = 1500;
constexpr double kDegrees = 57.29577951308232;

using Value = std::function<double(const traj::State&)>;

// A value at many instants of the trajectory.
template <class At>
std::vector<Point> sampled(const traj::TrajectoryRecord& record, const At& at) {
  const double end = traj::duration(record.trajectory);
  std::vector<Point> points;
  for (int i = 0; i <= kSamples; ++i)
    points.push_back({end * i / kSamples, at(end * i / kSamples)});
  return points;
}

std::vector<Point> curve(const traj::TrajectoryRecord& record, geom::Axes axes,
                         const Value& value) {
  return sampled(record, [&](double t) {
    return value(traj::to_enu(axes, traj::evaluate(record.trajectory, t)));
  });
}

std::vector<Level> level(const char* name, const std::optional<double>& limit, double scale = 1) {
  if (!limit) return {};
  return {{fmt::format("{} {:.4g}", name, *limit * scale), *limit * scale}};
}

// "∫ |jerk|² dt = 12.3 m²/s⁵"
std::string integral_words(const char* of, double value, const char* unit) {
  return fmt::format("\u222b |{}|\u00b2 dt = {:.4g} {}", of, value, unit);
}

Panel jerk_panel(const traj::TrajectoryRecord& record, geom::Axes axes) {
  const auto jerk = [](const traj::State& s) { return s.jerk.norm(); };
  Panel out{"jerk, m/s\u00b3",
            {{"", colour(0), curve(record, axes, jerk)}},
            level("jmax", traj::limits_of(record)[traj::Limit::jerk])};
  out.note = integral_words("jerk", traj::smoothness(record.trajectory).jerk, "m\u00b2/s\u2075");
  return out;
}

Panel snap_panel(const traj::TrajectoryRecord& record) {
  const auto snap = [&](double t) { return traj::snap(record.trajectory, t).norm(); };
  Panel out{"snap, m/s\u2074", {{"", colour(0), sampled(record, snap)}}};
  out.note = integral_words("snap", traj::smoothness(record.trajectory).snap, "m\u00b2/s\u2077");
  return out;
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
      jerk_panel(record, axes),
      snap_panel(record),
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
