#pragma once

// Part of a COPC file: LAZ whose points stand in the cubes of an octree, coarse ones first.
//
// Example, not run:
//   std::ifstream file("city.copc.laz", std::ios::binary);
//   const geom::ReadAt read = [&](std::uint64_t at, std::span<unsigned char> to) {
//     file.clear();
//     file.seekg(static_cast<std::streamoff>(at));
//     file.read(reinterpret_cast<char*>(to.data()), static_cast<std::streamsize>(to.size()));
//     return static_cast<std::size_t>(file.gcount());
//   };
//   geom::read_copc(
//       read, "city.copc.laz", [](const auto& told) { return geom::CopcPart{.resolution = 1}; },
//       [](std::span<const geom::CloudPoint> points) { std::cout << points.size() << '\n'; });

#include <functional>
#include <optional>

#include "geom/cloud/point_cloud.h"
#include "geom/shape/aabb.h"

namespace geom {

// In the units of the file.
struct CopcPart {
  // Closed; z does not matter. Nothing: all points.
  std::optional<Aabb> region;
  // Levels are read until their points are this near to each other; 0: all levels.
  double resolution = 0;
};

// Decides on the part when it knows what the file says of its coordinates.
using CopcChooser = std::function<CopcPart(const CoordinateReference&)>;

struct CopcCounts {
  CloudCounts cloud;              // points read, inside the region
  std::uint64_t all = 0;          // points of the file
  std::uint64_t outside = 0;      // not read, or read and left out: not in the region
  std::uint64_t finer = 0;        // not read, of the region's cubes: of levels below the resolution
  std::uint64_t bytes = 0;        // of the file that were read
  std::optional<double> spacing;  // of the last level read, where finer ones were not
};

// Whether a file that begins with these bytes (589 or more) is COPC.
bool is_copc(std::string_view head);

// COPC 1.0 (H. Butler, A. Bell, C. Manning, 2021; copc.io), point formats 6 to 8. Of the hierarchy
// all pages are read, and they must account for each point and each byte of points; of the points,
// the chunks of the cubes that meet the region. Points must lie in their cube: then nothing of the
// region is missing, as far as the file says the truth of the cubes that are not read. Throws
// InputError(source, …) where a claim is found wrong, and as read_las() does.
//
// A coarse level need not show what finer levels hold. So with a resolution, some
// obstacles of the region are read only in part, or not at all; then `counts.finer` is not 0.
//
// Chunks are decoded on all threads of `run`; `read` and `sink` are called by one thread at a time
// each, which need not be the caller's. Points and counts do not depend on it.
CopcCounts read_copc(const ReadAt& read, std::string_view source, const CopcChooser& choose,
                     const PointSink& sink, const Execution& run = {});

}  // namespace geom
