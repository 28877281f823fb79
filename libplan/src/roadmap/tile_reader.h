#pragma once

// What a roadmap says of a tile, verified as it is read: a file may say anything.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "plan/roadmap/roadmap.h"
#include "squares.h"

namespace plan {

// All throw geom::InputError, with the roadmap's source, for what cannot be.
class TileReader {
 public:
  explicit TileReader(const Roadmap& roadmap) : roadmap_(&roadmap), squares_(roadmap.spec.reach) {}

  struct Range {
    std::size_t begin;
    std::size_t end;
    std::size_t size() const { return end - begin; }
  };

  const Squares& squares() const { return squares_; }
  Square square(std::size_t tile) const {
    return {roadmap_->tile_index[2 * tile], roadmap_->tile_index[2 * tile + 1]};
  }
  std::optional<std::size_t> find(const Square& square) const;

  geom::Aabb extent(std::size_t tile) const;
  Range bends(std::size_t tile) const;  // at most 2^24
  Range edges(std::size_t tile) const;
  Bend bend(std::size_t bend) const;
  // Of a bend of that tile, and how many of them are on the first side.
  std::span<const std::uint32_t> edges_of(std::size_t tile, std::size_t bend) const;
  std::uint32_t split_of(std::size_t tile, std::size_t bend) const;

  // The tile that an edge from `tile` leads to, and the number of the bend in it.
  struct Target {
    std::size_t tile;
    std::uint32_t local;
  };
  Target target(std::size_t tile, std::uint32_t edge) const;

  // Throws the InputError.
  [[noreturn]] void refuse(std::string_view what) const;

 private:
  const Roadmap* roadmap_;
  Squares squares_;
};

}  // namespace plan
