#include "plan/roadmap/patch_roadmap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

#include "bends.h"
#include "geom/base/parallel.h"
#include "patch/require_made_for.h"
#include "tiled.h"

namespace plan {
namespace {

using geom::Aabb;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr double kCell = 40;   // metres
constexpr double kPad = 1e-3;  // metres, of boxes: far more than rounding

// Each change is held against all lines in its surroundings: measured, patching is slower than
// building from about a twelfth of the boxes.
bool too_many(const MapChange& change, std::size_t boxes) {
  const std::size_t changes = change.removed.size() + change.added.size();
  return changes > std::max<std::size_t>(100, boxes / 20);
}

// For each new bend the old one that is the same, else kNone. Of several that are the same, the
// first is the first.
std::vector<std::uint32_t> match(const std::vector<Bend>& now, const std::vector<Bend>& old) {
  const auto key = [](const Bend& b) {
    return std::tuple(b.position[0], b.position[1], b.position[2], b.axis, b.outward);
  };
  const auto order = [&](const std::vector<Bend>& bends) {
    std::vector<std::uint32_t> out(bends.size());
    std::iota(out.begin(), out.end(), 0u);
    std::sort(out.begin(), out.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::tuple(key(bends[a]), a) < std::tuple(key(bends[b]), b);
    });
    return out;
  };
  std::vector<std::uint32_t> out(now.size(), kNone);
  const auto olds = order(old);
  auto at = olds.begin();
  for (const std::uint32_t i : order(now)) {
    while (at != olds.end() && key(old[*at]) < key(now[i])) ++at;
    if (at != olds.end() && key(old[*at]) == key(now[i])) out[i] = *at++;
  }
  return out;
}

bool ascends(const std::vector<std::uint32_t>& old_of) {
  std::uint32_t last = 0;
  for (const std::uint32_t old : old_of) {
    if (old == kNone) continue;
    if (old < last) return false;
    last = old;
  }
  return true;
}

struct Interval {
  double low;
  double high;

  bool apart(const Interval& other) const { return low > other.high || other.low > high; }
};

// The direction (x, y) of the plane of axes i and j.
struct Direction {
  int i;
  int j;
  double x;
  double y;
};

// Of a box along a direction, seen from `origin`.
Interval shadow(const Aabb& box, const Vec3& origin, const Direction& along) {
  const auto& [i, j, x, y] = along;
  const Vec3 low = box.min - origin;
  const Vec3 high = box.max - origin;
  return {std::min(low[i] * x, high[i] * x) + std::min(low[j] * y, high[j] * y),
          std::max(low[i] * x, high[i] * x) + std::max(low[j] * y, high[j] * y)};
}

// False only where no segment from box `a` to box `b` meets `box`: where their convex hull, seen
// along some axis, is apart from it (separating axes of what lies in a plane).
bool may_meet(const Aabb& a, const Aabb& b, Aabb box) {
  box.min.array() -= kPad;
  box.max.array() += kPad;
  if (!geom::overlap(geom::merged(a, b), box)) return false;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    for (int corner = 0; corner < 4; ++corner) {
      const auto at = [&](const Aabb& x, int axis, int bit) {
        return corner & bit ? x.max[axis] : x.min[axis];
      };
      const Direction along{i, j, at(a, j, 2) - at(b, j, 2), at(b, i, 1) - at(a, i, 1)};
      const Interval one = shadow(a, a.min, along);
      const Interval two = shadow(b, a.min, along);
      const Interval hull{std::min(one.low, two.low), std::max(one.high, two.high)};
      if (hull.apart(shadow(box, a.min, along))) return false;
    }
  }
  return true;
}

std::vector<Aabb> between(const Aabb& a, const Aabb& b, const std::vector<Aabb>& boxes) {
  std::vector<Aabb> out;
  for (const Aabb& box : boxes) {
    if (may_meet(a, b, box)) out.push_back(box);
  }
  return out;
}

bool meets_any(const Vec3& a, const Vec3& b, const std::vector<Aabb>& boxes) {
  return std::any_of(boxes.begin(), boxes.end(),
                     [&](const Aabb& box) { return geom::segment_hits(a, b, box); });
}

// Bends that are close to each other in plan.
struct Cell {
  Aabb extent;
  std::vector<std::uint32_t> bends;  // ascending
  std::vector<std::uint32_t> fresh;  // those that the old roadmap has not
};

double gap(const Aabb& a, const Aabb& b) {
  return (a.min - b.max).cwiseMax(b.min - a.max).cwiseMax(0).norm();
}

class RoadmapPatch {
 public:
  RoadmapPatch(const FlatRoadmap& old, double reach, const geom::CollisionScene& scene,
               const MapChange& change, const std::vector<Bend>& bends,
               const std::vector<std::uint32_t>& old_of)
      : old_(old),
        reach_(reach),
        scene_(scene),
        change_(change),
        bends_(bends),
        old_of_(old_of),
        new_of_(old.tiles.bends.size(), kNone),
        cell_of_(bends.size()),
        kept_(bends.size()),
        kept_split_(bends.size()),
        more_(bends.size()) {
    std::map<std::pair<std::int64_t, std::int64_t>, std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < bends.size(); ++i) {
      if (old_of[i] != kNone) new_of_[old_of[i]] = i;
      const Vec3& p = bends[i].position;
      const std::pair key{static_cast<std::int64_t>(std::floor(p.x() / kCell)),
                          static_cast<std::int64_t>(std::floor(p.y() / kCell))};
      const auto [at, is_new] = numbers.emplace(key, static_cast<std::uint32_t>(cells_.size()));
      if (is_new) cells_.push_back({{p, p}, {}, {}});
      Cell& cell = cells_[at->second];
      cell.extent = geom::merged(cell.extent, {p, p});
      cell.bends.push_back(i);
      if (is_fresh(i)) cell.fresh.push_back(i);
      cell_of_[i] = at->second;
    }
  }

  EdgeLists patched_edges(const geom::Execution& run) {
    geom::parallel_for(cells_.size(), run, [&](std::size_t c) { patch_cell(cells_[c]); });
    std::vector<std::size_t> own(bends_.size());
    for (std::size_t i = 0; i < own.size(); ++i) own[i] = more_[i].size();
    for (std::uint32_t i = 0; i < own.size(); ++i) {
      for (std::size_t e = 0; e < own[i]; ++e) more_[more_[i][e]].push_back(i);
    }
    std::vector<std::uint32_t> split(bends_.size());
    geom::parallel_for(bends_.size(), {run.threads, {}},
                       [&](std::size_t i) { split[i] = merge_edges(i); });
    EdgeLists out = flat(std::move(kept_));
    out.split = std::move(split);
    return out;
  }

 private:
  bool is_fresh(std::uint32_t bend) const { return old_of_[bend] == kNone; }

  void patch_cell(const Cell& cell) {
    std::vector<std::vector<Aabb>> added(cells_.size());  // that may block a line to each cell
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (gap(cell.extent, cells_[c].extent) > reach_) continue;
      added[c] = between(cell.extent, cells_[c].extent, change_.added);
      find_edges(cell, cells_[c], between(cell.extent, cells_[c].extent, change_.removed));
    }
    for (const std::uint32_t i : cell.bends) {
      if (!is_fresh(i)) keep_edges(i, added);
    }
  }

  // Edges that the old roadmap has not, to higher bends: those of fresh bends, and those that a box
  // was in the way of.
  void find_edges(const Cell& cell, const Cell& other, const std::vector<Aabb>& removed) {
    for (const std::uint32_t i : cell.bends) {
      const Bend& a = bends_[i];
      for (const std::uint32_t j : is_fresh(i) || !removed.empty() ? other.bends : other.fresh) {
        if (j <= i) continue;
        const bool known = !is_fresh(i) && !is_fresh(j);
        const Bend& b = bends_[j];
        if (!aligned(a, b, reach_)) continue;
        if (known && !meets_any(a.position, b.position, removed)) continue;
        if (!scene_.hits(a.position, b.position)) more_[i].push_back(j);
      }
    }
  }

  void keep_edges(std::uint32_t i, const std::vector<std::vector<Aabb>>& added) {
    const EdgeLists& edges = old_.edges;
    const std::size_t begin = edges.first[old_of_[i]];
    const std::size_t split = begin + edges.split[old_of_[i]];
    const std::size_t end = edges.first[old_of_[i] + 1];
    kept_[i].reserve(end - begin);
    for (std::size_t e = begin; e < end; ++e) {
      const std::uint32_t j = new_of_[edges.to[e]];
      if (j == kNone) continue;
      if (meets_any(bends_[i].position, bends_[j].position, added[cell_of_[j]])) continue;
      kept_[i].push_back(j);
      if (e < split) ++kept_split_[i];
    }
  }

  // Puts what is more among what was kept. Returns how many are on the first side.
  std::uint32_t merge_edges(std::size_t i) {
    std::uint32_t split = kept_split_[i];
    std::vector<EdgeKey> keys;
    for (const std::uint32_t j : more_[i]) keys.push_back(edge_key(bends_, i, j));
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> out;
    out.reserve(kept_[i].size() + keys.size());
    auto from = kept_[i].begin();
    for (const EdgeKey& key : keys) {
      const auto to = std::partition_point(
          from, kept_[i].end(), [&](std::uint32_t j) { return edge_key(bends_, i, j) < key; });
      out.insert(out.end(), from, to);
      out.push_back(key.to);
      split += !key.second;
      from = to;
    }
    out.insert(out.end(), from, kept_[i].end());
    kept_[i] = std::move(out);
    return split;
  }

  const FlatRoadmap& old_;
  double reach_;
  const geom::CollisionScene& scene_;
  const MapChange& change_;
  const std::vector<Bend>& bends_;
  const std::vector<std::uint32_t>& old_of_;
  std::vector<std::uint32_t> new_of_;   // of each old bend
  std::vector<std::uint32_t> cell_of_;  // of each new one
  std::vector<Cell> cells_;
  std::vector<std::vector<std::uint32_t>> kept_;  // edges of each, in order; in the end all
  std::vector<std::uint32_t> kept_split_;         // how many of them are on the first side
  std::vector<std::vector<std::uint32_t>> more_;
};

}  // namespace

Roadmap patch_roadmap(const Roadmap& old, const geom::CollisionScene& scene,
                      const MapChange& change, const geom::Execution& run) {
  require_made_for(old.made_for, scene, "roadmap");
  const std::size_t boxes =
      old.spec.region ? scene.boxes_meeting(*old.spec.region).size() : scene.map().size();
  if (too_many(change, boxes)) return build_roadmap(scene, old.spec, run);
  std::vector<std::uint64_t> codes;
  for (const SquareShare& share : squares_of(scene, old.spec)) codes.push_back(share.code);
  const TileBends tiles = bends_of(scene, old.spec, codes, {run.threads, {}});
  const FlatRoadmap was = flattened(old);
  const std::vector<std::uint32_t> old_of = match(tiles.bends, was.tiles.bends);
  if (!ascends(old_of)) return build_roadmap(scene, old.spec, run);
  EdgeLists edges =
      RoadmapPatch(was, old.spec.reach, scene, change, tiles.bends, old_of).patched_edges(run);
  Roadmap out = tiled(old.spec, tiles, 0, tiles.squares.size(), std::move(edges), run.threads);
  out.made_for = geom::provenance_of(scene);
  return out;
}

}  // namespace plan
