#pragma once

// Arcs in outlines that GDAL reads (gdal_*.cpp only).

#include "gdal_handles.h"

namespace geom::gis {

// How far an arc of the geometry may lie from the chords that take its place, in the units of its
// coordinates, where they are those of GDAL for arcs of `kDegreesOfArc`. 0 without arcs.
double gap_of_chords(OGRGeometryH geometry);

inline constexpr double kDegreesOfArc = 0.5;

}  // namespace geom::gis
