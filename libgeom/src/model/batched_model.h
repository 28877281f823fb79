#pragma once

// Batched 3D Model: a glTF with names for its features (3D Tiles 1.0, OGC 18-053r2, 9).

#include <string>
#include <string_view>
#include <vector>

#include "geom/base/vec3.h"

namespace geom {

struct BatchedModel {
  std::string_view gltf;           // of the bytes given
  Vec3 center = Vec3::Zero();      // RTC_CENTER: what positions count from, in the tile's frame
  std::vector<std::string> names;  // of its features, where the batch table has some
};

// Throws InputError(source, …) where the lengths do not add up to that of `bytes`.
BatchedModel read_batched_model(std::string_view bytes, std::string_view source);

}  // namespace geom
