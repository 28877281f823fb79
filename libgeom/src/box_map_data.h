#pragma once

// What a BoxMap shares: views of arrays that it owns or that a mapped file holds.

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "geom/box_map.h"

namespace geom {

struct BoxMap::Data {
  struct Owned {
    std::vector<Aabb> boxes;
    std::vector<std::uint64_t> ids;
    std::vector<std::uint32_t> label;
  };

  BoxMapSpec spec;
  std::vector<std::string> labels;
  std::vector<Tile> tiles;
  std::string hash;
  std::span<const Aabb> boxes;
  std::span<const std::uint64_t> ids;
  std::span<const std::uint32_t> label;
  std::shared_ptr<const void> keep_alive;  // whatever the spans point into

  // Throws where a value of that tile is wrong; empty where the values are our own. Looking twice
  // is harmless, so threads need no more than the flags.
  std::function<void(std::size_t tile)> check;
  mutable std::vector<std::atomic<bool>> looked_at;  // one a tile
  mutable std::atomic<bool> all_looked_at = false;

  void look_at(std::size_t tile) const;
  void look_at_all() const;
};

}  // namespace geom
