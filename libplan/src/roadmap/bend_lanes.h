#pragma once

// Bends as columns of numbers, for a look at several in one loop without branches.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "bends.h"
#include "onward.h"

namespace plan {

class BendLanes {
 public:
  explicit BendLanes(std::span<const Bend> bends) {
    for (auto& column : place_) column.reserve(bends.size());
    edge_.reserve(bends.size());
    for (const Bend& bend : bends) {
      for (int k = 0; k < 3; ++k) place_[static_cast<std::size_t>(k)].push_back(bend.position[k]);
      edge_.push_back({static_cast<std::uint8_t>((bend.axis + 1) % 3),
                       static_cast<std::uint8_t>((bend.axis + 2) % 3), bend.outward});
    }
  }

  // Bit k of the answer says whether bend first + k is one that a path goes on to from `p`: its
  // squared distance is at most `square`, `onward` goes there, and the line is tangent to its box.
  // Writes the squared distances. Of at most BendTree::kBendsOfLeaf bends.
  unsigned reached(std::size_t first, std::size_t count, const Vec3& p, const Onward& onward,
                   double square, double* squares) const {
    unsigned out = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = first + k;
      const Vec3 d = Vec3(place_[0][i], place_[1][i], place_[2][i]) - p;
      squares[k] = d.squaredNorm();
      const Edge& edge = edge_[i];
      const Across back{-d[edge.first] * edge.outward[0], -d[edge.second] * edge.outward[1]};
      const bool yes = (squares[k] <= square) & onward.goes(d) & back.tangent();
      out |= static_cast<unsigned>(yes) << k;
    }
    return out;
  }

 private:
  struct Edge {
    std::uint8_t first;  // axes across it
    std::uint8_t second;
    std::array<std::int8_t, 2> outward;
  };

  std::array<std::vector<double>, 3> place_;
  std::vector<Edge> edge_;
};

}  // namespace plan
