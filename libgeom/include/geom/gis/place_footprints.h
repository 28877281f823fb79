#pragma once

// Footprints brought from their source to the map: onto its plane, and onto the ground.
//
// Example:
//   geom::gis::Source source =
//       geom::gis::read_vector("blocks.geojson", "blocks.geojson", geom::gis::ReadOptions{});
//   const geom::gis::Projector projector(source, "blocks.geojson", std::nullopt, false);
//   geom::gis::project(source, projector, 0.5);
//   const geom::BoxTable boxes = geom::boxes_of(source.footprints, 0.5, {});

#include <optional>
#include <string>

#include "geom/gis/footprint_source.h"

namespace geom::gis {

// Every corner, into metres of the map. Rectangles of cells of a height model keep four corners
// where their sides are then straight to a hundredth of the slack (metres), which is their bulge;
// others get all corners of cells along their sides. Straight edges of other footprints that bend
// on the map get corners, and arcs their bulge in metres.
void project(Source& source, const Projector& projector, double slack);

// Down to the lowest point of the ground under it, and as high above the highest. Those without
// ground under them, or under a part of the rectangle around them, are skipped: where they stand is
// not known. The first are taken out, and the latter lifted by the ground that is known.
void lift(Source& source, const Terrain& terrain, const Frame& frame);

// What is ground is solid: down to the lowest of all footprints, and to the floor of the map (in
// the footprints' own units) where that is lower.
void sink_ground(std::vector<Footprint>& footprints, std::optional<double> floor);

// What cover asks of its numbers, and that it ends: a footprint is cut into slabs no lower
// than the slack (metres). One with a CRS lies within 2,000 km of the origin. Throws
// InputError(name, …).
void check_sizes(const Source& source, double slack, const std::string& name);

}  // namespace geom::gis
