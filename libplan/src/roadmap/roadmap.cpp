#include "plan/roadmap/roadmap.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "bends.h"
#include "geom/base/error.h"
#include "geom/base/parallel.h"
#include "lattice/heap.h"
#include "plan/lattice/build_lattice.h"

namespace plan {
namespace {

constexpr double kCell = 40;     // metres, of the cells that start links are sought in
constexpr double kLoose = 0.08;  // how far a turn may miss wrapping: bends stand in for their part

// Whether a path that comes from one direction and leaves in another, both tangent, wraps around
// the box: seen from outside it turns by at least a half circle.
bool wraps(const Across& in, const Across& out) {
  if (in.second_side() == out.second_side()) return false;
  return in.second_side() ? out.ratio() <= in.ratio() + kLoose : out.ratio() >= in.ratio() - kLoose;
}

}  // namespace

struct RoadmapSearch::Impl {
  Impl(const geom::CollisionScene& scene, const Roadmap& roadmap);

  RoadmapResult search(const Vec3& from, const Vec3& to, const RoadmapLimits& limits);

  struct Visit {
    double cost = 0;
    std::uint32_t from = 0;  // bend, or kStart
    std::uint32_t stamp = 0;
    bool settled = false;
  };
  struct Open {
    double bound;
    double cost;
    std::uint32_t bend;
    enum Kind : std::uint8_t { reached, unlinked, cell } kind;
  };
  struct Cell {
    geom::Aabb extent;
    std::vector<std::uint32_t> bends;
  };
  static constexpr std::uint32_t kStart = 0xffffffffu;

  static bool earlier(const Open& a, const Open& b);
  void push(const Open& open);
  void reach(std::uint32_t from, std::uint32_t to, double cost, const Vec3& goal);
  void look_around(std::uint32_t bend, const Vec3& arrived_from, const Vec3& goal);
  void expand(std::uint32_t bend, const Vec3& arrived_from, const Vec3& goal);
  geom::Polyline trace(std::uint32_t bend, const Vec3& from, const Vec3& to) const;

  const geom::CollisionScene* scene_;
  const Roadmap* roadmap_;
  std::vector<Cell> cells_;
  double weight_ = 1;
  std::vector<Visit> visits_;
  std::vector<Open> open_;
  std::uint32_t stamp_ = 0;
};

void require_bend(const Roadmap& roadmap, std::uint32_t bend) {
  if (bend < roadmap.bends.size()) return;
  throw geom::InputError(roadmap.source,
                         fmt::format("an edge leads to bend {} of {}", bend, roadmap.bends.size()));
}

Roadmap bends_along(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                    const geom::Polyline& path, double width) {
  constexpr double kPiece = 50;  // metres: bounding boxes of longer ones would hold too much
  Roadmap out;
  out.spec = spec;
  out.made_for = geom::provenance_of(scene);
  std::vector<std::size_t> near;
  const geom::Polyline pieces = geom::resample(path, kPiece);
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const geom::Aabb piece{pieces[i - 1].cwiseMin(pieces[i]), pieces[i - 1].cwiseMax(pieces[i])};
    for (const std::size_t box : scene.boxes_meeting(geom::grow(piece, Vec3::Constant(width)))) {
      near.push_back(box);
    }
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  std::vector<geom::Aabb> boxes;
  for (const std::size_t i : near) boxes.push_back(scene.grown(i));
  out.bends = make_bends(scene, spec, boxes, {});
  return out;
}

LabelledLattice label_components(Lattice lattice) {
  const LatticeGrid& grid = lattice.grid();
  std::vector<std::uint32_t> masks(lattice.size());
  Lattice::Block block;
  for (std::size_t b = 0; b < grid.block_count(); ++b) {
    lattice.read(b, block);
    const Index3 low = grid.block_low(b);
    for (std::size_t n = 0; n < block.size(); ++n) {
      const auto local = static_cast<std::int64_t>(n);
      const auto node = lattice.node({low[0] + local % LatticeGrid::kSide,
                                      low[1] + local / LatticeGrid::kSide % LatticeGrid::kSide,
                                      low[2] + local / (LatticeGrid::kSide * LatticeGrid::kSide)});
      if (node) masks[*node] = block[n];
    }
  }
  std::vector<std::uint32_t> label(masks.size());
  std::uint32_t labels = 0;
  std::vector<std::size_t> open;
  for (std::size_t start = 0; start < masks.size(); ++start) {
    if (!(masks[start] & Lattice::kNode) || label[start]) continue;
    label[start] = ++labels;
    open.push_back(start);
    while (!open.empty()) {
      const std::size_t from = open.back();
      open.pop_back();
      for (std::uint32_t m = masks[from] & ~Lattice::kNode; m; m &= m - 1) {
        const auto to = static_cast<std::size_t>(static_cast<std::int64_t>(from) +
                                                 lattice.offset(std::countr_zero(m)));
        if (label[to]) continue;
        label[to] = labels;
        open.push_back(to);
      }
    }
  }
  return {std::move(lattice), std::move(label)};
}

RoadmapSearch::Impl::Impl(const geom::CollisionScene& scene, const Roadmap& roadmap)
    : scene_(&scene), roadmap_(&roadmap), visits_(roadmap.bends.size()) {
  std::map<std::array<std::int64_t, 3>, std::vector<std::uint32_t>> cells;
  for (std::size_t i = 0; i < roadmap.bends.size(); ++i) {
    std::array<std::int64_t, 3> key;
    for (int k = 0; k < 3; ++k) {
      key[static_cast<std::size_t>(k)] =
          static_cast<std::int64_t>(std::floor(roadmap.bends[i].position[k] / kCell));
    }
    cells[key].push_back(static_cast<std::uint32_t>(i));
  }
  for (auto& [key, bends] : cells) {
    Cell cell{{roadmap.bends[bends[0]].position, roadmap.bends[bends[0]].position}, {}};
    for (const std::uint32_t i : bends) {
      const Vec3& p = roadmap.bends[i].position;
      cell.extent = geom::merged(cell.extent, {p, p});
    }
    cell.bends = std::move(bends);
    cells_.push_back(std::move(cell));
  }
}

// Ties go to the larger cost, then by kind, then to the lowest bend or cell.
inline bool RoadmapSearch::Impl::earlier(const Open& a, const Open& b) {
  if (a.bound != b.bound) return a.bound < b.bound;
  if (a.cost != b.cost) return a.cost > b.cost;
  return a.kind != b.kind ? a.kind < b.kind : a.bend < b.bend;
}

void RoadmapSearch::Impl::push(const Open& open) {
  heap_push(open_, open, [](const Open& a, const Open& b) { return earlier(a, b); });
}

void RoadmapSearch::Impl::reach(std::uint32_t i, std::uint32_t j, double through,
                                const Vec3& goal) {
  visits_[j] = {through, i, stamp_, false};
  push(
      {through + weight_ * (goal - roadmap_->bends[j].position).norm(), through, j, Open::reached});
}

// Where the roadmap has no edges: those that matter, looked for.
void RoadmapSearch::Impl::look_around(std::uint32_t i, const Vec3& arrived_from, const Vec3& goal) {
  const Roadmap& map = *roadmap_;
  const Bend& bend = map.bends[i];
  const Across in = across(bend, arrived_from - bend.position);
  const double cost = visits_[i].cost;
  const double reach2 = map.spec.reach * map.spec.reach;
  const auto look_at = [&](std::uint32_t j) {
    const Bend& other = map.bends[j];
    const Vec3 d = other.position - bend.position;
    const double square = d.squaredNorm();
    if (j == i || square > reach2) return;
    const double through = cost + std::sqrt(square);
    const Visit& visit = visits_[j];
    if (visit.stamp == stamp_ && (visit.settled || visit.cost <= through)) return;
    const Across out = across(bend, d);
    if (!out.tangent() || !wraps(in, out) || !across(other, -d).tangent()) return;
    if (!scene_->hits(bend.position, other.position)) reach(i, j, through, goal);
  };
  for (const Cell& cell : cells_) {
    if (geom::distance(bend.position, cell.extent) > map.spec.reach) continue;
    for (const std::uint32_t j : cell.bends) look_at(j);
  }
}

// The edges that keep wrapping around the bend's box for a path from there.
void RoadmapSearch::Impl::expand(std::uint32_t i, const Vec3& arrived_from, const Vec3& goal) {
  const Roadmap& map = *roadmap_;
  const Bend& bend = map.bends[i];
  const Across in = across(bend, arrived_from - bend.position);
  const std::uint32_t* const edges = map.to.data() + map.first[i];
  const std::size_t split = map.split[i];
  const std::size_t count = map.first[i + 1] - map.first[i];
  const auto ratio = [&](std::size_t e) {
    require_bend(map, edges[e]);
    return across(bend, map.bends[edges[e]].position - bend.position).ratio();
  };
  std::size_t begin = 0;
  std::size_t end = split;
  if (in.second_side()) {  // out on the first side, by at most as much
    const double most = in.ratio() + kLoose;
    for (std::size_t left = 0; left < end;) {
      const std::size_t middle = left + (end - left) / 2;
      if (ratio(middle) <= most) {
        left = middle + 1;
      } else {
        end = middle;
      }
    }
  } else {  // out on the second side, by at least as much
    const double least = in.ratio() - kLoose;
    begin = split;
    end = count;
    for (std::size_t right = count; begin < right;) {
      const std::size_t middle = begin + (right - begin) / 2;
      if (ratio(middle) < least) {
        begin = middle + 1;
      } else {
        right = middle;
      }
    }
  }
  const double cost = visits_[i].cost;
  for (std::size_t e = begin; e < end; ++e) {
    const std::uint32_t j = edges[e];
    require_bend(map, j);
    const Vec3& p = map.bends[j].position;
    const double through = cost + (p - bend.position).norm();
    const Visit& visit = visits_[j];
    if (visit.stamp == stamp_ && (visit.settled || visit.cost <= through)) continue;
    reach(i, j, through, goal);
  }
}

geom::Polyline RoadmapSearch::Impl::trace(std::uint32_t bend, const Vec3& from,
                                          const Vec3& to) const {
  geom::Polyline path = {to};
  for (; bend != kStart; bend = visits_[bend].from) {
    path.push_back(roadmap_->bends[bend].position);
  }
  path.push_back(from);
  std::reverse(path.begin(), path.end());
  return path;
}

RoadmapResult RoadmapSearch::Impl::search(const Vec3& from, const Vec3& to,
                                          const RoadmapLimits& limits) {
  RoadmapResult result;
  weight_ = limits.weight;
  open_.clear();
  if (++stamp_ == 0) {
    std::fill(visits_.begin(), visits_.end(), Visit{});
    stamp_ = 1;
  }
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const double bound =
        geom::distance(from, cells_[c].extent) + weight_ * geom::distance(to, cells_[c].extent);
    push({bound, 0, static_cast<std::uint32_t>(c), Open::cell});
  }
  double longest = std::numeric_limits<double>::infinity();
  while (!open_.empty() && open_.front().bound <= longest) {
    const Open top = heap_pop(open_, [](const Open& a, const Open& b) { return earlier(a, b); });
    if (top.kind == Open::cell) {
      for (const std::uint32_t i : cells_[top.bend].bends) {
        const Bend& bend = roadmap_->bends[i];
        const Vec3& p = bend.position;
        if (!across(bend, from - p).tangent()) continue;
        const double cost = (p - from).norm();
        push({cost + weight_ * (to - p).norm(), cost, i, Open::unlinked});
      }
      continue;
    }
    const Bend& bend = roadmap_->bends[top.bend];
    Visit& visit = visits_[top.bend];
    const bool seen = visit.stamp == stamp_;
    if (seen && visit.settled) continue;
    if (top.kind == Open::unlinked) {
      if (seen && visit.cost <= top.cost) continue;
      if (scene_->hits(from, bend.position)) continue;
      visit = {top.cost, kStart, stamp_, false};
    } else if (visit.cost < top.cost) {
      continue;
    }
    visit.settled = true;
    if (++result.settled > limits.settled) break;
    const Vec3 back = visit.from == kStart ? from : roadmap_->bends[visit.from].position;
    const Across in = across(bend, back - bend.position);
    const Across out = across(bend, to - bend.position);
    if (out.tangent() && wraps(in, out) && !scene_->hits(bend.position, to)) {
      if (result.paths.empty()) longest = top.bound * (1 + limits.beyond);
      result.paths.push_back(trace(top.bend, from, to));
      if (result.paths.size() == limits.paths) return result;
    }
    if (roadmap_->first.empty()) {
      look_around(top.bend, back, to);
    } else {
      expand(top.bend, back, to);
    }
  }
  result.gave_up = result.paths.empty();
  return result;
}

RoadmapSearch::RoadmapSearch(const geom::CollisionScene& scene, const Roadmap& roadmap)
    : impl_(std::make_unique<Impl>(scene, roadmap)) {}
RoadmapSearch::~RoadmapSearch() = default;

RoadmapResult RoadmapSearch::search(const Vec3& from, const Vec3& to, const RoadmapLimits& limits) {
  return impl_->search(from, to, limits);
}

}  // namespace plan
