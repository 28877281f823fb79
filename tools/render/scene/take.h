#pragma once

// Taking pictures: all of a batch at once, tile by tile, on any number of threads.

#include <span>
#include <vector>

#include "geom/base/execution.h"
#include "render/image/picture.h"
#include "shade.h"

namespace render {

struct Wanted {
  bool colour = true;
  bool depth = false;
  bool id = false;
  int samples = 1;  // a side of each pixel, for colour: n x n rays are averaged
};

// A picture a view. The bytes do not depend on run.threads.
std::vector<Picture> take_pictures(const PictureScene& scene, const Shader& shader,
                                   std::span<const View> views, const Wanted& wanted,
                                   const geom::Execution& run);

}  // namespace render
