#pragma once

// Models of 3D Tiles, from coordinates that count from the middle of the Earth to a map's.
//
// Example:
//   geom::Model tiles;
//   tiles.mesh.vertices = {{4267000, 637000, 4670000}};  // earth-centred, near Zurich
//   const geom::PlacedModel placed = geom::place_on_map(tiles, std::nullopt, "tileset.json");
//   assert(std::abs(placed.frame.origin->latitude - 47.4) < 0.2);

#include <optional>

#include "geom/map/frame.h"
#include "geom/model/model.h"

namespace geom {

struct PlacedModel {
  Frame frame;
  // A straight line through space is not quite straight in a map projection. This bounds how far
  // a triangle on the map may lie from the flat one between its corners. Boxes must grow by it.
  double bend = 0;  // metres
};

// Moves the vertices of an earth-centred model into a map about `origin`; without one, about the
// middle of the vertices' extent, at height 0. Throws InputError(source, …) where a vertex is more
// than 100 km from the ellipsoid or 200 km from the origin, or where there is none.
PlacedModel place_on_map(Model& model, const std::optional<GeodeticOrigin>& origin,
                         std::string_view source);

}  // namespace geom
