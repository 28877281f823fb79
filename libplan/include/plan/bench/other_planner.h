#pragma once

// Answers that somebody else's planner wrote, judged as those of ours are.
//
// Example:
//   const geom::PlanQuery query{.id = "q1", .from = {1, 1, 1}, .to = {1, 9, 1}};
//   const std::vector queries = {query};
//   std::cout << plan::bench::query_lines(queries);  // what the planner reads
//   plan::bench::AnswerLines answers;
//   answers.lines = {R"({"type":"path","id":"q1","status":"found","points":[[1,1,1],[1,9,1]]})"};
//   const auto run = plan::bench::judge_lines("theirs", answers, scene, queries);
//   assert(run.trials[0].verdict == plan::bench::Verdict::found);

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/record/query_record.h"
#include "plan/bench/trial.h"

namespace plan::bench {

// What a planner wrote, and what it took.
struct AnswerLines {
  std::vector<std::string> lines;  // path records, without blank ones
  double seconds = 0;              // wall, from its start to its end
  std::size_t peak_rss = 0;        // bytes: of the largest of its processes
};

// The queries as the planner gets them, a line each.
std::string query_lines(std::span<const geom::PlanQuery> queries);

// Answers matched by id. Every trial takes the mean of the whole time. Throws
// InputError("planner-cmd", line, …) for a line that is no path record, or one that says that it
// was made for another map, frame, vehicle or margin than the scene's.
Run judge_lines(const std::string& method, const AnswerLines& answers,
                const geom::CollisionScene& scene, std::span<const geom::PlanQuery> queries);

}  // namespace plan::bench
