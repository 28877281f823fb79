#include "traj/figure/tracking.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "shapes.h"

namespace traj::figure {
namespace {

constexpr double kDegrees = 57.29577951308232;


std::vector<Point> curve(const FlightLog& flight,
                         const std::function<double(const FlightSample&)>& value) {
  std::vector<Point> points;
  for (const FlightSample& s : flight.samples) {
    const double y = value(s);
    if (!std::isnan(y)) points.push_back({s.time, y});
  }
  return points;
}

double error(const FlightSample& s) { return (s.position - s.setpoint_position).norm(); }

double tilt(const FlightSample& s) {
  const double up = (s.attitude * geom::Vec3::UnitZ()).z();
  if (std::isnan(up)) return up;
  return std::acos(std::clamp(up, -1.0, 1.0)) * kDegrees;
}

// Steps: a radius for each period.
Series tube_series(const TubeRecord& tube) {
  const bool proved = tube.claim.kind == TubeKind::proved;
  Series series{proved ? "proved tube" : "tube (statistics)", colour(2), {}, true};
  for (std::size_t k = 0; k < tube.radius.size(); ++k) {
    const double begin = static_cast<double>(k) * tube.period;
    series.points.push_back({begin, tube.radius[k]});
    series.points.push_back({begin + tube.period, tube.radius[k]});
  }
  return series;
}

Panel error_panel(const FlightLog& flight, const TubeRecord* tube) {
  Panel panel{"error, m", {{tube ? "flown" : "", colour(1), curve(flight, error)}}};
  if (tube) panel.series.push_back(tube_series(*tube));
  if (panel.series[0].points.empty()) return panel;
  const Point most = *std::max_element(panel.series[0].points.begin(), panel.series[0].points.end(),
                                       [](const Point& a, const Point& b) { return a.y < b.y; });
  panel.marks = {{most, fmt::format("largest {:.3g} m", most.y)}};
  return panel;
}

Series plan_series(const Trajectory& plan, int axis) {
  constexpr double kStep = 0.05;  // s
  constexpr double kMost = 20000;
  const double end = duration(plan);
  const double count = std::clamp(std::ceil(end / kStep), 1.0, kMost);
  Series series{"plan", colour(2), {}, true};
  for (double k = 0; k <= count; ++k) {
    const double t = end * (k / count);
    series.points.push_back({t, evaluate(plan, t).position[axis]});
  }
  return series;
}

Panel axis_panel(const FlightLog& flight, int axis, const char* label, const Trajectory* plan) {
  Panel panel{
      label,
      {{"flown", colour(0),
        curve(flight, [axis](const FlightSample& s) { return s.position[axis]; })},
       {"setpoint", colour(1),
        curve(flight, [axis](const FlightSample& s) { return s.setpoint_position[axis]; }), true}},
      {},
      {},
      false};
  if (plan) panel.series.push_back(plan_series(*plan, axis));
  return panel;
}

// Without curves that have no points, and without what is empty then.
std::vector<Panel> not_empty(std::vector<Panel> panels) {
  for (Panel& panel : panels) {
    std::erase_if(panel.series, [](const Series& s) { return s.points.empty(); });
  }
  std::erase_if(panels, [](const Panel& panel) { return panel.series.empty(); });
  return panels;
}

std::string error_words(const FlightLog& flight) {
  double squares = 0;
  std::size_t known = 0;
  for (const FlightSample& s : flight.samples) {
    if (!is_known(s.setpoint_position)) continue;
    squares += error(s) * error(s);
    ++known;
  }
  if (known == 0) return "no setpoints";
  return fmt::format("tracking error {:.3g} m root mean square",
                     std::sqrt(squares / static_cast<double>(known)));
}

Panel motor_panel(const FlightLog& flight) {
  Panel panel{"motors, share", {}};
  for (std::size_t m = 0; m < 4; ++m) {
    panel.series.push_back({fmt::format("{}", m + 1), colour(m),
                            curve(flight, [m](const FlightSample& s) { return s.motors[m]; })});
  }
  return panel;
}

}  // namespace

std::string tracking(const FlightLog& flight, std::string_view note, const Trajectory* plan,
                     const TubeRecord* tube) {
  Figure figure;
  figure.title =
      fmt::format("{}: {:.2f} s flown, {}", flight.id,
                  flight.samples.back().time - flight.samples.front().time, error_words(flight));
  figure.title += note;
  figure.x_label = "time, s";
  figure.panels = not_empty(
      {error_panel(flight, tube),
       axis_panel(flight, 0, "east, m", plan),
       axis_panel(flight, 1, "north, m", plan),
       axis_panel(flight, 2, "up, m", plan),
       {"speed, m/s",
        {{"flown", colour(0), curve(flight, [](const auto& s) { return s.velocity.norm(); })},
         {"setpoint", colour(1),
          curve(flight, [](const auto& s) { return s.setpoint_velocity.norm(); }), true}}},
       {"tilt, \u00b0", {{"", colour(0), curve(flight, tilt)}}},
       motor_panel(flight)});
  return drawn(figure);
}

}  // namespace traj::figure
