#include "tile_bends.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "bends.h"
#include "geom/base/error.h"
#include "geom/base/mapped_file.h"
#include "geom/base/parallel.h"

namespace plan {
namespace {

using geom::Aabb;

constexpr double kPad = 1e-2;  // metres: bends stand off their boxes by less

// Collects squares that boxes stand in.
class SquareList {
 public:
  explicit SquareList(double reach) : squares_(reach) {}

  double count(const Aabb& area) const {
    const auto [low, high] = ends(area);
    return (high.column - low.column + 1.0) * (high.row - low.row + 1.0);
  }

  void add_all(const Aabb& area, std::uint64_t boxes) {
    const auto [low, high] = ends(area);
    for (std::int32_t row = low.row; row <= high.row; ++row) {
      for (std::int32_t column = low.column; column <= high.column; ++column) {
        shares_.push_back({code_of({column, row}), boxes});
      }
    }
  }

  // Those along the sides of a box alone: bends stand there.
  void add_sides(const Aabb& box) {
    const Aabb wide = geom::grow(box, Vec3::Constant(kPad));
    for (int k = 0; k < 2; ++k) {
      for (const double side : {box.min[k], box.max[k]}) {
        Aabb strip = wide;
        strip.min[k] = side - kPad;
        strip.max[k] = side + kPad;
        add_all(strip, 1);
      }
    }
  }

  std::vector<SquareShare> sorted() {
    std::sort(shares_.begin(), shares_.end(),
              [](const SquareShare& a, const SquareShare& b) { return a.code < b.code; });
    std::vector<SquareShare> out;
    for (const SquareShare& share : shares_) {
      if (out.empty() || out.back().code != share.code) {
        out.push_back(share);
      } else {
        out.back().boxes += share.boxes;
      }
    }
    return out;
  }

 private:
  std::pair<Square, Square> ends(const Aabb& area) const {
    return {squares_.of(area.min), squares_.of(area.max)};
  }

  Squares squares_;
  std::vector<SquareShare> shares_;
};

std::vector<Bend> bends_in(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                           const Square& square) {
  const Squares squares(spec.reach);
  const Aabb area = squares.box(square, square, kPad);
  std::vector<Bend> near;
  for (const std::size_t i : scene.boxes_meeting(area)) {
    const Aabb box = scene.grown(i);
    if (spec.region && !geom::overlap(box, *spec.region)) continue;
    add_bends(scene, box, spec.part, area, near);
  }
  std::vector<Bend> out;
  std::copy_if(near.begin(), near.end(), std::back_inserter(out),
               [&](const Bend& bend) { return squares.of(bend.position) == square; });
  return out;
}

}  // namespace

std::size_t TileBends::tile_of(std::size_t bend) const {
  const auto after = std::upper_bound(first.begin(), first.end(), bend);
  return static_cast<std::size_t>(after - first.begin()) - 1;
}

std::vector<SquareShare> squares_of(const geom::CollisionScene& scene, const RoadmapSpec& spec) {
  constexpr double kFewSquares = 8;  // a box, of a tile: beyond, its boxes are looked at
  const geom::BoxMap& map = scene.map();
  SquareList list(spec.reach);
  const Vec3 off = Vec3::Constant(kPad);
  for (std::size_t t = 0; t < map.tiles().size(); ++t) {
    const geom::Tile& tile = map.tiles()[t];
    const Aabb area = geom::grow(geom::grow(tile.extent, scene.half()), off);
    if (spec.region && !geom::overlap(area, *spec.region)) continue;
    if (!tile.large && list.count(area) <= kFewSquares * static_cast<double>(tile.count)) {
      list.add_all(area, tile.count);
      continue;
    }
    for (const Aabb& box : map.boxes_of(t)) {
      const Aabb grown = geom::grow(box, scene.half());
      if (!spec.region || geom::overlap(grown, *spec.region)) list.add_sides(grown);
    }
  }
  return list.sorted();
}

TileBends bends_of(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                   std::span<const std::uint64_t> codes, const geom::Execution& run) {
  std::vector<std::vector<Bend>> of_each(codes.size());
  geom::parallel_for(codes.size(), {run.threads, {}}, [&](std::size_t i) {
    of_each[i] = bends_in(scene, spec, square_at(codes[i]));
    if (i % 16 == 0) geom::trim_mapped_files();
  });
  TileBends out;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if (of_each[i].empty()) continue;
    if (of_each[i].size() > Squares::kLocalMask) {
      throw geom::InputError(
          "roadmap", {.says = fmt::format("a tile has {} bends, more than 2^24", of_each[i].size()),
                      .advice = "give longer parts"});
    }
    out.squares.push_back(square_at(codes[i]));
    out.bends.insert(out.bends.end(), of_each[i].begin(), of_each[i].end());
    if (out.bends.size() > 0x7fffffff) {
      throw geom::InputError("roadmap",
                             {.says = "more than 2^31 bends", .advice = "make it in shards"});
    }
    out.first.push_back(static_cast<std::uint32_t>(out.bends.size()));
    std::vector<Bend>().swap(of_each[i]);
  }
  return out;
}

}  // namespace plan
