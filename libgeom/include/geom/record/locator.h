#pragma once

// From places on Earth to the metres of a map.
//
// Example:
//   const geom::Locator locator(map);
//   assert(locator.at(geom::Vec3(1, 2, 3), "queries.jsonl", 1) == geom::Vec3(1, 2, 3));
//   // A place such as "47.4N,8.5E,30" needs a map with an origin.

#include <cstddef>
#include <optional>
#include <string_view>

#include "geom/map/box_map.h"
#include "geom/map/geographic_frame.h"
#include "geom/record/place.h"

namespace geom {

// The map must outlive it. Places are counted as GeographicFrame counts them, heights as EarthPlace
// says. A place `above` what stands there looks at all tiles: closed boxes under the point count.
class Locator {
 public:
  explicit Locator(const BoxMap& map);

  // Throws InputError(source, line, …) for a place on Earth if the map does not say where on Earth
  // it is, if the place is more than 1000 km away, or `above` nothing on a map that has a scan or a
  // height model: there is a hole in the data.
  Vec3 at(const Place& place, std::string_view source, std::size_t line) const;

  // The height of the map's zero in the vertical datum of its origin, metres; 0 without an origin.
  double zero() const;

 private:
  std::optional<double> top(const Vec3& p) const;

  const BoxMap& map_;
  std::optional<GeographicFrame> earth_;
  bool scanned_ = false;  // what has no box has no data
};

}  // namespace geom
