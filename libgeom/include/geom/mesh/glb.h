#pragma once

// The container of binary glTF 2.0 (`.glb`), and its axes.

#include <iosfwd>
#include <string>
#include <string_view>

#include "geom/shape/vec3.h"

namespace geom {

// From east-north-up to glTF's axes: x east, y up, z south.
Vec3 to_gltf(const Vec3& enu);

// One JSON chunk and, unless it is empty, one binary chunk, which `json` must call its only buffer.
// Throws InputError where they take more than the format's 4 GB.
void write_glb_container(std::ostream& out, std::string json, std::string bin);

}  // namespace geom
