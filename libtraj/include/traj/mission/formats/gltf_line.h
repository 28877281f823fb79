#pragma once

// A way as a line strip in binary glTF, to be seen beside the map's `skyway-map to-gltf`.
//
// Example:
//   std::stringstream file;
//   traj::write_gltf_line(file, path, "q1", "");
//   assert(traj::read_gltf_lines(file, "way.glb")[0].size() == path.size());

#include <iosfwd>
#include <span>
#include <string_view>
#include <vector>

#include "geom/shape/polyline.h"

namespace traj {

// glTF 2.0 (`.glb`): one node whose translation is the first point, and single precision relative
// to it; y up, x east, z south. Points in ENU, at least one. `note` goes into the asset's extras.
void write_gltf_line(std::ostream& out, std::span<const geom::Vec3> enu, std::string_view name,
                     std::string_view note);

// The points of every line strip that the file's one scene shows, in ENU, in order; at least one.
// Nodes may be moved, in no other way transformed. Throws geom::InputError(source, …) for other
// bytes, and for whatever else there is: triangles, indices, nodes under nodes or in no scene,
// animations, files beside it.
std::vector<geom::Polyline> read_gltf_lines(std::istream& in, std::string_view source);

}  // namespace traj
