#include "tracking.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "figure.h"
#include "palette.h"

namespace plot {
namespace {

constexpr double kDegrees = 57.29577951308232;

using traj::FlightSample;

std::vector<Point> curve(const traj::FlightLog& flight,
                         const std::function<double(const FlightSample&)>& value) {
  std::vector<Point> points;
  for (const FlightSample& s : flight.samples) points.push_back({s.time, value(s)});
  return points;
}

double error(const FlightSample& s) { return (s.position - s.setpoint_position).norm(); }

double tilt(const FlightSample& s) {
  const double up = (s.attitude * geom::Vec3::UnitZ()).z();
  return std::acos(std::clamp(up, -1.0, 1.0)) * kDegrees;
}

Panel error_panel(const traj::FlightLog& flight) {
  Panel panel{"error, m", {{"", colour(1), curve(flight, error)}}};
  const Point most = *std::max_element(panel.series[0].points.begin(), panel.series[0].points.end(),
                                       [](const Point& a, const Point& b) { return a.y < b.y; });
  panel.marks = {{most, fmt::format("largest {:.3g} m", most.y)}};
  return panel;
}

Panel axis_panel(const traj::FlightLog& flight, int axis, const char* label) {
  return {
      label,
      {{"flown", colour(0),
        curve(flight, [axis](const FlightSample& s) { return s.position[axis]; })},
       {"setpoint", colour(1),
        curve(flight, [axis](const FlightSample& s) { return s.setpoint_position[axis]; }), true}},
      {},
      {},
      false};
}

Panel motor_panel(const traj::FlightLog& flight) {
  Panel panel{"motors, share", {}};
  for (std::size_t m = 0; m < 4; ++m) {
    panel.series.push_back({fmt::format("{}", m + 1), colour(m),
                            curve(flight, [m](const FlightSample& s) { return s.motors[m]; })});
  }
  return panel;
}

}  // namespace

std::string tracking(const traj::FlightLog& flight, std::string_view note) {
  double squares = 0;
  for (const FlightSample& s : flight.samples) squares += error(s) * error(s);
  const double mean = squares / static_cast<double>(flight.samples.size());
  Figure figure;
  figure.title =
      fmt::format("{}: {:.2f} s flown, tracking error {:.3g} m root mean square", flight.id,
                  flight.samples.back().time - flight.samples.front().time, std::sqrt(mean));
  figure.title += note;
  figure.x_label = "time, s";
  figure.panels = {
      error_panel(flight),
      axis_panel(flight, 0, "east, m"),
      axis_panel(flight, 1, "north, m"),
      axis_panel(flight, 2, "up, m"),
      {"speed, m/s",
       {{"flown", colour(0), curve(flight, [](const auto& s) { return s.velocity.norm(); })},
        {"setpoint", colour(1),
         curve(flight, [](const auto& s) { return s.setpoint_velocity.norm(); }), true}}},
      {"tilt, \u00b0", {{"", colour(0), curve(flight, tilt)}}},
      motor_panel(flight)};
  return drawn(figure);
}

}  // namespace plot
