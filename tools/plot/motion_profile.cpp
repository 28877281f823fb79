#include "motion_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "svg.h"

namespace plot {
namespace {

constexpr int kSamples = 1200;  // of a picture 800 pixels wide
constexpr double kPanel = 150;

struct Panel {
  const char* label;
  std::function<double(const traj::State&)> value;
  std::optional<double> limit;
  const char* colour;
};

void draw(Svg& svg, const traj::Trajectory& trajectory, const Panel& panel, double top, bool last) {
  const double end = traj::duration(trajectory);
  std::vector<Point> curve;
  double high = panel.limit.value_or(0);
  for (int i = 0; i <= kSamples; ++i) {
    const double t = end * i / kSamples;
    curve.push_back({t, panel.value(traj::evaluate(trajectory, t))});
    high = std::max(high, curve.back().y);
  }
  const Frame frame{80, top, 800, kPanel, {0, 0}, {end, high > 0 ? high * 1.08 : 1}};
  for (Point& p : curve) p = frame.at(p);
  double t = 0;
  for (const traj::Segment& s : trajectory.segments) {
    t += s.duration;
    const double x = frame.at({std::min(t, end), 0}).x;
    svg.polyline({{x, top}, {x, top + kPanel}}, "stroke=\"#00000018\" stroke-width=\"1\"");
  }
  if (panel.limit) {
    svg.polyline({frame.at({0, *panel.limit}), frame.at({end, *panel.limit})},
                 "stroke=\"#555\" stroke-width=\"1\" stroke-dasharray=\"6 4\"");
  }
  svg.polyline(curve, fmt::format("stroke=\"{}\" stroke-width=\"2\"", panel.colour));
  svg.axes(frame, last ? "time, s" : "", panel.label);
}

}  // namespace

std::string motion_profile(const traj::TrajectoryRecord& record) {
  const traj::Limits& limits = record.limits;
  const Panel panels[] = {
      {"z, m", [](const traj::State& s) { return s.position.z(); }, {}, "#0072b2"},
      {"speed, m/s", [](const traj::State& s) { return s.velocity.norm(); }, limits.vmax,
       "#009e73"},
      {"accel., m/s\u00b2", [](const traj::State& s) { return s.acceleration.norm(); }, limits.amax,
       "#d55e00"},
      {"jerk, m/s\u00b3", [](const traj::State& s) { return s.jerk.norm(); }, limits.jmax,
       "#cc79a7"},
  };
  Svg svg(910, 50 + 4 * (kPanel + 30) + 30);
  svg.text(
      {80, 32},
      fmt::format("{}: {:.2f} s, {} segments{}", record.id, traj::duration(record.trajectory),
                  record.trajectory.segments.size(), record.rung.empty() ? "" : ", " + record.rung),
      18);
  double top = 50;
  for (const Panel& panel : panels) {
    draw(svg, record.trajectory, panel, top, &panel == std::end(panels) - 1);
    top += kPanel + 30;
  }
  return svg.str();
}

}  // namespace plot
