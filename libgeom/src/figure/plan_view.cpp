#include "geom/figure/plan_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "geom/figure/palette.h"
#include "geom/figure/svg.h"
#include "geom/map/label_colour.h"
#include "geom/shape/joined_outlines.h"
#include "geom/text/counted.h"
#include "geom/text/excerpt.h"

namespace geom::figure {
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

constexpr std::size_t kFewBoxes = 20000;  // that are drawn one by one
constexpr int kShades = 24;               // of outlines around more
constexpr double kOutlineGrid = 0.1;      // pixels
constexpr double kOutlineTolerance = 0.15;
constexpr std::string_view kZoneStyle =
    "fill=\"#d55e00\" fill-opacity=\"0.12\" stroke=\"#a34700\" stroke-width=\"1.2\" "
    "stroke-dasharray=\"5 3\"";

// The boxes from above, those with the lowest tops first, and the keep-out volumes.
struct PlanBoxes {
  std::vector<geom::Aabb> solid;  // ENU
  std::vector<geom::Aabb> zones;
};

PlanBoxes plan_boxes(const geom::BoxMap& map) {
  PlanBoxes out;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const bool zone = geom::is_keep_out(map.labels()[map.label()[i]]);
    (zone ? out.zones : out.solid).push_back(geom::to_enu(map.spec().frame.axes, map.boxes()[i]));
  }
  std::stable_sort(out.solid.begin(), out.solid.end(),
                   [](const geom::Aabb& a, const geom::Aabb& b) { return a.max.z() < b.max.z(); });
  return out;
}

// How high a top is, of the heights of the map, 0 to 1.
double share_of_height(const geom::BoxMap& map, double top) {
  const geom::Aabb& bounds = map.spec().bounds;
  return std::clamp((top - bounds.min.z()) / std::max(bounds.max.z() - bounds.min.z(), 1e-9), 0.0,
                    1.0);
}

void draw_outlines(Svg& svg, const Frame& frame, std::span<const geom::Aabb> boxes,
                   std::string_view style) {
  const double metres = (frame.high.x - frame.low.x) / frame.width;  // of a pixel
  std::vector<std::vector<Point>> rings;
  for (const auto& ring :
       geom::joined_outlines(boxes, {kOutlineGrid * metres, kOutlineTolerance * metres})) {
    rings.emplace_back();
    for (const geom::Vec2& p : ring) rings.back().push_back(frame.at({p.x(), p.y()}));
  }
  svg.rings(rings, style);
}

// Of very many boxes the outlines around those of about one height.
void draw_shades(Svg& svg, const Frame& frame, const geom::BoxMap& map,
                 std::span<const geom::Aabb> boxes) {
  const auto shade_of = [&](const geom::Aabb& box) {
    return static_cast<int>(std::lround(share_of_height(map, box.max.z()) * (kShades - 1)));
  };
  for (std::size_t i = 0; i < boxes.size();) {
    std::size_t end = i + 1;
    while (end < boxes.size() && shade_of(boxes[end]) == shade_of(boxes[i])) ++end;
    draw_outlines(svg, frame, boxes.subspan(i, end - i),
                  fmt::format("fill=\"{}\" stroke=\"#00000033\" stroke-width=\"0.4\"",
                              shade(shade_of(boxes[i]) / (kShades - 1.0))));
    i = end;
  }
}

void draw_boxes(Svg& svg, const Frame& frame, const geom::BoxMap& map) {
  const PlanBoxes boxes = plan_boxes(map);
  if (boxes.solid.size() > kFewBoxes) {
    draw_shades(svg, frame, map, boxes.solid);
  } else {
    for (const geom::Aabb& box : boxes.solid) {
      const Point low = frame.at({box.min.x(), box.min.y()});
      const Point high = frame.at({box.max.x(), box.max.y()});
      svg.rectangle({low.x, high.y}, high.x - low.x, low.y - high.y,
                    fmt::format("fill=\"{}\" stroke=\"#00000022\" stroke-width=\"0.5\"",
                                shade(share_of_height(map, box.max.z()))));
    }
  }
  draw_outlines(svg, frame, boxes.zones, kZoneStyle);
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
  const std::string_view colour = figure::colour(i);
  if (i == 0) {
    svg.polyline(points, "stroke=\"#ffffff\" stroke-width=\"7\" stroke-linejoin=\"round\"");
  }
  svg.polyline(points, fmt::format("stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"",
                                   colour, width_of(i)));
  if (line.corners) {
    for (const Point& p : points) svg.circle(p, 2.6, fmt::format("fill=\"{}\"", colour));
  }
}

// A ring, open in the middle, so that the dot of an end at the same place is seen in it.
void draw_start(Svg& svg, Point at) {
  svg.circle(at, 7.5, "fill=\"none\" stroke=\"#ffffff\" stroke-width=\"5\"");
  svg.circle(at, 7.5, "fill=\"none\" stroke=\"#222222\" stroke-width=\"2\"");
}

void draw_end(Svg& svg, Point at) {
  svg.circle(at, 4, "fill=\"#222222\" stroke=\"#ffffff\" stroke-width=\"1.5\"");
}

// Above all lines: rings first, and dots in them.
void draw_ends(Svg& svg, const Frame& frame, std::span<const PlanLine> lines) {
  for (const PlanLine& line : lines) {
    if (!line.points.empty()) draw_start(svg, on_page(frame, {line.points.front()})[0]);
  }
  for (const PlanLine& line : lines) {
    if (!line.points.empty()) draw_end(svg, on_page(frame, {line.points.back()})[0]);
  }
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

bool is_beyond(const Aabb& bounds, const Vec3& low, const Vec3& high) {
  return (low.head<2>().array() < bounds.min.head<2>().array()).any() ||
         (high.head<2>().array() > bounds.max.head<2>().array()).any();
}

// Whether a box, a tree or a line reaches beyond the bounds, which are all that the page shows.
bool any_beyond(const BoxMap& map, std::span<const PlanTree> trees,
                std::span<const PlanLine> lines) {
  const Aabb bounds = to_enu(map.spec().frame.axes, map.spec().bounds);
  const auto outside = [&](const Vec3& p) { return is_beyond(bounds, p, p); };
  for (const Aabb& box : map.boxes()) {
    const Aabb shown = to_enu(map.spec().frame.axes, box);
    if (is_beyond(bounds, shown.min, shown.max)) return true;
  }
  for (const PlanTree& tree : trees) {
    for (const auto& [a, b] : tree.edges) {
      if (outside(a) || outside(b)) return true;
    }
  }
  return std::any_of(lines.begin(), lines.end(), [&](const PlanLine& line) {
    return std::any_of(line.points.begin(), line.points.end(), outside);
  });
}

// "31 boxes (2 there for a time, shown as always there), 1 path of 31.0 m"
std::string title_of(const BoxMap& map, std::span<const PlanLine> lines, bool beyond) {
  std::string out = counted(map.size(), "box", "boxes");
  if (const std::size_t timed = map.timed().size()) {
    out += fmt::format(" ({} there for a time, shown as always there)", timed);
  }
  out += counts_of(lines);
  return beyond ? out + "; what is beyond the map's bounds is not shown" : out;
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
  svg.text({x, y}, "top of obstacle, m");
  svg.text({x + 24, y + 20}, fmt::format("{:.0f}", map.spec().bounds.max.z()));
  svg.text({x + 24, y + 10 + kSteps * 6.0}, fmt::format("{:.0f}", map.spec().bounds.min.z()));
}

void draw_key(Svg& svg, const Frame& frame, const geom::BoxMap& map,
              std::span<const PlanLine> lines) {
  const double x = frame.left + frame.width + 20;
  draw_heights(svg, x, frame.top + 14, map);
  if (std::any_of(map.labels().begin(), map.labels().end(), geom::is_keep_out)) {
    svg.rectangle({x, frame.top + 179}, 18, 9, kZoneStyle);
    svg.text({x + 28, frame.top + 188}, "keep-out");
  }
  if (lines.empty()) return;
  double y = frame.top + 204;
  draw_start(svg, {x + 9, y});
  svg.text({x + 28, y + 4}, "start");
  draw_end(svg, {x + 9, y + 22});
  svg.text({x + 28, y + 26}, "end");
  y += 50;
  for (std::size_t i = 0; i < std::min(lines.size(), kNamed); ++i, y += 20) {
    svg.polyline({{x, y}, {x + 22, y}},
                 fmt::format("stroke=\"{}\" stroke-width=\"{}\"", colour(i), width_of(i)));
    svg.text({x + 28, y + 4}, label_of(lines[i]));
  }
  if (lines.size() > kNamed) {
    svg.text({x + 28, y + 4}, fmt::format("and {} more", lines.size() - kNamed));
  }
}

}  // namespace

std::string plan_view(const geom::BoxMap& map, std::span<const PlanTree> trees,
                      std::span<const PlanLine> lines) {
  const geom::Axes axes = map.spec().frame.axes;
  const Frame frame = frame_for(geom::to_enu(axes, map.spec().bounds));
  const bool beyond = any_beyond(map, trees, lines);
  const std::string title = title_of(map, lines, beyond);
  Svg svg(std::max(frame.left + frame.width + key_width(lines),
                   frame.left + text_width(title, 16) + 20),
          frame.top + std::max(frame.height + 60, 470.0));
  if (beyond) svg.clip(frame);
  draw_boxes(svg, frame, map);
  for (const PlanTree& tree : trees) draw_tree(svg, frame, tree);
  for (std::size_t i = 0; i < lines.size(); ++i) draw_line(svg, frame, lines[i], i);
  draw_ends(svg, frame, lines);
  if (beyond) svg.unclip();
  svg.axes(frame, "east, m", "north, m");
  draw_key(svg, frame, map, lines);
  svg.text({frame.left, 32}, title, {.size = 16});
  return svg.str();
}

std::string plan_view(std::span<const PlanLine> lines) {
  const Vec3& any = lines.front().points.front();
  Aabb bounds{any, any};
  for (const PlanLine& line : lines) {
    for (const Vec3& p : line.points) bounds = {bounds.min.cwiseMin(p), bounds.max.cwiseMax(p)};
  }
  const double room = 0.1 + 0.05 * (bounds.max - bounds.min).maxCoeff();
  bounds.min.array() -= room;
  bounds.max.array() += room;
  return plan_view(BoxMap({.bounds = bounds, .bounds_from = "source", .history = "[]"}, {}), {},
                   lines);
}

}  // namespace geom::figure
