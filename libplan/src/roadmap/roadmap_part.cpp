#include "plan/roadmap/roadmap_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "bends.h"
#include "geom/base/error.h"
#include "geom/base/mapped_file.h"
#include "geom/base/parallel.h"

namespace plan {
namespace {

using geom::Aabb;

constexpr double kPad = 1e-2;  // metres: bends stand off their boxes by less

// Bends by square cells of the plan, as wide as the reach: all that may be linked to one are in the
// nine around it.
class BendCells {
 public:
  BendCells(const std::vector<Bend>& bends, double side) : side_(side) {
    for (std::size_t i = 0; i < bends.size(); ++i) {
      cells_[key(bends[i].position)].push_back(static_cast<std::uint32_t>(i));
    }
  }

  // Calls f(bend) for all in the nine cells around p.
  template <class F>
  void for_near(const Vec3& p, const F& f) const {
    const auto [x, y] = key(p);
    for (std::int64_t i = x - 1; i <= x + 1; ++i) {
      for (std::int64_t j = y - 1; j <= y + 1; ++j) {
        const auto at = cells_.find({i, j});
        if (at == cells_.end()) continue;
        for (const std::uint32_t bend : at->second) f(bend);
      }
    }
  }

 private:
  std::pair<std::int64_t, std::int64_t> key(const Vec3& p) const {
    return {static_cast<std::int64_t>(std::floor(p.x() / side_)),
            static_cast<std::int64_t>(std::floor(p.y() / side_))};
  }

  double side_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::uint32_t>> cells_;
};

// Sorts the edges of a bend as Roadmap says. Returns how many are on the first side.
std::uint32_t sort_edges(const std::vector<Bend>& bends, std::size_t i,
                         std::span<std::uint32_t> to) {
  std::vector<EdgeKey> keys;
  for (const std::uint32_t j : to) keys.push_back(edge_key(bends, i, j));
  std::sort(keys.begin(), keys.end());
  std::uint32_t split = 0;
  for (std::size_t n = 0; n < keys.size(); ++n) {
    to[n] = keys[n].to;
    split += !keys[n].second;
  }
  return split;
}

// The boxes that a roadmap goes round, by their place in its order: all of the map, or those that
// meet the region.
class BoxOrder {
 public:
  BoxOrder(const geom::CollisionScene& scene, const std::optional<Aabb>& region) : scene_(scene) {
    if (!region) {
      count_ = scene.map().size();
      return;
    }
    box_ = scene.boxes_meeting(*region);
    count_ = box_.size();
    for (std::size_t place = 0; place < count_; ++place) place_.emplace_back(box_[place], place);
    std::sort(place_.begin(), place_.end());
    chosen_ = true;
  }

  std::size_t count() const { return count_; }

  // The grown boxes at [begin, end).
  std::vector<Aabb> grown(std::size_t begin, std::size_t end) const {
    std::vector<Aabb> out;
    if (chosen_) {
      for (std::size_t i = begin; i < end; ++i) out.push_back(scene_.grown(box_[i]));
      return out;
    }
    const geom::BoxMap& map = scene_.map();
    for (std::size_t t = 0; t < map.tiles().size(); ++t) {
      const geom::Tile& tile = map.tiles()[t];
      const std::size_t from = std::max(tile.first, begin);
      const std::size_t to = std::min(tile.first + tile.count, end);
      if (from >= to) continue;
      const auto boxes = map.boxes_of(t);
      for (std::size_t i = from; i < to; ++i) {
        out.push_back(geom::grow(boxes[i - tile.first], scene_.half()));
      }
    }
    return out;
  }

  // Places from `begin` on of boxes that meet one of the regions, ascending.
  std::vector<std::size_t> meeting(std::span<const Aabb> regions, std::size_t begin) const {
    std::vector<std::size_t> out;
    for (const Aabb& region : regions) {
      for (const std::size_t box : scene_.boxes_meeting(region)) {
        if (const auto place = place_of(box); place && *place >= begin) out.push_back(*place);
      }
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  Aabb grown(std::size_t place) const { return scene_.grown(chosen_ ? box_[place] : place); }

 private:
  std::optional<std::size_t> place_of(std::size_t box) const {
    if (!chosen_) return box;
    const auto at = std::lower_bound(place_.begin(), place_.end(), std::pair(box, std::size_t{0}));
    if (at == place_.end() || at->first != box) return std::nullopt;
    return at->second;
  }

  const geom::CollisionScene& scene_;
  std::size_t count_ = 0;
  bool chosen_ = false;
  std::vector<std::size_t> box_;
  std::vector<std::pair<std::size_t, std::size_t>> place_;  // of each box
};

// What lies within reach of boxes: a region for every few of them, as they stand near each other.
std::vector<Aabb> around(std::span<const Aabb> boxes, double reach) {
  constexpr std::size_t kFew = 256;
  std::vector<Aabb> out;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Aabb region = geom::grow(boxes[i], Vec3::Constant(reach + kPad));
    if (i % kFew == 0) {
      out.push_back(region);
    } else {
      out.back() = geom::merged(out.back(), region);
    }
  }
  return out;
}

std::vector<std::uint32_t> sizes(const std::vector<std::vector<Bend>>& lists) {
  std::vector<std::uint32_t> out;
  for (const auto& list : lists) out.push_back(static_cast<std::uint32_t>(list.size()));
  return out;
}

[[noreturn]] void refuse(std::size_t shard, std::string_view what) {
  throw geom::InputError("roadmap", fmt::format("shard {} {}", shard + 1, what));
}

// Where the bends of all parts stand in their roadmap.
class Numbering {
 public:
  explicit Numbering(std::span<const RoadmapPart> parts) : first_of_box_{0} {
    for (std::size_t s = 0; s < parts.size(); ++s) {
      const RoadmapPart& part = parts[s];
      const geom::Shard shard{s, parts.size()};
      if (part.boxes != parts.front().boxes ||
          part.bends_of.size() != shard.end(part.boxes) - shard.begin(part.boxes)) {
        refuse(s, "has another number of boxes than it should");
      }
      for (const std::uint32_t n : part.bends_of) first_of_box_.push_back(first_of_box_.back() + n);
      if (first_of_box_.back() - first_of_box_[shard.begin(part.boxes)] != part.bends.size()) {
        refuse(s, "has another number of bends than its boxes");
      }
    }
    if (first_of_box_.back() > 0x7fffffff) refuse(parts.size() - 1, "makes more than 2^31 bends");
  }

  std::size_t bends() const { return first_of_box_.back(); }

  // Of a bend as the part numbers it, for all that it has edges to.
  std::vector<std::uint32_t> of_part(const RoadmapPart& part, std::size_t s,
                                     std::size_t shards) const {
    const std::size_t begin = first_of_box_[geom::Shard{s, shards}.begin(part.boxes)];
    std::vector<std::uint32_t> out(part.bends.size());
    std::iota(out.begin(), out.end(), static_cast<std::uint32_t>(begin));
    for (std::size_t i = 0; i < part.near_box.size(); ++i) {
      const std::size_t box = part.near_box[i];
      if (box < geom::Shard{s, shards}.end(part.boxes) || box >= part.boxes ||
          first_of_box_[box + 1] - first_of_box_[box] != part.near_bends[i]) {
        refuse(s, fmt::format("does not fit the shard of box {}", box));
      }
      for (std::uint32_t n = 0; n < part.near_bends[i]; ++n) {
        out.push_back(static_cast<std::uint32_t>(first_of_box_[box] + n));
      }
    }
    return out;
  }

 private:
  std::vector<std::size_t> first_of_box_;
};

// Calls f(bend, later bend) for every edge of the parts, numbered as in the roadmap.
template <class F>
void for_each_edge(std::span<const RoadmapPart> parts, const Numbering& numbering, const F& f) {
  for (std::size_t s = 0; s < parts.size(); ++s) {
    const auto number = numbering.of_part(parts[s], s, parts.size());
    for (std::size_t i = 0; i < parts[s].bends.size(); ++i) {
      std::size_t least = i + 1;
      for (const std::uint32_t j : parts[s].edges.of(i)) {
        if (j < least || j >= number.size())
          refuse(s, "has an edge that is impossible: the file is damaged");
        least = j + std::size_t{1};
        f(number[i], number[j]);
      }
    }
    geom::trim_mapped_files();
  }
}

// Both directions of all edges, in the order that Roadmap wants.
void join_edges(std::span<const RoadmapPart> parts, const Numbering& numbering, Roadmap& roadmap,
                unsigned threads) {
  const std::size_t n = roadmap.bends.size();
  roadmap.first.assign(n + 1, 0);
  for_each_edge(parts, numbering, [&](std::uint32_t i, std::uint32_t j) {
    ++roadmap.first[i + std::size_t{1}];
    ++roadmap.first[j + std::size_t{1}];
  });
  std::partial_sum(roadmap.first.begin(), roadmap.first.end(), roadmap.first.begin());
  require_edges_fit(roadmap.first.back());
  const auto owned = std::make_shared<std::vector<std::uint32_t>>(roadmap.first.back());
  std::vector<std::uint64_t> next(roadmap.first.begin(), roadmap.first.end() - 1);
  for_each_edge(parts, numbering, [&](std::uint32_t i, std::uint32_t j) {
    (*owned)[next[i]++] = j;
    (*owned)[next[j]++] = i;
  });
  roadmap.split.resize(n);
  geom::parallel_for(n, {threads, {}}, [&](std::size_t i) {
    const std::size_t first = roadmap.first[i];
    const std::span to = std::span(*owned).subspan(first, roadmap.first[i + 1] - first);
    roadmap.split[i] = sort_edges(roadmap.bends, i, to);
  });
  roadmap.to = *owned;
  roadmap.keep_alive = owned;
}

}  // namespace

RoadmapPart build_roadmap_part(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                               const geom::Shard& shard, const geom::Execution& run) {
  RoadmapPart part;
  part.spec = spec;
  part.made_for = geom::provenance_of(scene);
  part.shard = shard;
  const BoxOrder order(scene, spec.region);
  part.boxes = order.count();
  const std::size_t end = shard.end(part.boxes);
  std::vector<Aabb> boxes = order.grown(shard.begin(part.boxes), end);
  const auto own = bends_of_each(scene, spec, boxes, run);
  part.bends_of = sizes(own);
  for (const auto& some : own) part.bends.insert(part.bends.end(), some.begin(), some.end());

  const auto near = end == part.boxes ? std::vector<std::size_t>{}
                                      : order.meeting(around(boxes, spec.reach), end);
  boxes.clear();
  for (const std::size_t place : near) {
    part.near_box.push_back(static_cast<std::uint32_t>(place));
    boxes.push_back(order.grown(place));
  }
  const auto others = bends_of_each(scene, spec, boxes, run);
  part.near_bends = sizes(others);
  std::vector<Bend> all = part.bends;
  for (const auto& some : others) all.insert(all.end(), some.begin(), some.end());

  const BendCells cells(all, spec.reach);
  std::vector<std::vector<std::uint32_t>> to(part.bends.size());
  geom::parallel_for(part.bends.size(), run, [&](std::size_t i) {
    cells.for_near(all[i].position, [&](std::uint32_t j) {
      if (j > i && linked(scene, all[i], all[j], spec.reach)) to[i].push_back(j);
    });
    std::sort(to[i].begin(), to[i].end());
  });
  part.edges = flat(std::move(to));
  if (scene.free_bounds()) {
    part.coarse =
        build_lattice_part(scene, coarse_spec(scene), shard, {run.threads, {}}, spec.region);
  }
  return part;
}

EdgeLists flat(std::vector<std::vector<std::uint32_t>> lists) {
  struct Owned {
    std::vector<std::uint64_t> first{0};
    std::vector<std::uint32_t> to;
  };
  const auto owned = std::make_shared<Owned>();
  std::size_t edges = 0;
  for (const auto& list : lists) edges += list.size();
  owned->to.reserve(edges);
  for (auto& list : lists) {
    owned->to.insert(owned->to.end(), list.begin(), list.end());
    owned->first.push_back(owned->to.size());
    std::vector<std::uint32_t>().swap(list);
  }
  return {owned->first, owned->to, owned};
}

Roadmap join_roadmap(std::span<const RoadmapPart> parts, const geom::Execution& run) {
  const Numbering numbering(parts);
  Roadmap out;
  out.spec = parts.front().spec;
  out.made_for = parts.front().made_for;
  std::vector<LatticePart> coarse;
  for (const RoadmapPart& part : parts) {
    out.bends.insert(out.bends.end(), part.bends.begin(), part.bends.end());
    if (part.coarse) coarse.push_back(*part.coarse);
  }
  join_edges(parts, numbering, out, run.threads);
  if (!coarse.empty() && coarse.size() != parts.size()) refuse(0, "has a lattice, others do not");
  if (!coarse.empty()) out.coarse = label_components(join_lattice(coarse));
  return out;
}

Roadmap build_roadmap(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                      const geom::Execution& run) {
  const RoadmapPart whole = build_roadmap_part(scene, spec, {}, run);
  return join_roadmap({&whole, 1}, run);
}

}  // namespace plan
