#pragma once

// Which COLLADA files all simulators show alike, and as the file says.

#include "sdf_node.h"

namespace geom {

// Throws InputError(source, line, …) where simulators may show the triangles of the file elsewhere
// than it says, or move them: what was expected, and what stood there.
//
// What they do (Gazebo Classic's and gz-common's ColladaLoader, gz-common's AssimpLoader, RViz,
// gzweb; as of 2025): all multiply by `<unit meter>`. Some pass over `<up_axis>` and take z as up,
// others turn by it: only Z_UP is the same to both. The ColladaLoaders take of a node the first
// `<matrix>` alone, or else the first `<translate>`, all `<rotate>` and the first `<scale>`, in
// this order whatever order they stand in; they follow one `<instance_node>` only, and then show no
// geometry of the node itself; they show a geometry that is placed twice where it is first; they
// know elements by their ids, whatever these are; and they take positions as three numbers each,
// from the first on. Skins and animations move. What they do not show at all (`<polygons>`, strips)
// counts nevertheless: more is held, never less.
void require_simulators_agree(const SdfNode& collada);

}  // namespace geom
