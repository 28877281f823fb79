#include "bends.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geom/base/error.h"
#include "geom/base/parallel.h"
#include "uncovered.h"

namespace plan {
namespace {

constexpr double kOff = 1e-3;  // metres that bends keep from their box

// One edge of a grown box: along `axis`, at the lower or upper ends of the next two. `near` are the
// grown boxes that meet the box, or come within kOff of it.
class BoxEdge {
 public:
  BoxEdge(const geom::CollisionScene& scene, std::span<const geom::Aabb> near,
          const geom::Aabb& box, int axis, int corner)
      : scene_(scene), near_(near), box_(box), k_(axis), i1_((axis + 1) % 3), i2_((axis + 2) % 3) {
    outward_ = {static_cast<std::int8_t>(corner & 1 ? 1 : -1),
                static_cast<std::int8_t>(corner & 2 ? 1 : -1)};
  }

  // In the middle of what is exposed of each part.
  void add_bends(double part, std::vector<Bend>& out) const {
    const std::vector<Interval> blocked = covered(1, 1);
    const auto open = exposed(blocked);
    const double length = box_.max[k_] - box_.min[k_];
    const double parts = std::max(1.0, std::ceil(length / part));
    for (double n = 0; n < parts; ++n) {
      const double from = box_.min[k_] + length * (n / parts);
      const double to = box_.min[k_] + length * ((n + 1) / parts);
      for (const auto& [low, high] : open) {
        if (high < from || low > to) continue;
        const double middle = 0.5 * (std::max(low, from) + std::min(high, to));
        const Bend bend{beside(1, 1, middle), static_cast<std::int8_t>(k_), outward_};
        if (free(bend.position, blocked)) out.push_back(bend);
      }
    }
  }

 private:
  Vec3 beside(double side1, double side2, double along) const {
    Vec3 p;
    p[k_] = along;
    p[i1_] = (outward_[0] > 0 ? box_.max[i1_] : box_.min[i1_]) + side1 * kOff * outward_[0];
    p[i2_] = (outward_[1] > 0 ? box_.max[i2_] : box_.min[i2_]) + side2 * kOff * outward_[1];
    return p;
  }

  // The other boxes that cover some of the line just off the edge, in one of its quadrants.
  std::vector<Interval> covered(double side1, double side2) const {
    const Vec3 p = beside(side1, side2, 0);
    std::vector<Interval> out;
    for (const geom::Aabb& other : near_) {
      const bool inside = p[i1_] >= other.min[i1_] && p[i1_] <= other.max[i1_] &&
                          p[i2_] >= other.min[i2_] && p[i2_] <= other.max[i2_] &&
                          box_.max[k_] >= other.min[k_] && box_.min[k_] <= other.max[k_];
      if (inside && !(other == box_)) out.push_back({other.min[k_], other.max[k_]});
    }
    return out;
  }

  // Where the three outer quadrants are free, each looked at along a line just off the edge.
  std::vector<Interval> exposed(std::vector<Interval> blocked) const {
    for (const double side : {-1.0, 1.0}) {
      const auto more = covered(side, -side);
      blocked.insert(blocked.end(), more.begin(), more.end());
    }
    return uncovered(box_.min[k_], box_.max[k_], std::move(blocked));
  }

  // scene.free() of a point of the line in the outermost quadrant, of which this is `blocked`.
  bool free(const Vec3& p, const std::vector<Interval>& blocked) const {
    for (const auto& [low, high] : blocked) {
      if (p[k_] >= low && p[k_] <= high) return false;
    }
    return scene_.inside_bounds(p);
  }

  const geom::CollisionScene& scene_;
  std::span<const geom::Aabb> near_;
  const geom::Aabb& box_;
  int k_;
  int i1_;
  int i2_;
  std::array<std::int8_t, 2> outward_{};
};

void add_bends(const geom::CollisionScene& scene, const geom::Aabb& box, double part,
               std::vector<Bend>& out) {
  const Vec3 off = Vec3::Constant(2 * kOff);
  std::vector<geom::Aabb> near;
  for (const std::size_t i : scene.boxes_meeting(geom::grow(box, off))) {
    near.push_back(scene.grown(i));
  }
  for (int k = 0; k < 3; ++k) {
    for (int corner = 0; corner < 4; ++corner) {
      BoxEdge(scene, near, box, k, corner).add_bends(part, out);
    }
  }
}

}  // namespace

std::vector<geom::Aabb> boxes_of(const geom::CollisionScene& scene,
                                 const std::optional<geom::Aabb>& region) {
  std::vector<geom::Aabb> out;
  if (region) {
    for (const std::size_t i : scene.boxes_meeting(*region)) out.push_back(scene.grown(i));
  } else {
    for (const geom::Aabb& box : scene.map().boxes()) out.push_back(geom::grow(box, scene.half()));
  }
  return out;
}

std::vector<std::vector<Bend>> bends_of_each(const geom::CollisionScene& scene,
                                             const RoadmapSpec& spec,
                                             std::span<const geom::Aabb> boxes,
                                             const geom::Execution& run) {
  std::vector<std::vector<Bend>> out(boxes.size());
  geom::parallel_for(boxes.size(), {run.threads, {}},
                     [&](std::size_t i) { add_bends(scene, boxes[i], spec.part, out[i]); });
  return out;
}

std::vector<Bend> make_bends(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                             const std::vector<geom::Aabb>& boxes, const geom::Execution& run) {
  std::vector<Bend> out;
  for (const auto& some : bends_of_each(scene, spec, boxes, run)) {
    out.insert(out.end(), some.begin(), some.end());
  }
  return out;
}

bool operator<(const EdgeKey& a, const EdgeKey& b) {
  return std::tie(a.second, a.ratio, a.to) < std::tie(b.second, b.ratio, b.to);
}

EdgeKey edge_key(const std::vector<Bend>& bends, std::size_t from, std::uint32_t to) {
  const Across a = across(bends[from], bends[to].position - bends[from].position);
  return {a.second_side(), a.ratio(), to};
}

void require_edges_fit(std::uint64_t edges) {
  if (edges <= 0x7fffffff) return;
  throw geom::InputError(
      "roadmap", fmt::format("expected at most 2^31 edges, found {}: use a smaller reach", edges));
}

LatticeSpec coarse_spec(const geom::CollisionScene& scene) {
  return {10, Connectivity::twenty_six, scene.free_bounds()->min};
}

}  // namespace plan
