#pragma once

// Taut visibility roadmaps: bends at box edges, joined where a taut string may run.
//
// Example:
//   const plan::Roadmap roadmap = plan::build_roadmap(scene, {.part = 2});
//   plan::RoadmapSearch search(scene, roadmap);
//   const plan::RoadmapResult result = search.search({1, 1, 1}, {9, 1, 1}, {});
//   assert(!result.paths.empty());

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/base/execution.h"
#include "geom/collision/collision.h"
#include "geom/record/record.h"
#include "geom/shape/polyline.h"

namespace plan {

using geom::Vec3;

// A place where a path may bend around a box edge: the middle of a part of it, just outside.
struct Bend {
  Vec3 position;
  std::int8_t axis = 0;                        // the edge runs along it
  std::array<std::int8_t, 2> outward{{1, 1}};  // signs along the next two axes, away from the box
};

struct RoadmapSpec {
  double part = 10;                  // metres: box edges are cut into equal parts of at most this
  double reach = 500;                // metres: the longest edge of the roadmap
  std::optional<geom::Aabb> region;  // only around boxes that, once grown, meet it
};

// Immutable, and cheap to copy: the arrays are mapped from a file or owned. Bends are kept in
// tiles, which are squares of the plan, so that only the tiles that a search touches are read. An
// edge names a tile near its own and the number of a bend in that (docs/formats.md). The edges of
// bend i begin at edge_first[i] of those of its tile; the first edge_split[i] of them run to the
// side where, across the box edge and with outward signs, x < y, the others to the other side; each
// part ascends by |y| / (|x| + |y|). So the edges that keep wrapping around the box from a given
// direction are one range of one part. Nothing of it is verified before it is used.
struct Roadmap {
  RoadmapSpec spec;
  geom::Provenance made_for;                  // map, frame, vehicle, margin
  std::span<const std::int32_t> tile_index;   // column and row of each square
  std::span<const float> tile_extent;         // of its bends: least x, y, z, greatest x, y, z
  std::span<const std::uint64_t> tile_first;  // its first bend; one more than tiles
  std::span<const std::uint64_t> tile_edges;  // its first edge; one more than tiles
  std::span<const double> bend_position;      // x, y, z
  std::span<const std::int8_t> bend_axis;
  std::span<const std::int8_t> bend_outward;  // two each
  std::span<const std::uint32_t> edge_first;
  std::span<const std::uint32_t> edge_split;
  std::span<const std::uint32_t> edge_to;
  std::shared_ptr<const void> keep_alive;  // of all these
  std::string source = "roadmap";          // for messages

  std::size_t tiles() const { return tile_index.size() / 2; }
  std::size_t bends() const { return bend_axis.size(); }
  std::size_t edges() const { return edge_to.size() / 2; }  // that can be used both ways
  Bend bend(std::size_t i) const {
    return {Vec3(bend_position[3 * i], bend_position[3 * i + 1], bend_position[3 * i + 2]),
            bend_axis[i],
            {bend_outward[2 * i], bend_outward[2 * i + 1]}};
  }
};

// Bends around boxes that come within `width` metres of the path (by their bounding boxes).
std::vector<Bend> bends_along(const geom::CollisionScene& scene, double part,
                              const geom::Polyline& path, double width);

// Bends are kept where the space around the box edge, but for the box, is free, and inside the
// bounds; edges where the bends are within reach, see each other (exact), and the line is tangent
// to both boxes. Cost: bends times those within reach of each. The same for any number of threads.
// Throws geom::InputError where a tile would have more than 2^24 bends.
Roadmap build_roadmap(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                      const geom::Execution& run = {});

struct RoadmapLimits {
  std::size_t settled = 20000;  // bends: gives up beyond, and in a roadmap with edges beyond eight
                                // times as many that the start turns out not to see
  std::size_t paths = 1;        // how many to find
  double beyond = 0;            // none longer than the shortest by more than this share of it
  double shorter = std::numeric_limits<double>::infinity();  // metres: paths as long are not sought
  double weight = 1;  // >= 1, of the distance to the goal: more looks at fewer bends, and
                      // the path may be longer than the shortest by this factor
};

struct RoadmapResult {
  std::vector<geom::Polyline> paths;  // start to goal, shortest first; empty where none was found
  std::size_t settled = 0;            // bends
  bool gave_up =
      false;  // none by the limit or the end of the roadmap: there may be one all the same
};

// Shortest taut paths that end with different bends, by A* with the straight-line distance; links
// to start and goal are checked only when they could matter. Ties go to the bend whose x, then y,
// then z is lowest. What was read of the roadmap is kept between searches, and no search depends on
// an earlier one. Roadmap and scene must outlive it; one thread at a time.
class RoadmapSearch {
 public:
  // A search throws geom::InputError if it meets numbers that no roadmap has.
  RoadmapSearch(const geom::CollisionScene& scene, const Roadmap& roadmap);

  // On bends without edges: a search works out the edges that it needs.
  RoadmapSearch(const geom::CollisionScene& scene, std::vector<Bend> bends, double reach);
  ~RoadmapSearch();

  // Start and goal are free and do not see each other.
  RoadmapResult search(const Vec3& from, const Vec3& to, const RoadmapLimits& limits);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace plan
