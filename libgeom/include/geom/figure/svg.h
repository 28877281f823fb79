#pragma once

// Text of SVG drawings: a page, shapes, and axes with ticks.
//
// Example:
//   geom::figure::Svg svg(200, 120);
//   const geom::figure::Frame frame{40, 20, 140, 60, {0, 0}, {10, 5}};
//   svg.polyline({frame.at({0, 1}), frame.at({10, 4})}, "stroke=\"#0072b2\"");
//   svg.axes(frame, "time, s", "speed, m/s");
//   assert(svg.str().starts_with("<svg"));

#include <string>
#include <string_view>
#include <vector>

namespace geom::figure {

struct Point {
  double x = 0;
  double y = 0;
};

// A rectangle on the page, in pixels, showing data from `low` to `high`; y grows upward. With
// `near`, y up to that has 45 % of the height, and what is more is logarithmic.
struct Frame {
  double left, top, width, height;
  Point low, high;
  double near = 0;

  Point at(Point data) const;
};

struct TextStyle {
  double size = 12;                   // pixels
  std::string_view anchor = "start";  // or middle or end: what of the words is at the point
  double turn = 0;                    // degrees
  std::string_view colour = "#222222";
};

class Svg {
 public:
  Svg(double width, double height);

  void rectangle(Point corner, double width, double height, std::string_view style);
  void polyline(const std::vector<Point>& points, std::string_view style);
  // Closed outlines as one path, filled by the even-odd rule.
  void rings(const std::vector<std::vector<Point>>& rings, std::string_view style);
  void circle(Point center, double radius, std::string_view style);
  void text(Point at, std::string_view words, const TextStyle& style = {});
  void text_on_white(Point at, std::string_view words, const TextStyle& style = {});
  // What is drawn until unclip() is seen within the frame only; once a page.
  void clip(const Frame& frame);
  void unclip();
  // Faint lines at the ticks; drawn before what stands on them.
  void grid(const Frame& frame);
  // Border, ticks at round values of x, and its label with the unit.
  void x_axis(const Frame& frame, std::string_view label);
  // The same, with y.
  void axes(const Frame& frame, std::string_view x_label, std::string_view y_label);

  std::string str() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
};

// About how wide words are, in pixels, in the usual sans-serif fonts.
double text_width(std::string_view words, double size);

}  // namespace geom::figure
