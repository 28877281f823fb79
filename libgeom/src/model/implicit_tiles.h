#pragma once

// Tiles that a tileset does not list: a quadtree or octree, cut into subtrees (3D Tiles 1.1).

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "geom/model/model.h"
#include "json_members.h"
#include "subtree.h"

namespace geom {

class ImplicitTiles {
 public:
  // Reads the contents of a tile, by their URIs, after all tiles below it. `below`: whether there
  // are some and all of them are whole. Whether it is whole: it has content, or they are.
  using ReadTile =
      std::function<bool(const std::vector<std::string>& uris, bool below, std::size_t level)>;

  // Of a tile with "implicitTiling" in the tileset at `path`; `contents`: its templates of URIs.
  ImplicitTiles(const JsonMembers& tile, std::vector<std::string> contents, const std::string& path,
                const ModelFiles& files, ReadTile read);

  // Whether the first tile is whole. Throws InputError for what is malformed, and for a tile below
  // the levels that the tileset says.
  bool read();

 private:
  struct Tile {
    std::uint64_t level = 0;
    std::uint64_t x = 0;
    std::uint64_t y = 0;
    std::uint64_t z = 0;
  };
  struct Made {
    bool there = false;
    bool whole = false;
  };

  Subtree load(const Tile& root);
  Made visit(const Subtree& subtree, const Tile& tile, std::uint64_t level, std::uint64_t i);
  std::string uri(const std::string& pattern, const Tile& tile) const;
  void require_pattern(const JsonMembers& at, const std::string& pattern) const;

  std::string path_;
  const ModelFiles& files_;
  ReadTile read_;
  SubtreeShape shape_;
  std::uint64_t available_levels_ = 0;
  std::string subtrees_;
  std::vector<std::string> contents_;
  std::size_t visited_ = 0;
};

}  // namespace geom
