#include "gdal_arcs.h"

#include <algorithm>
#include <cmath>

#include "geom/shape/polygon.h"

namespace geom::gis {
namespace {

// GDAL moves some points along an arc, so that a chord may be of up to twice as many degrees.
const double kGapOfRadius = 1 - std::cos(kDegreesOfArc * M_PI / 180);

Vec2 point_of(OGRGeometryH line, int i) {
  Vec2 p;
  double z = 0;
  gdal().point(line, i, &p.x(), &p.y(), &z);
  return p;
}

// Of the arc from `a` over `b` to `c`; a circle where `c` is `a`, and `b` is opposite.
double gap_of_arc(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 whole = c - a;
  if (whole.isZero(0)) return kGapOfRadius * (b - a).norm() / 2;
  const Vec2 first = b - a;
  const Vec2 last = c - b;
  const double twice_area = std::abs(first.x() * whole.y() - first.y() * whole.x());
  if (twice_area == 0) return 0;
  const double radius = first.norm() * last.norm() * whole.norm() / (2 * twice_area);
  const double gap = kGapOfRadius * radius;
  if (first.dot(last) < 0) return gap;  // more than half a circle
  const double half = whole.norm() / 2;
  const double height =
      half * half / (radius + std::sqrt(std::max(0.0, radius * radius - half * half)));
  return std::min(gap, height);
}

}  // namespace

double gap_of_chords(OGRGeometryH geometry) {
  if (!gdal().has_arcs(geometry, TRUE)) return 0;
  double gap = 0;
  if (gdal().flat_type(gdal().geometry_type(geometry)) == wkbCircularString) {
    for (int i = 0; i + 2 < gdal().point_count(geometry); i += 2) {
      gap = std::max(gap, gap_of_arc(point_of(geometry, i), point_of(geometry, i + 1),
                                     point_of(geometry, i + 2)));
    }
  }
  for (int i = 0; i < gdal().part_count(geometry); ++i) {
    gap = std::max(gap, gap_of_chords(gdal().part_of(geometry, i)));
  }
  return gap;
}

}  // namespace geom::gis
