#pragma once

// Text of SVG drawings: a page, shapes, and axes with ticks.

#include <string>
#include <string_view>
#include <vector>

namespace plot {

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

class Svg {
 public:
  Svg(double width, double height);

  void rectangle(Point corner, double width, double height, std::string_view style);
  void polyline(const std::vector<Point>& points, std::string_view style);
  // Closed outlines as one path, filled by the even-odd rule.
  void rings(const std::vector<std::vector<Point>>& rings, std::string_view style);
  void circle(Point center, double radius, std::string_view style);
  // `anchor` is start, middle or end; `turn` in degrees.
  void text(Point at, std::string_view words, double size, std::string_view anchor = "start",
            double turn = 0, std::string_view colour = "#222222");
  void text_on_white(Point at, std::string_view words, double size, std::string_view anchor);
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

}  // namespace plot
