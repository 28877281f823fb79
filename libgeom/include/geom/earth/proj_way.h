#pragma once

// The way from a reference system to places on Earth, or to metres about one of them.
//
// Example:
//   const auto utm = geom::ProjReference::of("EPSG:25832");
//   std::vector<geom::Vec2> points = {{500000, 5300000}};
//   const geom::Vec2 place = *geom::ProjWay::to_places(*utm)->place_of(points[0]);
//   const geom::GeodeticOrigin origin = geom::tidy_origin(place, 1e3);  // to 1e-3 degrees
//   geom::ProjWay::to_plane(*utm, origin)->forward(points);
//   assert(points[0].norm() < 200);  // metres from the origin

#include <memory>
#include <optional>
#include <span>

#include "geom/earth/proj_reference.h"
#include "geom/map/frame.h"
#include "geom/shape/aabb.h"
#include "geom/shape/polygon.h"

namespace geom {

// Converts x and y; heights stay. East before north, longitude before latitude, on both sides. PROJ
// searches the way of a reference system once. One thread at a time.
class ProjWay {
 public:
  // To longitude and latitude on WGS 84, in degrees. Nothing where PROJ knows no way, or only one
  // that takes two datums for one: that would be off by up to hundreds of metres.
  static std::optional<ProjWay> to_places(const ProjReference& from);

  // To metres east and north of an origin (geom::plane_about). Its height is not looked at.
  static std::optional<ProjWay> to_plane(const ProjReference& from, const GeodeticOrigin& origin);

  ~ProjWay();
  ProjWay(ProjWay&&) noexcept;
  ProjWay& operator=(ProjWay&&) noexcept;

  // In place. Points that PROJ cannot convert become infinite; on the way back, so do those that
  // another way leads from than to (more than 1 cm away), near the edge of a transformation's area.
  // The second form is for `count` points `stride` bytes apart, whose y follows their x.
  void forward(std::span<Vec2> points) const;
  void forward(double* x, std::size_t count, std::size_t stride) const;
  void back(std::span<Vec2> points) const;

  // Where one point comes to lie; nothing where PROJ cannot say.
  std::optional<Vec2> place_of(Vec2 point) const;

  // A rectangle around what comes to lie in this one (z is not looked at), with a hundredth of its
  // sides more; nothing where PROJ cannot say, and around a pole or across the date line.
  std::optional<Aabb> origin_of(const Aabb& region) const;

 private:
  struct Impl;
  explicit ProjWay(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

// The origin of a map at a longitude and latitude, rounded to so many parts of a degree.
GeodeticOrigin tidy_origin(const Vec2& place, double parts);

}  // namespace geom
