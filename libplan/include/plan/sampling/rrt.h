#pragma once

// The textbook sampling planners, for points in three dimensions.
//
// Example:
//   plan::SamplingOptions options;
//   options.seed = 7;
//   const plan::SamplingResult result = plan::sample_path(
//       scene, {1, 1, 1}, {9, 1, 1}, plan::SamplingMethod::rrt_connect, options);
//   assert(result.found && result.path.front() == geom::Vec3(1, 1, 1));

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "geom/collision/collision.h"
#include "geom/shape/polyline.h"
#include "geom/text/words.h"
#include "plan/sampling/search_tree.h"

namespace plan {

// rrt: LaValle, "Rapidly-Exploring Random Trees: A New Tool for Path Planning", 1998.
// rrt_connect: Kuffner and LaValle, "RRT-Connect: An Efficient Approach to Single-Query Path
//   Planning", ICRA 2000: two trees, the greedy CONNECT (figures 2 and 5).
// rrt_star: Karaman and Frazzoli, "Sampling-based Algorithms for Optimal Motion Planning", IJRR
//   30(7), 2011: algorithm 6; lengths of descendants follow every rewiring at once.
// informed_rrt_star: Gammell, Srinivasa and Barfoot, "Informed RRT*", IROS 2014: algorithms 1 and
//   2. Once a path is known, samples come from the prolate spheroid of what could shorten it.
enum class SamplingMethod { rrt, rrt_connect, rrt_star, informed_rrt_star };

// As on a command line.
inline constexpr geom::Words<SamplingMethod, 4> kSamplingWords{{
    {SamplingMethod::rrt, "rrt"},
    {SamplingMethod::rrt_connect, "rrt-connect"},
    {SamplingMethod::rrt_star, "rrt-star"},
    {SamplingMethod::informed_rrt_star, "informed-rrt-star"},
}};
constexpr std::string_view name(SamplingMethod method) {
  return geom::word_of(kSamplingWords, method);
}

// Whether it goes on to shorten the path that it has found: the "star methods".
constexpr bool is_star(SamplingMethod method) {
  return method == SamplingMethod::rrt_star || method == SamplingMethod::informed_rrt_star;
}

struct SamplingOptions {
  // Metres, > 0: the longest edge grown towards a sample. Absent: fitting_length() of 15 m.
  std::optional<double> step;
  double goal_bias = 0.05;  // how often the goal is the sample, until it is reached; in [0, 1].
                            // rrt_connect does without
  // Edges tried towards samples; the star methods use all of them. Absent: 20,000, and 100,000 of
  // the others where the longest side of the free bounds is below kCity, as in a maze of a room.
  std::optional<std::size_t> iterations;
  // Metres, >= 0: the star methods' largest neighbourhood. Absent: fitting_length() of 30 m.
  std::optional<double> radius;
  std::uint64_t seed = 0;
  // Where samples come from: what this shares with scene.free_bounds(). Absent, or if that is
  // nothing: all of scene.free_bounds().
  std::optional<geom::Aabb> region;
  bool straight_first = true;  // whether a free straight line is the answer, and no tree grown

  // The star methods end after so many iterations that in all shortened the path by less than
  // 0.1%; 0: they do not.
  std::size_t patience = 0;

  // Asked before every 16th iteration; true ends the search with what it has. May be empty. Where
  // it looks at a clock, results depend on the machine.
  std::function<bool()> stop;
};

struct SamplingResult {
  bool found = false;
  geom::Polyline path;  // start to goal, every leg free; empty unless found
  SearchTree tree;      // every edge, and first edge, free; node 0 is the start; empty where the
                        // start or the goal is not free
  std::size_t iterations = 0;   // used
  std::size_t first_found = 0;  // iterations used when the first path was known
  double first_length = 0;      // metres, of the first path; 0 unless found
  bool stopped = false;         // by options.stop
};

// A path from `from` to `to`. scene.free() alone decides on edges, so nothing is sampled along
// them. Samples come evenly from scene.free_bounds(), or from the region. Unreachable goals end
// after the iterations given. Not found, and no tree, where an end is not free (as when it is NaN);
// two points and no iterations where the ends are equal. Throws geom::InputError for an option that
// is NaN or out of its range.
//
// The neighbourhood of the star methods is min(radius, 2 (V ln n / (pi n))^(1/3)) for n nodes and V
// the volume of the free bounds: gamma (ln n / n)^(1/d) of the 2011 paper with its
// gamma = 2 (1 + 1/d)^(1/d) (V / zeta_d)^(1/d) and d = 3; V stands for the volume of the free
// space, which is less. For informed_rrt_star that knows a path, V is at most that of the spheroid,
// and n the nodes in it. Where bounds are flat it is `radius`.
//
// The same scene, options and seed give the same bytes, whatever the machine: the numbers come from
// geom::SplitMix64, the arithmetic is +, -, *, / and square roots. Cost: a logarithmic search for
// the nearest node and an edge test an iteration; the star methods test a few edges more.
// Threads may call it at once.
SamplingResult sample_path(const geom::CollisionScene& scene, const Vec3& from, const Vec3& to,
                           SamplingMethod method, const SamplingOptions& options = {});

}  // namespace plan
