#include "sdf_interval.h"

#include <algorithm>
#include <cmath>

#include "geom/base/rounding.h"
#include "shape/exact_sum.h"

namespace geom {
namespace {

ExactSum end_of(const SdfInterval& i, double side) {
  ExactSum sum;
  sum.add(i.place);
  sum.add(i.offset);
  sum.add(side * 0.5 * i.length);
  return sum;
}

bool is_read_as(const SdfInterval& i, double low, double high) {
  return end_of(i, -1).down() == low && end_of(i, 1).up() == high;
}

// The middle is `end` + half the length (which may be below 0) + `shift`, in two doubles; without a
// shift exactly.
SdfInterval placed(double end, double length, double shift) {
  SdfInterval out;
  out.length = std::abs(length);
  const double half = 0.5 * length;
  out.place = end + half;
  out.offset = sum_error(end, half, out.place) + shift;
  return out;
}

}  // namespace

// With the largest length that fits, the middle may move by what that leaves over. Both ends round
// to what they were where that is less than both gaps to the next doubles inside; of no shorter
// length it is.
SdfInterval sdf_interval(double low, double high) {
  SdfInterval plain{0.5 * low + 0.5 * high, 0, high - low, true};
  if (is_read_as(plain, low, high)) return plain;
  const double length = add_down(high, -low);
  ExactSum sum;
  sum.add(high);
  sum.add(-low);
  sum.add(-length);
  const double rest = sum.up();
  const double at_low = next_up(low) - low;
  const double at_high = high - next_down(high);
  const double middle = 0.5 * (std::max(0.0, rest - at_high) + std::min(rest, at_low));
  for (const SdfInterval& found :
       {placed(low, length, 0), placed(high, -length, 0), placed(low, length, middle)}) {
    if (is_read_as(found, low, high)) return found;
  }
  SdfInterval larger = plain;
  larger.same = false;
  while (end_of(larger, -1).down() > low || end_of(larger, 1).up() < high) {
    larger.length = next_up(larger.length);
  }
  return larger;
}

}  // namespace geom
