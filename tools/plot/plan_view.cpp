#include "plan_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "svg.h"

namespace plot {
namespace {

constexpr double kSide = 900;  // pixels of the longer side of the map

// Light sand to dark slate: tops further up are darker, and paths stand out on all of them.
std::string shade(double t) {
  const std::array<double, 3> low = {233, 228, 214};
  const std::array<double, 3> high = {58, 66, 82};
  const auto mix = [&](int i) { return static_cast<int>(low[i] + (high[i] - low[i]) * t); };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2));
}

Frame frame_for(const geom::Aabb& bounds) {
  const double dx = bounds.max.x() - bounds.min.x();
  const double dy = bounds.max.y() - bounds.min.y();
  const double scale = kSide / std::max(dx, dy);
  return {80,
          50,
          dx * scale,
          dy * scale,
          {bounds.min.x(), bounds.min.y()},
          {bounds.max.x(), bounds.max.y()}};
}

geom::Aabb in_enu(geom::Axes axes, const geom::Aabb& box) {
  return {geom::to_enu(axes, box.min), geom::to_enu(axes, box.max)};
}

void draw_boxes(Svg& svg, const Frame& frame, const geom::BoxMap& map) {
  const geom::Axes axes = map.spec().frame.axes;
  const double top = map.spec().bounds.max.z();
  const double floor = map.spec().bounds.min.z();
  std::vector<std::size_t> order(map.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return map.boxes()[a].max.z() < map.boxes()[b].max.z();
  });
  for (const std::size_t i : order) {
    const geom::Aabb box = in_enu(axes, map.boxes()[i]);
    const Point low = frame.at({box.min.x(), box.min.y()});
    const Point high = frame.at({box.max.x(), box.max.y()});
    const double t = std::clamp((box.max.z() - floor) / std::max(top - floor, 1e-9), 0.0, 1.0);
    svg.rectangle({low.x, high.y}, high.x - low.x, low.y - high.y,
                  fmt::format("fill=\"{}\" stroke=\"#00000022\" stroke-width=\"0.5\"", shade(t)));
  }
}

void draw_path(Svg& svg, const Frame& frame, geom::Axes axes, const geom::Polyline& path) {
  std::vector<Point> points;
  for (const geom::Vec3& p : path) {
    const geom::Vec3 enu = geom::to_enu(axes, p);
    points.push_back(frame.at({enu.x(), enu.y()}));
  }
  svg.polyline(points, "stroke=\"#ffffff\" stroke-width=\"6\" stroke-linejoin=\"round\"");
  svg.polyline(points, "stroke=\"#d55e00\" stroke-width=\"3\" stroke-linejoin=\"round\"");
  for (const Point& p : points) svg.circle(p, 3, "fill=\"#d55e00\"");
  svg.circle(points.front(), 7, "fill=\"#009e73\" stroke=\"#ffffff\" stroke-width=\"2\"");
  svg.circle(points.back(), 7, "fill=\"#0072b2\" stroke=\"#ffffff\" stroke-width=\"2\"");
}

void draw_key(Svg& svg, const Frame& frame, const geom::BoxMap& map) {
  const double x = frame.left + frame.width + 20;
  constexpr int kSteps = 24;
  for (int i = 0; i < kSteps; ++i) {
    svg.rectangle({x, frame.top + 30 + (kSteps - 1 - i) * 8.0}, 18, 8,
                  fmt::format("fill=\"{}\"", shade(i / (kSteps - 1.0))));
  }
  svg.text({x, frame.top + 20}, "top, m", 12);
  svg.text({x + 24, frame.top + 40}, fmt::format("{:.0f}", map.spec().bounds.max.z()), 12);
  svg.text({x + 24, frame.top + 30 + kSteps * 8.0},
           fmt::format("{:.0f}", map.spec().bounds.min.z()), 12);
  svg.circle({x + 9, frame.top + 260}, 7, "fill=\"#009e73\"");
  svg.text({x + 24, frame.top + 264}, "start", 12);
  svg.circle({x + 9, frame.top + 284}, 7, "fill=\"#0072b2\"");
  svg.text({x + 24, frame.top + 288}, "goal", 12);
}

}  // namespace

std::string plan_view(const geom::BoxMap& map, std::span<const geom::PathRecord> paths) {
  const geom::Axes axes = map.spec().frame.axes;
  const Frame frame = frame_for(in_enu(axes, map.spec().bounds));
  Svg svg(frame.left + frame.width + 90, frame.top + frame.height + 60);
  draw_boxes(svg, frame, map);
  std::size_t drawn = 0;
  double length = 0;
  for (const geom::PathRecord& path : paths) {
    if (path.points.empty()) continue;
    draw_path(svg, frame, axes, path.points);
    length += geom::length(path.points);
    ++drawn;
  }
  svg.axes(frame, "east, m", "north, m");
  draw_key(svg, frame, map);
  std::string title = fmt::format("{} boxes", map.size());
  if (drawn == 1) title += fmt::format(", path of {:.1f} m", length);
  if (drawn > 1) title += fmt::format(", {} paths, {:.1f} m in all", drawn, length);
  svg.text({frame.left, 32}, title, 18);
  return svg.str();
}

}  // namespace plot
