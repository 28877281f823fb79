#pragma once

// Which tiles of a subtree there are (3D Tiles 1.1, OGC 22-025r4, "Implicit tiling").

#include <cstdint>
#include <string>
#include <vector>

#include "geom/model/model.h"

namespace geom {

struct SubtreeShape {
  std::uint64_t branches = 4;  // of a tile: 4 in a quadtree, 8 in an octree
  std::uint64_t levels = 1;    // of tiles in a subtree
  std::size_t contents = 1;    // that a tile may have
};

// Tiles of a level count in Morton order: the lowest bit is that of x, the next that of y.
class Subtree {
 public:
  // The subtree file at `path`, as JSON or binary; `files` reads others that it names. Throws
  // InputError for what is malformed or cut short, for counts that are not those of its bits, and
  // for what would be lost: tiles below none, content of no tile, subtrees below none, all of a
  // subtree without its first tile.
  Subtree(const std::string& path, const SubtreeShape& shape, const ModelFiles& files);

  bool has_tile(std::uint64_t level, std::uint64_t i) const { return tiles_.at(place(level, i)); }
  bool has_content(std::size_t content, std::uint64_t level, std::uint64_t i) const {
    return content < contents_.size() && contents_[content].at(place(level, i));
  }
  bool has_child(std::uint64_t i) const { return children_.at(i); }  // of the level below

 private:
  // A bit for each, or one answer for all.
  struct Availability {
    std::string bits;
    bool all = false;

    bool at(std::uint64_t i) const {
      return bits.empty() ? all : (static_cast<unsigned char>(bits[i / 8]) >> i % 8 & 1) != 0;
    }
  };

  std::uint64_t place(std::uint64_t level, std::uint64_t i) const { return first_[level] + i; }
  Availability read(const class JsonMembers& availability, class SubtreeBytes& bytes,
                    std::uint64_t count) const;
  void require_whole(const std::string& path) const;

  SubtreeShape shape_;
  std::vector<std::uint64_t> first_;  // of each level, and of the one below, in the bits of tiles
  Availability tiles_;
  std::vector<Availability> contents_;
  Availability children_;
};

}  // namespace geom
