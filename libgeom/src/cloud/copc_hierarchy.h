#pragma once

// The octree of a COPC file: which cube has which points, and where their chunk is.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geom/cloud/copc.h"

namespace geom {

struct CopcInfo {
  Vec3 centre;
  double half = 0;     // side of the whole cube, halved
  double spacing = 0;  // between the points of its first level
  std::uint64_t root = 0;
  std::uint64_t root_bytes = 0;
};

// Of the data of COPC's own record. Throws InputError(source, …).
CopcInfo parse_copc_info(std::string_view data, std::string_view source);

struct CopcNode {
  std::int32_t level = 0;
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t z = 0;
  std::uint64_t place = 0;
  std::uint32_t bytes = 0;
  std::uint32_t points = 0;

  Aabb cube(const CopcInfo& info) const;
};

// All cubes that have points, by their place in the file: every page is read. Throws InputError
// where pages are cut short or come twice, or where an entry contradicts itself or another.
std::vector<CopcNode> read_copc_nodes(const ReadAt& read, const CopcInfo& info,
                                      std::string_view source);

// Reads all of these bytes, a piece at a time, so that memory grows as they come; throws InputError
// where the file ends before.
std::string read_whole(const ReadAt& read, std::uint64_t at, std::uint64_t bytes,
                       std::string_view source);

}  // namespace geom
