#include "traj/mission/airspace/volume_around.h"

#include <algorithm>
#include <cmath>

#include "geom/map/geographic_frame.h"
#include "geom/shape/convex_outline.h"

namespace traj {
namespace {

using geom::Vec2;

constexpr double kDegrees = 1e9;      // parts of a degree that are written
constexpr double kCentimetres = 100;  // parts of a metre of altitude
constexpr double kRounding = 1e-3;    // m: more than those parts and the check's own reserve
constexpr double kReserve = 1e-6;     // m: far more than projecting and the sums here round by
constexpr int kMostAttempts = 8;      // at an outline, each wider than the one before

class Around {
 public:
  Around(const geom::GeodeticOrigin& origin, std::string_view source)
      : origin_(origin), earth_(origin), source_(source) {}

  // Further out by what its edges may bend (geom::outline_on_map), which follows from their length.
  std::vector<geom::GeodeticPlace> ring(const std::vector<Vec2>& outline) const {
    double out = kRounding;
    geom::GeodeticOutline made;
    for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
      made.ring = ring(outline, out);
      const double bulge =
          geom::outline_on_map(made, origin_, geom::CircleSide::within, "a volume", source_).bulge;
      if (bulge + kRounding <= out) break;
      out = 1.01 * (bulge + kRounding);
    }
    return made.ring;
  }

 private:
  // Further out along each axis, in degrees as they are written, and convex where these lie:
  // rounded after it was made convex, a side that is all but straight would be dented.
  std::vector<geom::GeodeticPlace> ring(const std::vector<Vec2>& outline, double out) const {
    std::vector<geom::GeodeticPlace> places;
    std::vector<Vec2> points;
    for (const Vec2& p : outline) {
      for (const Vec2& corner :
           {Vec2(out, out), Vec2(-out, out), Vec2(out, -out), Vec2(-out, -out)}) {
        places.push_back(rounded(p + corner));
        Vec2& at = points.emplace_back();
        earth_.from_geodetic(places.back().latitude, places.back().longitude, at.x(), at.y());
      }
    }
    std::vector<geom::GeodeticPlace> ring;
    for (const Vec2& p : geom::convex_outline(points)) {
      const auto at = std::find(points.begin(), points.end(), p) - points.begin();
      ring.push_back(places[static_cast<std::size_t>(at)]);
    }
    return ring;
  }

  geom::GeodeticPlace rounded(const Vec2& p) const {
    geom::GeodeticPlace place;
    earth_.to_geodetic(p.x(), p.y(), place.latitude, place.longitude);
    place.latitude = std::round(place.latitude * kDegrees) / kDegrees;
    place.longitude = std::round(place.longitude * kDegrees) / kDegrees;
    return place;
  }

  const geom::GeodeticOrigin& origin_;
  geom::GeographicFrame earth_;
  std::string_view source_;
};

double twice_area(const std::vector<Vec2>& ring) {
  double area = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Vec2 a = ring[i] - ring[0];
    const Vec2 b = ring[i + 1] - ring[0];
    area += a.x() * b.y() - a.y() * b.x();
  }
  return area;
}

}  // namespace

geom::Volume4d volume_around(const AirspacePrism& prism, const geom::GeodeticOrigin& origin,
                             std::string_view source) {
  geom::Volume4d out;
  out.outline.ring = Around(origin, source).ring(prism.outline);
  out.lower = std::floor((prism.low + origin.height - kRounding) * kCentimetres) / kCentimetres;
  out.upper = std::ceil((prism.high + origin.height + kRounding) * kCentimetres) / kCentimetres;
  return out;
}

bool holds_prism(const geom::Volume4d& volume, const AirspacePrism& prism,
                 const geom::GeodeticOrigin& origin, std::string_view source) {
  if (!(*volume.lower - origin.height + kReserve <= prism.low)) return false;
  if (!(*volume.upper - origin.height - kReserve >= prism.high)) return false;
  const geom::MapOutline outline =
      geom::outline_on_map(volume.outline, origin, geom::CircleSide::within, "a volume", source);
  const double side = twice_area(outline.ring) < 0 ? -1 : 1;
  // Within the planes along all edges: inside, and so not of a ring that has a dent.
  for (std::size_t i = 0; i < outline.ring.size(); ++i) {
    const Vec2& a = outline.ring[i];
    const Vec2 along = outline.ring[(i + 1) % outline.ring.size()] - a;
    const Vec2 out = side * Vec2(along.y(), -along.x()) / along.norm();
    for (const Vec2& p : prism.outline) {
      if (!(out.dot(p - a) <= -outline.bulge - kReserve)) return false;
    }
  }
  return true;
}

}  // namespace traj
