#pragma once

// An interval as SDF says it, by a middle and a length, so that it is read back as it was.

namespace geom {

struct SdfInterval {
  double place = 0;   // of the link; the middle is place + offset
  double offset = 0;  // of the collision in it: often 0
  double length = 0;
  bool same =
      true;  // what is read back, rounded outward, is the interval itself; else it is larger
};

// Of finite doubles, low <= high. What is not the same reaches across 0: its length takes a digit
// more than a double has. An interval that was read from a middle and a length is the same.
SdfInterval sdf_interval(double low, double high);

}  // namespace geom
