#pragma once

// Reference systems of the Earth as PROJ knows them.
//
// Example:
//   const auto system = geom::ProjReference::of("EPSG:2994+6360");
//   assert(*system->told().plane == 0.3048);              // feet in plan
//   assert(std::abs(*system->told().up - 0.3048) > 1e-8);  // heights in another foot
//   assert(!system->north_first() && system->area());

#include <memory>
#include <optional>
#include <string>

#include "geom/earth/coordinate_reference.h"

namespace geom {

// Copies share what PROJ has found. One thread at a time, with all copies and ways of one.
class ProjReference {
 public:
  // The reference system that a text names to PROJ: "EPSG:25832", "EPSG:2994+6360" (with heights),
  // a URN or URL of OGC's, well-known text, a PROJ string, the whole name of a system. Of a code
  // that was replaced by one other, that other. Nothing if PROJ knows none of that name.
  static std::optional<ProjReference> of(const std::string& text);

  // Kind and units as PROJ has them. A system of places on a sphere is of Kind::no_plane.
  const CoordinateReference& told() const;

  // Whether x and y say where on Earth a point is, so that a ProjWay leads on from here.
  bool places() const;

  // Whether x and y are angles, and what one of x is: radians of angles, else metres.
  bool is_geographic() const;
  std::optional<double> unit() const;

  // Whether the system itself has its northing or latitude first. Skyway always has x first.
  bool north_first() const;

  // Where the system is meant for, in degrees; `west` is more than `east` across the date line.
  struct Area {
    double west;
    double south;
    double east;
    double north;
  };
  std::optional<Area> area() const;

 private:
  friend class ProjWay;
  struct Impl;
  explicit ProjReference(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}

  std::shared_ptr<Impl> impl_;
};

}  // namespace geom
