#pragma once

// A way as a line strip in binary glTF, to be seen beside the map's `skyway-map to-gltf`.

#include <iosfwd>
#include <span>
#include <string_view>

#include "geom/polyline.h"

namespace traj {

// glTF 2.0 (`.glb`): one node whose translation is the first point, and single precision relative
// to it; y up, x east, z south. Points in ENU, at least one. `note` goes into the asset's extras.
void write_gltf_line(std::ostream& out, std::span<const geom::Vec3> enu, std::string_view name,
                     std::string_view note);

// The points of such a file, in ENU. Throws geom::InputError(source, …) for other bytes.
geom::Polyline read_gltf_line(std::istream& in, std::string_view source);

}  // namespace traj
