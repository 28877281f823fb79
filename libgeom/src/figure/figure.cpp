#include "geom/figure/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "geom/figure/palette.h"

namespace geom::figure {
namespace {

constexpr double kLeft = 84;
constexpr double kWidth = 760;
constexpr double kRight = 26;
constexpr double kTop = 56;
constexpr double kGap = 40;  // with the legend of the panel below
constexpr double kBottom = 56;
constexpr std::size_t kColumns = 1500;

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;

  void hold(double v) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
};

// A little room around; never empty, also for constant curves.
Range with_room(Range r, bool from_zero) {
  if (from_zero) r.hold(0);
  const double room = r.high > r.low ? 0.07 * (r.high - r.low) : std::max(1e-3, std::abs(r.low));
  return {from_zero && r.low == 0 ? 0 : r.low - room, r.high + room};
}

Range x_range(const Figure& figure) {
  Range x;
  for (const Panel& panel : figure.panels) {
    for (const Series& s : panel.series) {
      if (s.points.empty()) continue;
      x.hold(s.points.front().x);
      x.hold(s.points.back().x);
    }
  }
  if (!(x.high > x.low)) x.high = x.low + 1;
  return x;
}

Range y_range(const Panel& panel) {
  Range y;
  for (const Series& s : panel.series) {
    for (const Point& p : s.points) y.hold(p.y);
  }
  for (const Level& level : panel.levels) y.hold(level.value);
  return with_room(y, panel.from_zero);
}

struct Swatch {
  std::string_view label;
  std::string style;
};

std::vector<Swatch> legend_of(const Panel& panel) {
  std::vector<Swatch> out;
  for (const Series& s : panel.series) {
    if (s.label.empty()) continue;
    out.push_back({s.label, fmt::format("stroke=\"{}\" stroke-width=\"2.5\"{}", s.colour,
                                        s.dashed ? " stroke-dasharray=\"5 3\"" : "")});
  }
  for (const Level& level : panel.levels) {
    out.push_back({level.label, fmt::format("stroke=\"{}\" stroke-width=\"1.4\" "
                                            "stroke-dasharray=\"7 4\"",
                                            kLimit)});
  }
  return out;
}

// Swatches and words, ending at the right border above the panel.
void draw_legend(Svg& svg, const Frame& frame, const Panel& panel) {
  const std::vector<Swatch> legend = legend_of(panel);
  double x = frame.left + frame.width;
  const double y = frame.top - 8;
  for (auto s = legend.rbegin(); s != legend.rend(); ++s) {
    x -= text_width(s->label, 12);
    svg.text({x, y + 4}, s->label);
    svg.polyline({{x - 32, y}, {x - 8, y}}, s->style);
    x -= 48;
  }
  if (panel.note.empty()) return;
  svg.text({frame.left, y + 4}, panel.note, {.colour = panel.shaded.empty() ? kInk : kWarning});
}

void draw_level(Svg& svg, const Frame& frame, const Level& level) {
  const Point a = frame.at({frame.low.x, level.value});
  svg.polyline({a, {a.x + frame.width, a.y}},
               fmt::format("stroke=\"{}\" stroke-width=\"1.2\" stroke-dasharray=\"7 4\"", kLimit));
}

// At least as wide as a line, so that the shortest is seen.
void draw_shaded(Svg& svg, const Frame& frame, const Span& span) {
  const Point low = frame.at(span.low);
  const Point high = frame.at(span.high);
  svg.rectangle({low.x, high.y}, std::max(1.5, high.x - low.x), low.y - high.y,
                fmt::format("fill=\"{}\" fill-opacity=\"0.6\"", kWarning));
}

void draw_mark(Svg& svg, const Frame& frame, const Mark& mark) {
  const Point at = frame.at(mark.at);
  svg.circle(at, 4, fmt::format("fill=\"{}\" stroke=\"#ffffff\" stroke-width=\"1.5\"", kInk));
  const bool right = at.x < frame.left + 0.6 * frame.width;
  if (mark.label.empty()) return;
  const double y = std::max(at.y - 8, frame.top + 14);
  svg.text_on_white({at.x + (right ? 9 : -9), y}, mark.label, {.anchor = right ? "start" : "end"});
}

// The last panel has the label of the x axis.
void draw_panel(Svg& svg, const Figure& figure, const Panel& panel, const Frame& frame) {
  svg.grid(frame);
  for (const double x : figure.joints) {
    const double at = frame.at({x, 0}).x;
    svg.polyline({{at, frame.top + frame.height - 6}, {at, frame.top + frame.height}},
                 "stroke=\"#999\" stroke-width=\"1\"");
  }
  for (const Span& span : panel.shaded) draw_shaded(svg, frame, span);
  for (const Level& level : panel.levels) draw_level(svg, frame, level);
  for (const Series& s : panel.series) {
    std::vector<Point> curve = thinned(s.points, kColumns);
    for (Point& p : curve) p = frame.at(p);
    svg.polyline(curve,
                 fmt::format("stroke=\"{}\" stroke-width=\"1.8\" stroke-linejoin=\"round\"{}",
                             s.colour, s.dashed ? " stroke-dasharray=\"5 3\"" : ""));
  }
  for (const Mark& mark : panel.marks) draw_mark(svg, frame, mark);
  svg.axes(frame, &panel == &figure.panels.back() ? figure.x_label : "", panel.label);
  draw_legend(svg, frame, panel);
}

}  // namespace

std::vector<Point> thinned(const std::vector<Point>& points, std::size_t columns) {
  if (points.size() <= 4 * columns) return points;
  std::vector<Point> out;
  const auto by_height = [](const Point& a, const Point& b) { return a.y < b.y; };
  for (std::size_t c = 0; c < columns; ++c) {
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(c * points.size() / columns);
    const auto end =
        points.begin() + static_cast<std::ptrdiff_t>((c + 1) * points.size() / columns);
    auto [low, high] = std::minmax_element(first, end, by_height);
    if (high < low) std::swap(low, high);
    out.push_back(*first);
    if (low != first) out.push_back(*low);
    if (high != low && high != first) out.push_back(*high);
    if (end - 1 > high) out.push_back(*(end - 1));
  }
  return out;
}

std::string drawn(const Figure& figure) {
  double below = kTop + kBottom - kGap;
  for (const Panel& panel : figure.panels) below += panel.height + kGap;
  Svg svg(std::max(kLeft + kWidth, kLeft + text_width(figure.title, 16)) + kRight, below);
  svg.text({kLeft, 26}, figure.title, {.size = 16});
  const Range x = x_range(figure);
  double top = kTop;
  for (const Panel& panel : figure.panels) {
    const Range y = y_range(panel);
    const Frame frame{kLeft,     top, kWidth, panel.height, {x.low, y.low}, {x.high, y.high},
                      panel.near};
    draw_panel(svg, figure, panel, frame);
    top += panel.height + kGap;
  }
  return svg.str();
}

}  // namespace geom::figure
