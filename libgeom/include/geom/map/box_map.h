#pragma once

// A city as boxes: what every later stage starts from.
//
// Example:
//   geom::BoxTable table;
//   table.add({{4, 0, 0}, {5, 8, 8}}, 1);
//   const geom::BoxMap city({.bounds = {{0, 0, 0}, {10, 10, 10}}, .bounds_from = "source"}, table);
//   assert(city.size() == 1 && city.box(0).max.z() == 8);
//   std::cout << city.hash() << '\n';  // "sha256:…"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/base/execution.h"
#include "geom/map/box_table.h"
#include "geom/map/frame.h"
#include "geom/shape/aabb.h"

namespace geom {

struct Tile {
  std::int32_t ix = 0;  // the square [ix s, (ix + 1) s) x [iy s, (iy + 1) s), s the tile size
  std::int32_t iy = 0;
  bool large = false;  // boxes that cover more than 4 tiles; ix = iy = 0, and it comes first
  Aabb extent;         // the true bounding box of the contents
  std::size_t first = 0;
  std::size_t count = 0;  // boxes [first, first + count), at least one
};

struct BoxMapSpec {
  Frame frame;
  Aabb bounds;              // closed; the whole vehicle stays inside
  std::string bounds_from;  // "source", "obstacles" or "option": who set the bounds
  double tile_size = 100;   // metres, > 0
  std::string history;      // one JSON array: a line of options and input hashes per step
  // The instant that times of boxes count from, as epoch_from() writes it (geom/text/instant.h).
  std::optional<std::string> epoch;
};

// How far the claims of a map's file are verified (docs/formats.md, "Trust"). Each level includes
// those before it.
enum class Verified : std::uint8_t {
  nothing,  // the directory, shapes, types and ranges, as reading does
  extents,  // every box is finite, has min <= max and lies in its tile's extent; its label exists
  contents  // every checksum; each box is in its tile, in order; the hash is that of the map
};

// Immutable and cheap to copy: the arrays are shared (mapped from a file, or owned). Boxes are
// ordered by tile (large first, then by iy, ix), in a tile by (min, max, id), so equal content
// gives equal bytes. Threads may read one at once.
//
// A map from a file is verified before use: tiles(), boxes(), boxes_of() and
// label() verify the extents first, and throw InputError if one is wrong. Code that decides
// for good (a proof, a map made of this one) calls require(Verified::contents).
class BoxMap {
 public:
  // Sorts `table` into tiles. No box may be inverted or not finite (precondition). If boxes have
  // times, throws InputError("the map", …) unless there is an epoch and each time is valid.
  BoxMap(BoxMapSpec spec, const BoxTable& table);

  const BoxMapSpec& spec() const;
  std::size_t size() const;        // how many boxes
  std::size_t tile_count() const;  // how many tiles
  std::span<const Aabb> boxes() const;
  std::span<const Aabb> boxes_of(std::size_t tile) const;
  const Aabb& box(std::size_t i) const;  // precondition: the extents are verified
  std::span<const std::uint64_t> ids() const;
  std::span<const std::uint32_t> label() const;
  const std::vector<std::string>& labels() const;
  std::span<const Tile> tiles() const;

  // Boxes that are not always there. Code that ignores their times takes them as always there,
  // which is the safe side for every answer about free space.
  std::span<const std::uint64_t> timed() const;  // their indices, ascending
  std::span<const TimeSpan> times() const;       // when each of these is there
  TimeSpan time(std::size_t i) const;            // of any box; log of the timed ones

  // "sha256:" and 64 hexadecimal digits: SHA-256 of frame, bounds, the sorted boxes and times.
  // Until the contents are verified it is a claim of the file.
  const std::string& hash() const;

  // Verifies what is not verified yet: reads all boxes for extents, all bytes for contents. Throws
  // InputError at the first fault, the same for any number of threads. It is done once for all
  // copies; threads may call it at once. A map that was made here is verified.
  void require(Verified level, const Execution& run = {}) const;
  Verified verified() const;

  // libgeom/src/map/box_map_data.h: for the files of this library that make, read or verify maps.
  struct Data;
  explicit BoxMap(std::shared_ptr<const Data> data);
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

}  // namespace geom
