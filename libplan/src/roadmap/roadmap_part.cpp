#include "plan/roadmap/roadmap_part.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "bends.h"
#include "geom/base/mapped_file.h"
#include "geom/base/parallel.h"
#include "tile_bends.h"
#include "tiled.h"

namespace plan {
namespace {

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

// The squares that a shard looks at, and the run of them that is its own.
struct Work {
  std::vector<std::uint64_t> codes;
  std::uint64_t first = 0;  // own: [first, end) of codes
  std::uint64_t end = 0;
};

Work work_of(const std::vector<SquareShare>& all, const geom::Shard& shard,
             const Squares& squares) {
  std::uint64_t boxes = 0;
  for (const SquareShare& share : all) boxes += share.boxes;
  std::vector<char> wanted(all.size());
  std::vector<std::size_t> own;
  std::uint64_t before = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (before >= shard.begin(boxes) && before < shard.end(boxes)) own.push_back(i);
    before += all[i].boxes;
  }
  const auto place = [&](std::uint64_t code) {
    return std::lower_bound(all.begin(), all.end(), code,
                            [](const SquareShare& s, std::uint64_t c) { return s.code < c; });
  };
  for (const std::size_t i : own) {
    const Square square = square_at(all[i].code);
    for (std::uint32_t slot = 0; slot < squares.slots(); ++slot) {
      const std::uint64_t code = code_of(squares.beside(square, slot));
      const auto at = place(code);
      if (at != all.end() && at->code == code)
        wanted[static_cast<std::size_t>(at - all.begin())] = 1;
    }
  }
  Work out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (wanted[i]) out.codes.push_back(all[i].code);
  }
  if (own.empty()) return out;
  out.first = all[own.front()].code;
  out.end = all[own.back()].code + 1;
  return out;
}

// The bends that a shard's own may be linked to, and the run of tiles that is its own.
struct OwnBends {
  TileBends all;
  std::size_t first_tile;
  std::size_t end_tile;
  std::uint32_t first;
  std::uint32_t end;
};

OwnBends own_bends(TileBends all, const Work& work) {
  const auto tile = [&](std::uint64_t code) {
    const auto at = std::partition_point(all.squares.begin(), all.squares.end(),
                                         [&](const Square& s) { return code_of(s) < code; });
    return static_cast<std::size_t>(at - all.squares.begin());
  };
  const std::size_t first = tile(work.first);
  const std::size_t end = tile(work.end);
  const std::uint32_t first_bend = all.first[first];
  const std::uint32_t end_bend = all.first[end];
  return {std::move(all), first, end, first_bend, end_bend};
}

// Sorts the edges of a bend as Roadmap says. Returns how many are on the first side.
std::uint32_t sort_edges(std::span<const Bend> bends, std::size_t i, std::span<std::uint32_t> to) {
  std::vector<EdgeKey> keys;
  keys.reserve(to.size());
  for (const std::uint32_t j : to) keys.push_back(edge_key(bends, i, j));
  std::sort(keys.begin(), keys.end());
  std::uint32_t split = 0;
  for (std::size_t n = 0; n < keys.size(); ++n) {
    to[n] = keys[n].to;
    split += !keys[n].second;
  }
  return split;
}

// Edges of own bends: to later own ones, and to all that are not.
std::vector<std::vector<std::uint32_t>> found_edges(const geom::CollisionScene& scene,
                                                    const OwnBends& own, double reach,
                                                    const geom::Execution& run) {
  const std::vector<Bend>& bends = own.all.bends;
  const BendCells cells(bends, reach);
  std::vector<std::vector<std::uint32_t>> out(own.end - own.first);
  geom::parallel_for(out.size(), run, [&](std::size_t n) {
    const std::size_t i = own.first + n;
    cells.for_near(bends[i].position, [&](std::uint32_t j) {
      if (j >= own.first && j <= i) return;
      if (linked(scene, bends[i], bends[j], reach)) out[n].push_back(j);
    });
    if (n % 256 == 0) geom::trim_mapped_files();
  });
  return out;
}

// The same, but to all own bends.
EdgeLists both_ways(std::vector<std::vector<std::uint32_t>> found, const OwnBends& own) {
  EdgeLists out;
  const auto is_own = [&](std::uint32_t j) { return j >= own.first && j < own.end; };
  out.first.assign(found.size() + 1, 0);
  for (std::size_t n = 0; n < found.size(); ++n) {
    out.first[n + 1] += found[n].size();
    for (const std::uint32_t j : found[n]) {
      if (is_own(j)) ++out.first[j - own.first + std::size_t{1}];
    }
  }
  std::partial_sum(out.first.begin(), out.first.end(), out.first.begin());
  out.to.resize(out.first.back());
  std::vector<std::uint64_t> next(out.first.begin(), out.first.end() - 1);
  for (std::size_t n = 0; n < found.size(); ++n) {
    for (const std::uint32_t j : found[n]) {
      out.to[next[n]++] = j;
      if (is_own(j)) out.to[next[j - own.first]++] = static_cast<std::uint32_t>(own.first + n);
    }
    std::vector<std::uint32_t>().swap(found[n]);
  }
  return out;
}

}  // namespace

Roadmap build_roadmap_part(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                           const geom::Shard& shard, const geom::Execution& run) {
  const Work work = work_of(squares_of(scene, spec), shard, Squares(spec.reach));
  const OwnBends own = own_bends(bends_of(scene, spec, work.codes, run), work);
  EdgeLists edges = both_ways(found_edges(scene, own, spec.reach, run), own);
  edges.split.resize(own.end - own.first);
  geom::parallel_for(edges.split.size(), {run.threads, {}}, [&](std::size_t n) {
    const std::size_t begin = edges.first[n];
    const std::span to = std::span(edges.to).subspan(begin, edges.first[n + 1] - begin);
    edges.split[n] = sort_edges(own.all.bends, own.first + n, to);
  });
  Roadmap out = tiled(spec, own.all, own.first_tile, own.end_tile, std::move(edges), run.threads);
  out.made_for = geom::provenance_of(scene);
  return out;
}

Roadmap build_roadmap(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                      const geom::Execution& run) {
  return build_roadmap_part(scene, spec, {}, run);
}

}  // namespace plan
