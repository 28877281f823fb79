#include "svg.h"

#include <fmt/format.h>

#include "geom/text/markup.h"
#include "ticks.h"

namespace plot {
namespace {

// Digits that a page can show; "-0" would differ between equal pictures.
std::string px(double value) {
  const std::string digits = fmt::format("{:.2f}", value);
  return digits == "-0.00" ? "0.00" : digits;
}

int y_ticks(const Frame& frame) { return frame.height > 300 ? 8 : 4; }

}  // namespace

Point Frame::at(Point data) const {
  return {left + (data.x - low.x) / (high.x - low.x) * width,
          top + height - (data.y - low.y) / (high.y - low.y) * height};
}

Svg::Svg(double width, double height) {
  body_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-family=\"sans-serif\">\n<rect width=\"{0}\" height=\"{1}\" "
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

void Svg::circle(Point center, double radius, std::string_view style) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", px(center.x), px(center.y),
                       px(radius), style);
}

void Svg::text(Point at, std::string_view words, double size, std::string_view anchor, double turn,
               std::string_view colour) {
  const std::string rotate =
      turn == 0 ? "" : fmt::format(" transform=\"rotate({} {} {})\"", turn, px(at.x), px(at.y));
  body_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\"{}>{}</text>\n",
      px(at.x), px(at.y), size, anchor, colour, rotate, geom::escaped_markup(words));
}

void Svg::text_on_white(Point at, std::string_view words, double size, std::string_view anchor) {
  body_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"#ffffff\" "
      "stroke=\"#ffffff\" stroke-width=\"4\" stroke-linejoin=\"round\">{}</text>\n",
      px(at.x), px(at.y), size, anchor, geom::escaped_markup(words));
  text(at, words, size, anchor);
}

void Svg::grid(const Frame& f) {
  const std::string_view line = "stroke=\"#e6e6e6\" stroke-width=\"1\"";
  for (const double x : ticks(f.low.x, f.high.x, 8)) {
    const Point p = f.at({x, f.low.y});
    polyline({p, {p.x, f.top}}, line);
  }
  for (const double y : ticks(f.low.y, f.high.y, y_ticks(f))) {
    const Point p = f.at({f.low.x, y});
    polyline({p, {f.left + f.width, p.y}}, line);
  }
}

void Svg::axes(const Frame& f, std::string_view x_label, std::string_view y_label) {
  const std::string_view line = "stroke=\"#444\" stroke-width=\"1\"";
  rectangle({f.left, f.top}, f.width, f.height, "fill=\"none\" stroke=\"#444\" stroke-width=\"1\"");
  for (const double x : ticks(f.low.x, f.high.x, 8)) {
    const Point p = f.at({x, f.low.y});
    polyline({p, {p.x, p.y + 5}}, line);
    text({p.x, p.y + 18}, fmt::format("{:g}", x), 12, "middle");
  }
  for (const double y : ticks(f.low.y, f.high.y, y_ticks(f))) {
    const Point p = f.at({f.low.x, y});
    polyline({p, {p.x - 5, p.y}}, line);
    text({p.x - 8, p.y + 4}, fmt::format("{:g}", y), 12, "end");
  }
  if (!x_label.empty()) text({f.left + f.width / 2, f.top + f.height + 36}, x_label, 13, "middle");
  text({f.left - 54, f.top + f.height / 2}, y_label, 13, "middle", -90);
}

double text_width(std::string_view words, double size) {
  double letters = 0;  // of UTF-8: bytes that begin one
  for (const char c : words) letters += (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  return 0.55 * size * letters;
}

}  // namespace plot
