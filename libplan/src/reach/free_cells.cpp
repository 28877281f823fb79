#include "free_cells.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "geom/base/error.h"

namespace plan {
namespace {

using geom::Aabb;

constexpr std::size_t kFew = 24;      // boxes of which every face is tried as a cut
constexpr std::size_t kSample = 255;  // boxes of many whose faces' median is the cut

bool covers(const Aabb& box, const Aabb& region) {
  return (box.min.array() <= region.min.array()).all() &&
         (box.max.array() >= region.max.array()).all();
}

}  // namespace

struct FreeCells::Face {
  int axis;
  double at;
  bool up;  // to larger coordinates
  const Aabb& cell;
};

FreeCells::FreeCells(const geom::CollisionScene& scene, const Listed& most)
    : scene_(scene), most_(most) {
  Node root;
  root.region = *scene.free_bounds();
  for (int i = 0; i < 3; ++i) flat_[i] = root.region.min[i] == root.region.max[i];
  if (scene.map().size() > std::numeric_limits<std::uint32_t>::max()) {
    throw geom::InputError("map", {.expected = "fewer than 2^32 boxes to cut free space at"});
  }
  nodes_.push_back(std::move(root));
}

// Whether the box has points inside the region: of a flat axis, in it.
bool FreeCells::meets_inside(const Aabb& box, const Aabb& region) const {
  for (int i = 0; i < 3; ++i) {
    const bool meets = flat_[i] ? box.min[i] <= region.max[i] && box.max[i] >= region.min[i]
                                : box.min[i] < region.max[i] && box.max[i] > region.min[i];
    if (!meets) return false;
  }
  return true;
}

// The face within the region that leaves the fewest boxes in its two halves together: of few boxes
// of all faces, of many of the three medians of a sample. No box covers the region, so there is
// one.
FreeCells::Cut FreeCells::best_cut(const Aabb& region,
                                   const std::vector<std::uint32_t>& boxes) const {
  std::vector<Aabb> sample;
  const std::size_t count = boxes.size() > kFew ? std::min(boxes.size(), kSample) : boxes.size();
  for (std::size_t i = 0; i < count; ++i) {
    sample.push_back(scene_.grown(boxes[i * boxes.size() / count]));
  }
  Cut best;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  const auto try_cut = [&](int axis, double at) {
    std::size_t halves = 0;
    for (const Aabb& box : sample) halves += (box.min[axis] < at) + (box.max[axis] > at);
    if (halves >= least) return;
    least = halves;
    best = {axis, at};
  };
  std::vector<double> faces;
  for (int axis = 0; axis < 3; ++axis) {
    faces.clear();
    for (const Aabb& box : sample) {
      for (const double at : {box.min[axis], box.max[axis]}) {
        if (region.min[axis] < at && at < region.max[axis]) faces.push_back(at);
      }
    }
    if (faces.empty()) continue;
    std::sort(faces.begin(), faces.end());
    if (boxes.size() > kFew) {
      try_cut(axis, faces[faces.size() / 2]);
    } else {
      for (const double at : faces) try_cut(axis, at);
    }
  }
  return best;
}

// Room for two more nodes, so that they are added without a failure.
void FreeCells::make_room() {
  if (nodes_.capacity() - nodes_.size() < 2) nodes_.reserve(2 * nodes_.size() + 2);
}

// Finds the boxes of an open node; false where there are too many for so large a region.
bool FreeCells::list(std::uint32_t node) {
  const Aabb region = nodes_[node].region;
  const bool large = (region.max - region.min).maxCoeff() > most_.side;
  const auto near = large ? scene_.boxes_meeting(region, most_.boxes)
                          : std::optional(scene_.boxes_meeting(region));
  if (!near) return false;
  std::vector<std::uint32_t> boxes;
  for (const std::size_t i : *near) {
    if (meets_inside(scene_.grown(i), region)) boxes.push_back(static_cast<std::uint32_t>(i));
  }
  nodes_[node].boxes = std::move(boxes);
  nodes_[node].listed = true;
  return true;
}

// Says what an open node is. Where memory runs out it stays open, with its boxes if it has them:
// nothing is changed before all that may fail is done.
void FreeCells::settle(std::uint32_t node) {
  make_room();
  const Aabb region = nodes_[node].region;
  if (!nodes_[node].listed && !list(node)) {
    int longest;
    (region.max - region.min).maxCoeff(&longest);
    split(node, {longest, 0.5 * (region.min[longest] + region.max[longest])});
    return;
  }
  const std::vector<std::uint32_t>& boxes = nodes_[node].boxes;
  if (boxes.empty()) {
    nodes_[node].kind = Kind::free;
    return;
  }
  if (std::any_of(boxes.begin(), boxes.end(),
                  [&](std::uint32_t i) { return covers(scene_.grown(i), region); })) {
    nodes_[node].kind = Kind::blocked;
    std::vector<std::uint32_t>().swap(nodes_[node].boxes);
    return;
  }
  split(node, best_cut(region, boxes));
}

// Once there is room for its halves.
void FreeCells::split(std::uint32_t node, const Cut& cut) {
  Node low;
  Node high;
  low.region = high.region = nodes_[node].region;
  low.listed = high.listed = nodes_[node].listed;
  low.region.max[cut.axis] = high.region.min[cut.axis] = cut.at;
  for (const std::uint32_t i : nodes_[node].boxes) {
    const Aabb box = scene_.grown(i);
    if (box.min[cut.axis] < cut.at) low.boxes.push_back(i);
    if (box.max[cut.axis] > cut.at) high.boxes.push_back(i);
  }
  const auto first = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(std::move(low));
  nodes_.push_back(std::move(high));
  Node& settled = nodes_[node];
  settled.kind = Kind::cut;
  settled.axis = static_cast<std::uint8_t>(cut.axis);
  settled.at = cut.at;
  settled.low = first;
  std::vector<std::uint32_t>().swap(settled.boxes);
}

std::uint32_t FreeCells::cell_at(const Vec3& p) {
  std::uint32_t node = 0;
  while (true) {
    if (nodes_[node].kind == Kind::open) settle(node);
    const Node& n = nodes_[node];
    if (n.kind != Kind::cut) return node;
    node = n.low + (p[n.axis] > n.at ? 1 : 0);
  }
}

// The free cells of a node that lie against a face, on its other side.
void FreeCells::beyond(std::uint32_t node, const Face& face, std::vector<std::uint32_t>& out) {
  if (nodes_[node].kind == Kind::open) settle(node);
  const Node& n = nodes_[node];
  if (n.kind == Kind::blocked) return;
  if (n.kind == Kind::free) {
    out.push_back(node);
    return;
  }
  const std::uint32_t low = n.low;
  const int axis = n.axis;
  const double at = n.at;
  bool in_low;
  bool in_high;
  if (axis == face.axis) {
    in_low = face.up ? face.at < at : face.at <= at;
    in_high = !in_low;
  } else {
    in_low = face.cell.min[axis] < at;
    in_high = face.cell.max[axis] > at;
  }
  if (in_low) beyond(low, face, out);
  if (in_high) beyond(low + 1, face, out);
}

void FreeCells::neighbours(std::uint32_t cell, std::vector<std::uint32_t>& out) {
  out.clear();
  const Aabb region = nodes_[cell].region;
  const Aabb bounds = nodes_[0].region;
  for (int axis = 0; axis < 3; ++axis) {
    if (flat_[axis]) continue;
    if (region.min[axis] > bounds.min[axis]) {
      beyond(0, {axis, region.min[axis], false, region}, out);
    }
    if (region.max[axis] < bounds.max[axis]) {
      beyond(0, {axis, region.max[axis], true, region}, out);
    }
  }
}

}  // namespace plan
