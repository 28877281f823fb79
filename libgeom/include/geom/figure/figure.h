#pragma once

// Curves in panels one above the other that share their x axis, as SVG.
//
// Example:
//   #include "geom/figure/palette.h"
//   geom::figure::Panel speed{.label = "speed, m/s"};
//   speed.series = {{"", geom::figure::colour(0), {{0, 0}, {2, 3}, {4, 0}}}};
//   const std::string svg = geom::figure::drawn({"A flight", "time, s", {speed}, {}});
//   assert(svg.find("A flight") != std::string::npos);

#include <string>
#include <vector>

#include "geom/figure/svg.h"

namespace geom::figure {

struct Series {
  std::string label;  // empty: not in the legend
  std::string_view colour;
  std::vector<Point> points;  // x ascending
  bool dashed = false;
};

// A horizontal line that curves should stay below (or above).
struct Level {
  std::string label;
  double value = 0;
};

struct Mark {  // a point that is pointed out
  Point at;
  std::string label;
};

struct Span {  // a stretch that is shaded: too little of something
  Point low;
  Point high;
};

struct Panel {
  std::string label;  // of the y axis, with the unit
  std::vector<Series> series;
  std::vector<Level> levels;
  std::vector<Mark> marks;
  bool from_zero = true;  // the y axis starts at 0
  double near = 0;        // > 0: the y axis shows what is less at large (Frame::near)
  std::vector<Span> shaded;
  std::string note;     // above the panel
  double height = 128;  // pixels
};

struct Figure {
  std::string title;
  std::string x_label;
  std::vector<Panel> panels;
  std::vector<double> joints;  // x of faint vertical lines
};

// Every panel has a series of at least one point (precondition).
std::string drawn(const Figure& figure);

// The same curve for a picture `columns` wide: of each column the first, lowest, highest and last
// point.
std::vector<Point> thinned(const std::vector<Point>& points, std::size_t columns);

}  // namespace geom::figure
