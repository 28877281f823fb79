#pragma once

// Lattice graphs: points on a regular grid, joined to their free neighbours.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geom/io/record.h"

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

// Immutable. Nodes are numbered x fastest, then y, then z. A node is free when the vehicle at it is
// inside the bounds and clear of every closed grown box; an edge when its closed straight segment
// is. Both exact for the doubles of the node positions, origin + k * spacing for integer k.
class Lattice {
 public:
  static constexpr std::uint32_t kNode = 1u << 31;  // in a mask: the node itself is free

  // `first` is the k of node 0; masks has dims[0] * dims[1] * dims[2] entries and is symmetric.
  Lattice(LatticeSpec spec, Index3 first, Index3 dims, geom::Provenance made_for,
          std::vector<std::uint32_t> masks);

  const LatticeSpec& spec() const { return spec_; }
  const Index3& first() const { return first_; }
  const Index3& dims() const { return dims_; }
  const geom::Provenance& made_for() const { return made_for_; }  // map, frame, vehicle, margin
  std::size_t size() const { return masks_.size(); }

  bool free(std::size_t node) const { return (masks_[node] & kNode) != 0; }
  std::uint32_t mask(std::size_t node) const { return masks_[node]; }
  std::int64_t offset(int direction) const { return offset_[direction]; }  // to that neighbour
  double edge_length(int direction) const { return length_[direction]; }   // metres

  Index3 index(std::size_t node) const;
  std::optional<std::size_t> node(const Index3& index) const;  // nothing outside
  Vec3 position(std::size_t node) const;
  double coordinate(int axis, std::int64_t i) const;  // of the i-th node along an axis

  std::size_t free_nodes() const;
  std::size_t free_edges() const;  // each counted once

 private:
  LatticeSpec spec_;
  Index3 first_;
  Index3 dims_;
  geom::Provenance made_for_;
  std::vector<std::uint32_t> masks_;
  std::array<std::int64_t, kDirections> offset_;
  std::array<double, kDirections> length_;
};

}  // namespace plan
