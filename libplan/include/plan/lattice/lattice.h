#pragma once

// Lattice graphs: points on a regular grid, joined to their free neighbours.
//
// Example:
//   const plan::Lattice lattice = plan::build_lattice(scene, {.spacing = 1});
//   for (std::size_t node = 0; node < lattice.size(); ++node) {
//     if (lattice.free(node)) assert(scene.free(lattice.position(node)));
//   }

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "geom/record/record.h"

namespace plan {

using geom::Vec3;

enum class Connectivity { six = 6, eighteen = 18, twenty_six = 26 };

struct LatticeSpec {
  double spacing = 25;  // metres, > 0
  Connectivity connectivity = Connectivity::six;
  Vec3 origin = Vec3::Zero();  // the node of index (0, 0, 0), wherever that is
};

using Index3 = std::array<std::int64_t, 3>;

// The 13 directions that, with their opposites, are the 26: the first 3 are the axes, the first 9
// the 18-neighbourhood. Bit d of a mask is direction d, bit 13 + d its opposite.
inline constexpr int kHalfDirections = 13;
inline constexpr int kDirections = 2 * kHalfDirections;
extern const std::array<std::array<int, 3>, kDirections> kDirection;

int half_directions(Connectivity connectivity);  // 3, 9 or 13

// Where the nodes are: dims[0] * dims[1] * dims[2] of them, at origin + (first + i) * spacing.
struct LatticeGrid {
  static constexpr std::int64_t kSide = 8;  // nodes along the edge of a block
  static constexpr std::size_t kBlock = 512;

  LatticeSpec spec;
  Index3 first{};
  Index3 dims{};

  double coordinate(int axis, std::int64_t i) const {
    return spec.origin[axis] + static_cast<double>(first[axis] + i) * spec.spacing;
  }
  Vec3 position(const Index3& i) const {
    return {coordinate(0, i[0]), coordinate(1, i[1]), coordinate(2, i[2])};
  }
  bool contains(const Index3& i) const {
    return i[0] >= 0 && i[1] >= 0 && i[2] >= 0 && i[0] < dims[0] && i[1] < dims[1] &&
           i[2] < dims[2];
  }
  bool inside(const Index3& low, const Index3& count) const {  // all of [low, low + count)
    return contains(low) &&
           contains({low[0] + count[0] - 1, low[1] + count[1] - 1, low[2] + count[2] - 1});
  }
  Index3 blocks() const;                             // how many along each axis
  std::size_t block_count() const;                   // numbered x fastest, then y, then z
  Index3 block_low(std::size_t block) const;         // its first node
  std::uint32_t possible(const Index3& node) const;  // half directions that stay on the grid
};

// What is free: where a lattice has its masks from. Safe for threads.
class MaskSource {
 public:
  virtual ~MaskSource() = default;

  // For each node of [low, low + count), x fastest: Lattice::kNode where it is free, and the bits
  // of the half directions in which its edges are. 0 beyond the grid.
  virtual void read(const Index3& low, const Index3& count, std::uint32_t* masks) const = 0;

  virtual std::string_view name() const { return "lattice"; }  // for messages
};

struct LatticeCounts {
  std::size_t nodes = 0;
  std::size_t edges = 0;  // each counted once
};

// Immutable. Nodes are numbered x fastest, then y, then z. A node is free when the vehicle at it is
// inside the bounds and clear of every closed grown box; an edge when its closed straight segment
// is. Both exact for the doubles of the node positions, origin + k * spacing for integer k.
class Lattice {
 public:
  static constexpr std::uint32_t kNode = 1u << 31;  // in a mask: the node itself is free
  using Block = std::array<std::uint32_t, LatticeGrid::kBlock>;  // masks, x fastest

  Lattice(LatticeGrid grid, geom::Provenance made_for, std::shared_ptr<const MaskSource> source);

  const LatticeGrid& grid() const { return grid_; }
  const LatticeSpec& spec() const { return grid_.spec; }
  const Index3& first() const { return grid_.first; }
  const Index3& dims() const { return grid_.dims; }
  const geom::Provenance& made_for() const { return made_for_; }  // map, frame, vehicle, margin
  const MaskSource& source() const { return *source_; }
  std::size_t size() const;  // nodes, free or not

  // Masks of the nodes of a block, 0 beyond the lattice. Throws InputError where a file that they
  // come from has an edge to a blocked node.
  void read(std::size_t block, Block& masks) const;

  std::uint32_t mask(std::size_t node) const;
  bool free(std::size_t node) const { return (mask(node) & kNode) != 0; }
  std::int64_t offset(int direction) const;  // to that neighbour

  Index3 index(std::size_t node) const;
  std::optional<std::size_t> node(const Index3& index) const;  // nothing outside
  Vec3 position(std::size_t node) const { return grid_.position(index(node)); }
  double coordinate(int axis, std::int64_t i) const { return grid_.coordinate(axis, i); }

  LatticeCounts counts() const;  // of what is free; reads all of it, and so checks it

 private:
  LatticeGrid grid_;
  geom::Provenance made_for_;
  std::shared_ptr<const MaskSource> source_;
};

}  // namespace plan
