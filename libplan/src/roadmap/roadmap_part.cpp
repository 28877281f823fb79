#include "plan/roadmap/roadmap_part.h"

#include <algorithm>
#include <numeric>

#include "bends.h"
#include "found_edges.h"
#include "geom/base/parallel.h"
#include "tiled.h"

namespace plan {
namespace {

// The squares of a shard: the boxes near them are its share of all.
SquareRun run_of(const std::vector<SquareShare>& all, const geom::Shard& shard) {
  std::uint64_t boxes = 0;
  for (const SquareShare& share : all) boxes += share.boxes;
  SquareRun out;
  std::uint64_t before = 0;
  for (const SquareShare& share : all) {
    out.begin += before < shard.begin(boxes);
    out.end += before < shard.end(boxes);
    before += share.boxes;
  }
  return out;
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

// The same, but to all own bends.
EdgeLists both_ways(std::vector<std::vector<std::uint32_t>> found, const OwnBends& own) {
  EdgeLists out;
  out.first.assign(found.size() + 1, 0);
  for (std::size_t n = 0; n < found.size(); ++n) {
    out.first[n + 1] += found[n].size();
    for (const std::uint32_t j : found[n]) {
      if (own.is_own(j)) ++out.first[j - own.first + std::size_t{1}];
    }
  }
  std::partial_sum(out.first.begin(), out.first.end(), out.first.begin());
  out.to.resize(out.first.back());
  std::vector<std::uint64_t> next(out.first.begin(), out.first.end() - 1);
  for (std::size_t n = 0; n < found.size(); ++n) {
    for (const std::uint32_t j : found[n]) {
      out.to[next[n]++] = j;
      if (own.is_own(j)) out.to[next[j - own.first]++] = static_cast<std::uint32_t>(own.first + n);
    }
    std::vector<std::uint32_t>().swap(found[n]);
  }
  return out;
}

}  // namespace

Roadmap build_roadmap_part(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                           const geom::Shard& shard, const geom::Execution& run) {
  const std::vector<SquareShare> all = squares_of(scene, spec);
  const OwnBends own = own_bends(scene, spec, around(all, run_of(all, shard), spec.reach), run);
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
