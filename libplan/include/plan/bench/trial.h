#pragma once

// What one planner made of one query, and the proof that decides it.
//
// Example:
//   const geom::PlanQuery query{.id = "q1", .from = {1, 1, 1}, .to = {9, 1, 1}};
//   const plan::bench::Answer answer{geom::PathStatus::found, path, {}};
//   assert(plan::bench::judge(scene, query, answer) == plan::bench::Verdict::found);

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/record/path_status.h"
#include "geom/record/query_record.h"
#include "geom/shape/polyline.h"

namespace plan::bench {

// A planner's answer. Any status but found and unreachable is that of a planner that failed. The
// path is empty unless found.
struct Answer {
  geom::PathStatus status = geom::PathStatus::stopped;
  geom::Polyline path;
  std::optional<std::size_t> expanded;  // nodes, where the planner counts them
};

enum class Verdict {
  found,        // a path, and every leg of it is free
  unreachable,  // the planner says that there is none between ends that are free
  failed,       // it gave no answer; or there can be none, as an end is not free
  invalid       // it gave a path that is none
};

// Exact: the ends must be the query's, bit for bit, and every leg must pass scene.free(). Whether
// an end is free is decided here too, so that planners that call such a query unreachable and those
// that call it blocked count alike.
Verdict judge(const geom::CollisionScene& scene, const geom::PlanQuery& query,
              const Answer& answer);

// How short a path of the query can be at all, as far as it was proved.
struct Bound {
  double length = 0;    // metres: no path is shorter
  bool closed = false;  // within what was wanted of the shortest path that is known
};

struct Trial {
  Verdict verdict = Verdict::failed;
  double seconds = 0;
  double length = 0;    // metres, of a path that was found
  double straight = 0;  // metres between the ends
  std::optional<double> best_known;
  std::optional<Bound> bound;  // where asked for, of a path that was found
  std::optional<std::size_t> expanded;
};

Trial trial_of(const geom::CollisionScene& scene, const geom::PlanQuery& query,
               const Answer& answer, double seconds);

// All trials of one method; trial i is query i of the set.
struct Run {
  std::string method;
  std::vector<Trial> trials;
  std::optional<bool> converged;        // where asked for: the mean time is known well enough
  bool one_process = false;             // timed as a whole: each trial has the mean
  std::optional<double> build_seconds;  // wall, of what was built before the first query
  std::size_t missing = 0;              // queries without an answer; counted as failed too
  std::size_t extra = 0;                // answers to no query, or to one already answered
  std::optional<std::size_t> peak_rss;  // bytes
};

std::size_t count(const Run& run, Verdict verdict);

}  // namespace plan::bench
