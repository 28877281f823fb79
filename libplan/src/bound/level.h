#pragma once

// The parts of edges of one size, with what is known of each: what a search for a bound goes over.

#include <cstdint>
#include <vector>

#include "convex_edges.h"
#include "line_label.h"
#include "occluders.h"
#include "part_tree.h"
#include "tangent.h"

namespace plan {

inline constexpr std::uint32_t kStart = 0;  // parts of every level
inline constexpr std::uint32_t kGoal = 1;

// clear: so that the pieces of both see each other, too, once they are cut in the middle.
enum class Sight : std::uint8_t { unknown, open, clear, hidden };

// From a part to another: which of their sides the two lie on, as sides() says.
struct Link {
  std::uint32_t to;
  std::uint8_t here;   // sides of the part that this starts from
  std::uint8_t there;  // of `to`
  Sight sight;         // hidden: an occluder is in between; looked at where it matters
  Tangent tangent;
};

// A state is a part and the side that a path comes from: 2 part + side. It leaves to the other.
using State = std::uint32_t;

// Whether a path that came to the part from `side` can take a link to `here`.
inline bool leaves(const EdgePart& part, State side, std::uint8_t here) {
  return part.is_corner() || (here >> (1 - side) & 1);
}
inline State sides_of(const EdgePart& part) { return part.is_corner() ? 1 : 2; }

// The least label of a part.
inline double least(const std::vector<LineLabel>& labels, std::uint32_t part) {
  return std::min(labels[2 * part].least(), labels[2 * part + 1].least());
}

// Parts that follow each other, which are near each other mostly: what is true of a group is not
// asked of each.
struct PartGroup {
  geom::Aabb box;     // around all
  double go;          // metres: from any to the goal, at least
  std::uint32_t end;  // the first part behind them
};

// The parts of one size that a path shorter than wanted may use.
struct Level {
  std::vector<EdgePart> parts;  // the start, the goal, then the others
  std::vector<LineLabel> come;  // of each state: known lower bounds of the way from the start
  std::vector<LineLabel> go;    // … and to the goal; not set: no path uses it
  std::vector<std::vector<Link>> links;  // of each part
  // Of the first level, whose links are made where they are needed.
  std::vector<double> linked;          // of each part: for which label
  std::vector<PartGroup> groups;       // in order
  std::vector<std::uint32_t> parents;  // of each part: in the level before; none of the first
  std::vector<Hints> hints;            // of each part: occluders that hid others from it
};

// The parts that a path of `target` metres can reach, with what the straight line says of them.
Level first_level(const PartTree& parts, const Vec3& from, const Vec3& to, double target,
                  double slack);

}  // namespace plan
