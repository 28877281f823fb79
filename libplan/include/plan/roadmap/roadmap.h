#pragma once

// Taut visibility roadmaps: bends at box edges, joined where a taut string may run.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/base/execution.h"
#include "geom/collision/collision.h"
#include "geom/record/record.h"
#include "geom/shape/polyline.h"
#include "plan/lattice/lattice.h"

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

// A lattice and which of its nodes are joined by paths on it.
struct LabelledLattice {
  Lattice lattice;
  std::vector<std::uint32_t> label;  // of each node; 0: blocked
};

LabelledLattice label_components(Lattice lattice);

// Immutable. Edges of bend i are to[first[i]] … to[first[i + 1]]; the first `split[i]` of them run
// to the side where, across the box edge and with outward signs, x < y, the others to the other
// side; each part ascends by |y| / (|x| + |y|). So the edges that keep wrapping around the box from
// a given direction are one range of one part.
struct Roadmap {
  RoadmapSpec spec;
  geom::Provenance made_for;  // map, frame, vehicle, margin
  std::vector<Bend> bends;
  std::vector<std::uint64_t> first;  // one more than bends
  std::vector<std::uint32_t> split;
  std::span<const std::uint32_t> to;       // read from a file as searches go: see require_bend
  std::shared_ptr<const void> keep_alive;  // of what `to` is a part of
  std::string source = "roadmap";          // for messages
  std::optional<LabelledLattice> coarse;   // of 10 m, 26 neighbours, where bends are sought
};

// Throws geom::InputError where an edge of a file leads to no bend.
void require_bend(const Roadmap& roadmap, std::uint32_t bend);

// The bends of a roadmap without its edges and lattice, around boxes that come within `width`
// metres of the path (by their bounding boxes): RoadmapSearch then works out edges where it needs
// them.
Roadmap bends_along(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                    const geom::Polyline& path, double width);

// Bends are kept where the space around the box edge, but for the box, is free, and inside the
// bounds; edges where the bends are within reach, see each other (exact), and the line is tangent
// to both boxes. Cost: bends times those within reach of each. The same for any number of threads.
// Throws geom::InputError where there would be more than 2^31 edges.
Roadmap build_roadmap(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                      const geom::Execution& run = {});

struct RoadmapLimits {
  std::size_t settled = 20000;  // bends: gives up beyond, and in a roadmap with edges beyond eight
                                // times as many that the start turns out not to see
  std::size_t paths = 1;        // how many to find
  double beyond = 0;            // none longer than the shortest by more than this share of it
  double weight = 1;            // >= 1, of the distance to the goal: more looks at fewer bends, and
                                // the path may be longer than the shortest by this factor
};

struct RoadmapResult {
  std::vector<geom::Polyline> paths;  // start to goal, shortest first; empty where none was found
  std::size_t settled = 0;            // bends
  bool gave_up =
      false;  // none by the limit or the end of the roadmap: there may be one all the same
};

// Shortest taut paths that end with different bends, by A* with the straight-line distance; links
// to start and goal are checked only when they could matter. Ties go to the lowest bend. The
// workspace is kept between searches, and no search depends on an earlier one. Roadmap and scene
// must outlive it; one thread at a time.
class RoadmapSearch {
 public:
  RoadmapSearch(const geom::CollisionScene& scene, const Roadmap& roadmap);
  ~RoadmapSearch();

  // Start and goal are free and do not see each other.
  RoadmapResult search(const Vec3& from, const Vec3& to, const RoadmapLimits& limits);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace plan
