#pragma once

// Free space as the leaves of a k-d tree that is built where somebody looks.

#include <array>
#include <cstdint>
#include <vector>

#include "geom/collision/collision.h"

namespace plan {

using geom::Vec3;

// A region that meets more than so many boxes is halved across its longest side, unless that is
// short, and not cut at faces: so a question costs what it touches of the map.
struct Listed {
  std::size_t boxes = 4096;
  double side = 64;  // metres
};

class FreeCells {
 public:
  // The scene has free bounds.
  explicit FreeCells(const geom::CollisionScene& scene, const Listed& most = {});

  std::size_t size() const { return nodes_.size(); }  // nodes of the tree, so far
  const geom::Aabb& region(std::uint32_t node) const { return nodes_[node].region; }

  // The cell that holds the point, which is within the bounds, closed. Free where the point is.
  std::uint32_t cell_at(const Vec3& p);
  bool is_free(std::uint32_t cell) const { return nodes_[cell].kind == Kind::free; }

  // The free cells that share a part of a face with a cell, each once, in an order of their places.
  void neighbours(std::uint32_t cell, std::vector<std::uint32_t>& out);

 private:
  enum class Kind : std::uint8_t { open, cut, free, blocked };  // open: not looked at yet
  struct Node {
    geom::Aabb region;
    std::vector<std::uint32_t> boxes;  // of an open node, if listed: those that meet its inside
    double at = 0;                     // of a cut
    std::uint32_t low = 0;             // its two halves are this and the next
    std::uint8_t axis = 0;
    Kind kind = Kind::open;
    bool listed = false;
  };
  struct Cut {
    int axis = -1;
    double at = 0;
  };
  struct Face;  // of a cell, and the side to look to

  void make_room();
  void settle(std::uint32_t node);
  bool list(std::uint32_t node);
  void split(std::uint32_t node, const Cut& cut);
  Cut best_cut(const geom::Aabb& region, const std::vector<std::uint32_t>& boxes) const;
  bool meets_inside(const geom::Aabb& box, const geom::Aabb& region) const;
  void beyond(std::uint32_t node, const Face& face, std::vector<std::uint32_t>& out);

  const geom::CollisionScene& scene_;
  Listed most_;
  std::array<bool, 3> flat_;  // axes along which the bounds have no length
  std::vector<Node> nodes_;
};

}  // namespace plan
