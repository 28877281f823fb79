#pragma once

// Where a search gets the tiles of a roadmap from: a file, or the scene itself.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plan/roadmap/roadmap.h"
#include "squares.h"

namespace plan {

// Tiles are numbered in the order of code_of(). All but the first two throw geom::InputError for
// what cannot be.
class TileSource {
 public:
  // Of one bend, as Roadmap says.
  struct Edges {
    std::span<const std::uint32_t> first;
    std::span<const std::uint32_t> second;
  };

  virtual ~TileSource() = default;
  virtual const Squares& squares() const = 0;
  virtual std::size_t tiles() const = 0;
  virtual Square square(std::size_t tile) const = 0;
  virtual geom::Aabb extent(std::size_t tile) const = 0;  // holds its bends
  virtual std::vector<Bend> bends(std::size_t tile) = 0;
  virtual Edges edges(std::size_t tile, std::uint32_t local) = 0;  // good as long as the source
  virtual const std::string& name() const = 0;                     // for messages

  std::optional<std::size_t> find(const Square& square) const;

  // The tile that an edge from `tile` leads to: InputError where there is none.
  std::size_t target(std::size_t tile, std::uint32_t edge) const;
};

// Of a roadmap, which must outlive it.
std::unique_ptr<TileSource> tiles_of(const Roadmap& roadmap);

}  // namespace plan
