#include "found_edges.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "bends.h"
#include "geom/base/mapped_file.h"
#include "geom/base/parallel.h"

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

}  // namespace

SquaresAround around(const std::vector<SquareShare>& all, const SquareRun& run, double reach) {
  const Squares squares(reach);
  std::vector<char> wanted(all.size());
  const auto before = [](const SquareShare& share, std::uint64_t code) {
    return share.code < code;
  };
  for (std::size_t i = run.begin; i < run.end; ++i) {
    const Square square = square_at(all[i].code);
    for (std::uint32_t slot = 0; slot < squares.slots(); ++slot) {
      const std::uint64_t code = code_of(squares.beside(square, slot));
      const auto at = std::lower_bound(all.begin(), all.end(), code, before);
      if (at == all.end() || at->code != code) continue;
      wanted[static_cast<std::size_t>(at - all.begin())] = 1;
    }
  }
  SquaresAround out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i == run.begin) out.own.begin = out.codes.size();
    if (wanted[i]) out.codes.push_back(all[i].code);
    if (i + 1 == run.end) out.own.end = out.codes.size();
  }
  return out;
}

OwnBends own_bends(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                   const SquaresAround& squares, const geom::Execution& run) {
  OwnBends out{.all = bends_of(scene, spec, squares.codes, run)};
  const SquareRun& own = squares.own;
  if (own.begin == own.end) return out;
  const auto tiles_before = [&](std::uint64_t code) {
    const auto at = std::partition_point(out.all.squares.begin(), out.all.squares.end(),
                                         [&](const Square& s) { return code_of(s) < code; });
    return static_cast<std::size_t>(at - out.all.squares.begin());
  };
  out.first_tile = tiles_before(squares.codes[own.begin]);
  out.end_tile = tiles_before(squares.codes[own.end - 1] + 1);
  out.first = out.all.first[out.first_tile];
  out.end = out.all.first[out.end_tile];
  return out;
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

}  // namespace plan
