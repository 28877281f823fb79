#include "geom/figure/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geom/figure/ticks.h"
#include "geom/text/markup.h"

namespace geom::figure {
namespace {

// Digits that a page can show; "-0" would differ between equal pictures.
std::string px(double value) {
  const std::string digits = fmt::format("{:.2f}", value);
  return digits == "-0.00" ? "0.00" : digits;
}

constexpr double kNearShare = 0.45;  // of a frame's height

bool is_broken(const Frame& f) { return f.near > 0 && f.near > f.low.y && f.near < f.high.y; }

// How far up a value stands, 0 to 1.
double share_of_height(const Frame& f, double y) {
  if (!is_broken(f)) return (y - f.low.y) / (f.high.y - f.low.y);
  if (y <= f.near) return kNearShare * (y - f.low.y) / (f.near - f.low.y);
  return kNearShare + (1 - kNearShare) * std::log(y / f.near) / std::log(f.high.y / f.near);
}

std::vector<double> x_marks(const Frame& f) {
  return ticks(f.low.x, f.high.x, std::clamp(static_cast<int>(f.width / 80), 1, 8));
}

std::vector<double> y_marks(const Frame& f) {
  const int most = std::clamp(static_cast<int>(f.height / 30), 1, f.height > 300 ? 8 : 4);
  if (!is_broken(f)) return ticks(f.low.y, f.high.y, most);
  std::vector<double> out = ticks(f.low.y, f.near, 4);
  for (double power = 1e-6; power <= f.high.y; power *= 10) {
    for (const double lead : {1.0, 2.0, 5.0}) {
      const double v = lead * power;
      if (v > f.near * 1.01 && v <= f.high.y) out.push_back(v);
    }
  }
  return out;
}

// As many digits as tell the marks apart, also far from zero.
std::string mark_words(double value, double step) {
  if (std::abs(value) < 1e5) return fmt::format("{:g}", value);
  const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  return fmt::format("{:.{}f}", value, digits);
}

std::vector<std::string> words_of(const std::vector<double>& marks) {
  const double step = marks.size() > 1 ? marks[1] - marks[0] : 1;
  std::vector<std::string> out;
  for (const double v : marks) out.push_back(mark_words(v, step));
  return out;
}

}  // namespace

Point Frame::at(Point data) const {
  return {left + (data.x - low.x) / (high.x - low.x) * width,
          top + height - share_of_height(*this, data.y) * height};
}

Svg::Svg(double width, double height) {
  body_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-family=\"system-ui, -apple-system, 'Segoe UI', Roboto, 'Noto Sans', "
      "'DejaVu Sans', sans-serif\">\n<rect width=\"{0}\" height=\"{1}\" "
      "fill=\"#ffffff\"/>\n",
      width, height);
}

void Svg::rectangle(Point corner, double width, double height, std::string_view style) {
  body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>\n", px(corner.x),
                       px(corner.y), px(width), px(height), style);
}

void Svg::polyline(const std::vector<Point>& points, std::string_view style) {
  body_ += "<polyline points=\"";
  for (const Point& p : points) body_ += px(p.x) + ',' + px(p.y) + ' ';
  body_ += fmt::format("\" fill=\"none\" {}/>\n", style);
}

void Svg::rings(const std::vector<std::vector<Point>>& rings, std::string_view style) {
  if (rings.empty()) return;
  // In steps from corner to corner, of whole tenths, so that rounding does not add up.
  const auto tenths = [](double v) { return std::llround(v * 10); };
  const auto digits = [](long long v) { return fmt::format("{:g}", 0.1 * static_cast<double>(v)); };
  body_ += "<path d=\"";
  for (const std::vector<Point>& ring : rings) {
    long long x = 0;
    long long y = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const long long right = tenths(ring[i].x);
      const long long down = tenths(ring[i].y);
      if (i > 0 && right == x && down == y) continue;
      body_ += i == 0 ? "M" : "l";
      body_ += digits(i == 0 ? right : right - x) + ' ' + digits(i == 0 ? down : down - y);
      x = right;
      y = down;
    }
    body_ += 'z';
  }
  body_ += fmt::format("\" fill-rule=\"evenodd\" {}/>\n", style);
}

void Svg::circle(Point center, double radius, std::string_view style) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", px(center.x), px(center.y),
                       px(radius), style);
}

void Svg::text(Point at, std::string_view words, const TextStyle& style) {
  const std::string rotate = style.turn == 0 ? ""
                                             : fmt::format(" transform=\"rotate({} {} {})\"",
                                                           style.turn, px(at.x), px(at.y));
  body_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\"{}>{}</text>\n",
      px(at.x), px(at.y), style.size, style.anchor, style.colour, rotate,
      geom::escaped_markup(words));
}

void Svg::text_on_white(Point at, std::string_view words, const TextStyle& style) {
  body_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"#ffffff\" "
      "stroke=\"#ffffff\" stroke-width=\"4\" stroke-linejoin=\"round\">{}</text>\n",
      px(at.x), px(at.y), style.size, style.anchor, geom::escaped_markup(words));
  text(at, words, style);
}

void Svg::clip(const Frame& frame) {
  body_ += fmt::format(
      "<clipPath id=\"frame\"><rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" "
      "height=\"{:.2f}\"/></clipPath>\n<g clip-path=\"url(#frame)\">\n",
      frame.left, frame.top, frame.width, frame.height);
}

void Svg::unclip() { body_ += "</g>\n"; }

void Svg::grid(const Frame& f) {
  const std::string_view line = "stroke=\"#e6e6e6\" stroke-width=\"1\"";
  for (const double x : x_marks(f)) {
    const Point p = f.at({x, f.low.y});
    polyline({p, {p.x, f.top}}, line);
  }
  for (const double y : y_marks(f)) {
    const Point p = f.at({f.low.x, y});
    polyline({p, {f.left + f.width, p.y}}, line);
  }
}

void Svg::x_axis(const Frame& f, std::string_view label) {
  const std::string_view line = "stroke=\"#444\" stroke-width=\"1\"";
  rectangle({f.left, f.top}, f.width, f.height, "fill=\"none\" stroke=\"#444\" stroke-width=\"1\"");
  const std::vector<double> across = x_marks(f);
  const std::vector<std::string> across_words = words_of(across);
  for (std::size_t i = 0; i < across.size(); ++i) {
    const Point p = f.at({across[i], f.low.y});
    polyline({p, {p.x, p.y + 5}}, line);
    text({p.x, p.y + 18}, across_words[i], {.anchor = "middle"});
  }
  if (!label.empty())
    text({f.left + f.width / 2, f.top + f.height + 36}, label, {.size = 13, .anchor = "middle"});
}

void Svg::axes(const Frame& f, std::string_view x_label, std::string_view y_label) {
  x_axis(f, x_label);
  const std::string_view line = "stroke=\"#444\" stroke-width=\"1\"";
  const std::vector<double> up = y_marks(f);
  const std::vector<std::string> up_words = words_of(up);
  double widest = 0;
  for (std::size_t i = 0; i < up.size(); ++i) {
    const Point p = f.at({f.low.x, up[i]});
    polyline({p, {p.x - 5, p.y}}, line);
    text({p.x - 8, p.y + 4}, up_words[i], {.anchor = "end"});
    widest = std::max(widest, text_width(up_words[i], 12));
  }
  text({f.left - std::max(54.0, widest + 16), f.top + f.height / 2}, y_label,
       {.size = 13, .anchor = "middle", .turn = -90});
}

double text_width(std::string_view words, double size) {
  double letters = 0;  // of UTF-8: bytes that begin one
  for (const char c : words) letters += (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  return 0.6 * size * letters;
}

}  // namespace geom::figure
