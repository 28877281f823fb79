#include <algorithm>
#include <utility>

#include "bound_planes.h"
#include "geom/shape/empty_box.h"
#include "traj/solve/corridor.h"

namespace traj {
namespace {

constexpr double kLongestSeed = 40;     // metres
constexpr double kLargestStepBack = 2;  // metres: how much neighbouring boxes share at least to try
constexpr double kOverlap = 0.5;     // metres an axis, for two boxes to be taken one after another
constexpr double kLeastStep = 1e-9;  // metres between the begins of two boxes
constexpr std::size_t kCuts = 2000;  // of a search for an empty box
constexpr int kDeepest = 60;         // halvings of a seed

// A place on a path.
struct Place {
  std::size_t leg = 0;
  double part = 0;  // of the leg, 0 to 1
};

class BoxChain {
 public:
  BoxChain(const geom::CollisionScene& scene, const geom::Polyline& path, double reach)
      : scene_(scene), path_(path), reach_(reach) {}

  // Empty where a seed cannot be found, or boxes get no further: rounding could bring that about,
  // and a path that is not clear does.
  std::vector<geom::Aabb> boxes() {
    std::vector<geom::Aabb> out;
    Place at;
    while (true) {
      const auto seed = seed_from(at);
      const auto box = seed ? largest_around(*seed) : std::nullopt;
      if (!box) return {};
      const Place exit = exit_from(*box, at);
      out.push_back(*box);
      exits_.push_back(point(exit));
      if (exit.leg + 1 == path_.size()) return out;
      const Place before = std::exchange(at, stepped_back(exit, at));
      if (!is_beyond(at, before)) return {};
    }
  }

  const geom::Polyline& exits() const { return exits_; }  // where the path leaves each box

 private:
  Vec3 point(const Place& p) const {
    if (p.leg + 1 == path_.size()) return path_.back();
    return path_[p.leg] + p.part * (path_[p.leg + 1] - path_[p.leg]);
  }

  bool is_beyond(const Place& p, const Place& before) const {
    if (p.leg != before.leg) return p.leg > before.leg;
    const double length = (path_[p.leg + 1] - path_[p.leg]).norm();
    return (p.part - before.part) * length > kLeastStep;
  }

  // The box around a part of the leg ahead, as long as halving a reach makes it clear.
  std::optional<geom::Aabb> seed_from(const Place& at) const {
    const Vec3 from = point(at);
    Vec3 ahead = path_[at.leg + 1] - from;
    ahead *= std::min(1.0, kLongestSeed / std::max(ahead.norm(), 1e-300));
    for (int i = 0; i < kDeepest; ++i, ahead *= 0.5) {
      const Vec3 to = from + ahead;
      const geom::Aabb seed{from.cwiseMin(to), from.cwiseMax(to)};
      const bool inside = scene_.inside_bounds(seed.min) && scene_.inside_bounds(seed.max);
      if (inside && scene_.boxes_meeting(seed).empty()) return seed;
    }
    return std::nullopt;
  }

  std::optional<geom::Aabb> largest_around(const geom::Aabb& seed) const {
    const Vec3 reach = Vec3::Constant(reach_);
    const geom::Aabb& free = *scene_.free_bounds();
    const geom::Aabb limits{(seed.min - reach).cwiseMax(free.min),
                            (seed.max + reach).cwiseMin(free.max)};
    std::vector<geom::Aabb> obstacles;
    for (const std::size_t i : scene_.boxes_meeting(limits)) obstacles.push_back(scene_.grown(i));
    const auto found = geom::empty_box(seed, limits, obstacles, kCuts);
    return found ? std::optional(found->box) : std::nullopt;
  }

  // The first place at or after `at`, which is in the box, where the path leaves it; its end where
  // it does not.
  Place exit_from(const geom::Aabb& box, Place at) const {
    for (; at.leg + 1 < path_.size(); ++at.leg, at.part = 0) {
      if (geom::contains(box, path_[at.leg + 1])) continue;
      const Vec3& a = path_[at.leg];
      const Vec3 step = path_[at.leg + 1] - a;
      double out = 1;
      for (int i = 0; i < 3; ++i) {
        if (step[i] > 0) out = std::min(out, (box.max[i] - a[i]) / step[i]);
        if (step[i] < 0) out = std::min(out, (box.min[i] - a[i]) / step[i]);
      }
      return {at.leg, std::max(at.part, out)};
    }
    return at;
  }

  // Up to 2 m before the exit on its leg, and past `at`.
  Place stepped_back(const Place& exit, const Place& at) const {
    const double length = (path_[exit.leg + 1] - path_[exit.leg]).norm();
    const double begin = exit.leg == at.leg ? at.part : 0;
    const double back = std::min(kLargestStepBack / length, (exit.part - begin) / 2);
    return {exit.leg, exit.part - back};
  }

  const geom::CollisionScene& scene_;
  const geom::Polyline& path_;
  double reach_;
  geom::Polyline exits_;
};

geom::Aabb common(const geom::Aabb& a, const geom::Aabb& b) {
  return {a.min.cwiseMax(b.min), a.max.cwiseMin(b.max)};
}

// The boxes that a chain needs: after each the last that shares half a metre with it.
std::vector<std::size_t> needed(const std::vector<geom::Aabb>& boxes) {
  std::vector<std::size_t> out{0};
  while (out.back() + 1 < boxes.size()) {
    std::size_t next = out.back() + 1;
    for (std::size_t i = boxes.size() - 1; i > next; --i) {
      const geom::Aabb shared = common(boxes[out.back()], boxes[i]);
      if ((shared.max - shared.min).minCoeff() >= kOverlap) next = i;
    }
    out.push_back(next);
  }
  return out;
}

// The place in both boxes nearest to `p`, away from their faces where there is room.
Vec3 crossing(const geom::Aabb& a, const geom::Aabb& b, const Vec3& p) {
  geom::Aabb shared = common(a, b);
  const Vec3 inset = ((shared.max - shared.min) / 4).cwiseMin(Vec3::Ones());
  return p.cwiseMax(shared.min + inset).cwiseMin(shared.max - inset);
}

}  // namespace

Corridor box_corridor(const geom::CollisionScene& scene, const geom::Polyline& path, double reach) {
  if (path.size() < 2 || !scene.free_bounds()) return {};
  BoxChain chain(scene, path, reach);
  const std::vector<geom::Aabb> boxes = chain.boxes();
  if (boxes.empty()) return {};
  const std::vector<std::size_t> kept = needed(boxes);
  geom::Polyline corners{path.front()};
  for (std::size_t k = 1; k < kept.size(); ++k) {
    corners.push_back(crossing(boxes[kept[k - 1]], boxes[kept[k]], chain.exits()[kept[k - 1]]));
  }
  corners.push_back(path.back());
  Corridor corridor = pieces_between(joints(corners));
  std::size_t leg = 0;
  for (CorridorPiece& piece : corridor) {
    for (const Separation& s : bound_planes(piece, boxes[kept[leg]])) {
      piece.planes.push_back(s.plane);
    }
    while (leg + 1 < kept.size() && piece.to == corners[leg + 1]) ++leg;
  }
  return corridor;
}

}  // namespace traj
