#include "geom/map/wider_bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace geom {
namespace {

constexpr double kRounding = 1e-6;  // metres: what growing by the vehicle may add

// To millimetres, and a hair as such.
std::string shown(double metres) {
  if (metres < 5e-4) return "less than 1 mm";
  return fmt::format("{} m", std::round(metres * 1e3) / 1e3);
}

std::string beside(int axis, bool upper, double out, double face) {
  const std::string at = fmt::format("{} = {:.10g}", "xyz"[axis], face);
  if (axis < 2) return fmt::format("{} beyond {}", shown(out), at);
  return fmt::format("{} {}, {}", shown(out), upper ? "above the ceiling" : "below the floor", at);
}

double down(double v) { return std::floor(v + kRounding); }
double up(double v) { return std::ceil(v - kRounding); }

}  // namespace

void WiderBounds::add(const Vec3& place, const Vec3& half, double out) {
  Aabb room{place - half, place + half};
  const Vec3 below = bounds_.min - room.min;
  const Vec3 above = room.max - bounds_.max;
  int low = 0;
  int high = 0;
  const double most_below = below.maxCoeff(&low);
  const double most_above = above.maxCoeff(&high);
  if (most_above >= most_below) {
    room.max[high] += std::max(0.0, out - most_above);
  } else {
    room.min[low] -= std::max(0.0, out - most_below);
  }
  add(room);
}

bool WiderBounds::any() const { return !(needed_ == bounds_); }

std::string WiderBounds::in_words() const {
  std::string out;
  const auto add = [&](int axis, bool upper, double by, double face) {
    if (!(by > 0)) return;
    out += (out.empty() ? "" : " and ") + beside(axis, upper, by, face);
  };
  for (int axis = 0; axis < 3; ++axis) {
    add(axis, false, bounds_.min[axis] - needed_.min[axis], bounds_.min[axis]);
    add(axis, true, needed_.max[axis] - bounds_.max[axis], bounds_.max[axis]);
  }
  return out;
}

std::string WiderBounds::option() const {
  if (!any()) return "";
  Aabb wide = bounds_;
  for (int i = 0; i < 3; ++i) {
    if (needed_.min[i] < bounds_.min[i]) wide.min[i] = std::min(down(needed_.min[i]), wide.min[i]);
    if (needed_.max[i] > bounds_.max[i]) wide.max[i] = std::max(up(needed_.max[i]), wide.max[i]);
  }
  const bool sideways = (wide.min.head<2>().array() != bounds_.min.head<2>().array()).any() ||
                        (wide.max.head<2>().array() != bounds_.max.head<2>().array()).any();
  if (sideways) {
    return fmt::format("--bounds={},{},{},{},{},{}", wide.min[0], wide.min[1], wide.min[2],
                       wide.max[0], wide.max[1], wide.max[2]);
  }
  std::string out;
  if (wide.min.z() < bounds_.min.z()) out = fmt::format("--floor {}", wide.min.z());
  if (wide.max.z() > bounds_.max.z()) {
    out += fmt::format("{}--ceiling {}", out.empty() ? "" : " ", wide.max.z());
  }
  return out;
}

std::string WiderBounds::advice() const {
  if (!any()) return "";
  return fmt::format(
      "if nothing stands there, skyway-map bounds MAP {} makes a map that reaches there", option());
}

}  // namespace geom
