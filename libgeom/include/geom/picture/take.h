#pragma once

// Taking pictures: all of a batch at once, tile by tile, on any number of threads.
//
// Example:
//   const geom::picture::PictureScene seen(map, {});
//   const geom::picture::Shader shader(seen, geom::picture::look_of(map), {}, false);
//   const std::vector<geom::picture::View> views{
//       geom::picture::plan_view(map.spec().bounds, 64, 64)};
//   const auto pictures = geom::picture::take_pictures(
//       seen, shader, views, {.depth = true, .id = true}, {.threads = 2});
//   assert(pictures[0].depth.size() == 64 * 64);

#include <span>
#include <vector>

#include "geom/base/execution.h"
#include "geom/picture/picture.h"
#include "geom/picture/shade.h"

namespace geom::picture {

struct Wanted {
  bool colour = true;
  bool depth = false;
  bool id = false;
  int samples = 1;  // a side of each pixel, for colour: n x n rays are averaged; >= 1
};

// Takes one picture for each view. A view is at least one pixel wide and high. `shader` is one of `scene`. The bytes
// do not depend on run.threads.
std::vector<Picture> take_pictures(const PictureScene& scene, const Shader& shader,
                                   std::span<const View> views, const Wanted& wanted,
                                   const Execution& run);

}  // namespace geom::picture
