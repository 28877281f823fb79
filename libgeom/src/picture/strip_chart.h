#pragma once

// A value over time as part of a picture, with a cursor at the time that is shown.

#include <functional>
#include <string>

#include "geom/picture/picture.h"

namespace geom::picture {

struct Chart {
  std::string label;  // with the unit
  double begin = 0;   // seconds
  double end = 1;
  std::function<double(double)> value;
};

class StripChart {
 public:
  // Samples the value once a pixel.
  StripChart(const Chart& chart, int width, int height);

  Picture at(double time) const;

 private:
  double x_of(double time) const;

  Chart chart_;
  Picture base_;
  double left_ = 0;
  double right_ = 0;
  double top_ = 0;
  double bottom_ = 0;
  double most_ = 1;
};

}  // namespace geom::picture
