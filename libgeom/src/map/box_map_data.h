#pragma once

// What a BoxMap shares: views of arrays that it owns or that a mapped file holds.

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/large_array.h"
#include "geom/archive/array_archive.h"
#include "geom/map/box_map.h"
#include "tile_table.h"
#include "timed_boxes.h"

namespace geom {

struct BoxMap::Data {
  struct Owned {
    explicit Owned(std::size_t count) : boxes(count), ids(count), label(count) {}

    LargeArray<Aabb> boxes;
    LargeArray<std::uint64_t> ids;
    LargeArray<std::uint32_t> label;
    std::vector<std::uint64_t> timed;
    std::vector<TimeSpan> times;
  };

  BoxMapSpec spec;
  std::vector<std::string> labels;
  TileTable tiles;
  std::string hash;
  std::span<const Aabb> boxes;
  std::span<const std::uint64_t> ids;
  std::span<const std::uint32_t> label;
  TimedBoxes timed;
  std::shared_ptr<const Owned> owned;   // what the spans point into, or
  std::optional<ArrayArchive> archive;  // the file that does, and that is to be verified

  mutable std::mutex verifying;
  mutable std::atomic<Verified> verified = Verified::contents;
};

}  // namespace geom
