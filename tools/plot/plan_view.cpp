#include "plan_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "geom/text/counted.h"
#include "geom/text/excerpt.h"
#include "palette.h"
#include "svg.h"

namespace plot {
namespace {

constexpr std::size_t kNamed = 8;     // lines in the legend
constexpr double kSide = 900;         // pixels of the longer side of the map
constexpr double kKey = 200;          // pixels beside the map, or more for long names
constexpr std::size_t kLongest = 40;  // letters of a name in the legend

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
    const geom::Aabb box = geom::to_enu(axes, map.boxes()[i]);
    const Point low = frame.at({box.min.x(), box.min.y()});
    const Point high = frame.at({box.max.x(), box.max.y()});
    const double t = std::clamp((box.max.z() - floor) / std::max(top - floor, 1e-9), 0.0, 1.0);
    svg.rectangle({low.x, high.y}, high.x - low.x, low.y - high.y,
                  fmt::format("fill=\"{}\" stroke=\"#00000022\" stroke-width=\"0.5\"", shade(t)));
  }
}

std::vector<Point> on_page(const Frame& frame, const geom::Polyline& line) {
  std::vector<Point> points;
  for (const geom::Vec3& p : line) points.push_back(frame.at({p.x(), p.y()}));
  return points;
}

void draw_tree(Svg& svg, const Frame& frame, const PlanTree& tree) {
  for (const auto& [a, b] : tree.edges) {
    svg.polyline(on_page(frame, {a, b}), "stroke=\"#5b7fa6\" stroke-width=\"0.8\"");
  }
}

// Later lines are narrower, so that lines on top of each other are all seen.
double width_of(std::size_t i) { return std::max(1.6, 4.2 - 1.1 * static_cast<double>(i)); }

void draw_line(Svg& svg, const Frame& frame, const PlanLine& line, std::size_t i) {
  const std::vector<Point> points = on_page(frame, line.points);
  if (points.empty()) return;
  const std::string_view colour = plot::colour(i);
  if (i == 0) {
    svg.polyline(points, "stroke=\"#ffffff\" stroke-width=\"7\" stroke-linejoin=\"round\"");
  }
  svg.polyline(points, fmt::format("stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"",
                                   colour, width_of(i)));
  if (line.corners) {
    for (const Point& p : points) svg.circle(p, 2.6, fmt::format("fill=\"{}\"", colour));
  }
  svg.circle(points.front(), 6, "fill=\"#ffffff\" stroke=\"#222222\" stroke-width=\"2\"");
  svg.circle(points.back(), 6, "fill=\"#222222\" stroke=\"#ffffff\" stroke-width=\"2\"");
}

std::string label_of(const PlanLine& line) {
  return line.kind + ' ' + geom::excerpt(line.id, kLongest);
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kKinds = {
    {{"path", "paths"}, {"trajectory", "trajectories"}, {"flight", "flights"}}};

// "2 paths of 31.0 m in all, 1 flight of 15.2 m"
std::string counts_of(std::span<const PlanLine> lines) {
  std::string out;
  for (const auto& [one, many] : kKinds) {
    std::size_t count = 0;
    double length = 0;
    for (const PlanLine& line : lines) {
      if (line.kind != one) continue;
      ++count;
      length += geom::length(line.points);
    }
    if (count == 0) continue;
    out += fmt::format(", {} of {:.1f} m{}", geom::counted(count, one, many), length,
                       count > 1 ? " in all" : "");
  }
  return out;
}

double key_width(std::span<const PlanLine> lines) {
  double out = kKey;
  for (const PlanLine& line : lines.first(std::min(lines.size(), kNamed))) {
    out = std::max(out, 20 + 28 + text_width(label_of(line), 12) + 12);
  }
  return out;
}

void draw_heights(Svg& svg, double x, double y, const geom::BoxMap& map) {
  constexpr int kSteps = 24;
  for (int i = 0; i < kSteps; ++i) {
    svg.rectangle({x, y + 10 + (kSteps - 1 - i) * 6.0}, 18, 6,
                  fmt::format("fill=\"{}\"", shade(i / (kSteps - 1.0))));
  }
  svg.text({x, y}, "top of obstacle, m", 12);
  svg.text({x + 24, y + 20}, fmt::format("{:.0f}", map.spec().bounds.max.z()), 12);
  svg.text({x + 24, y + 10 + kSteps * 6.0}, fmt::format("{:.0f}", map.spec().bounds.min.z()), 12);
}

void draw_key(Svg& svg, const Frame& frame, const geom::BoxMap& map,
              std::span<const PlanLine> lines) {
  const double x = frame.left + frame.width + 20;
  draw_heights(svg, x, frame.top + 14, map);
  if (lines.empty()) return;
  double y = frame.top + 204;
  svg.circle({x + 9, y}, 6, "fill=\"#ffffff\" stroke=\"#222222\" stroke-width=\"2\"");
  svg.text({x + 28, y + 4}, "start", 12);
  svg.circle({x + 9, y + 22}, 6, "fill=\"#222222\"");
  svg.text({x + 28, y + 26}, "end", 12);
  y += 50;
  for (std::size_t i = 0; i < std::min(lines.size(), kNamed); ++i, y += 20) {
    svg.polyline({{x, y}, {x + 22, y}},
                 fmt::format("stroke=\"{}\" stroke-width=\"{}\"", colour(i), width_of(i)));
    svg.text({x + 28, y + 4}, label_of(lines[i]), 12);
  }
  if (lines.size() > kNamed) {
    svg.text({x + 28, y + 4}, fmt::format("and {} more", lines.size() - kNamed), 12);
  }
}

}  // namespace

std::string plan_view(const geom::BoxMap& map, std::span<const PlanTree> trees,
                      std::span<const PlanLine> lines) {
  const geom::Axes axes = map.spec().frame.axes;
  const Frame frame = frame_for(geom::to_enu(axes, map.spec().bounds));
  const std::string title = geom::counted(map.size(), "box", "boxes") + counts_of(lines);
  Svg svg(std::max(frame.left + frame.width + key_width(lines),
                   frame.left + text_width(title, 16) + 20),
          frame.top + std::max(frame.height + 60, 470.0));
  draw_boxes(svg, frame, map);
  for (const PlanTree& tree : trees) draw_tree(svg, frame, tree);
  for (std::size_t i = 0; i < lines.size(); ++i) draw_line(svg, frame, lines[i], i);
  svg.axes(frame, "east, m", "north, m");
  draw_key(svg, frame, map, lines);
  svg.text({frame.left, 32}, title, 16);
  return svg.str();
}

}  // namespace plot
