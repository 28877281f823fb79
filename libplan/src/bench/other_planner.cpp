#include "plan/bench/other_planner.h"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <utility>

#include "geom/record/record.h"
#include "geom/record/scenes.h"
#include "geom/text/json_line.h"

namespace plan::bench {
namespace {

// A record may say for what it was made; then it must be this.
void require_ours(const geom::PathRecord& record, const geom::CollisionScene& scene,
                  std::size_t line) {
  geom::Provenance said = geom::provenance_of(scene);
  if (record.provenance.map) said.map = record.provenance.map;
  if (record.provenance.frame) said.frame = record.provenance.frame;
  if (record.provenance.vehicle) said.vehicle = record.provenance.vehicle;
  if (record.provenance.margin) said.margin = record.provenance.margin;
  geom::require_same(said, scene, fmt::format("planner-cmd:{}", line), "path");
}

}  // namespace

std::string query_lines(std::span<const geom::PlanQuery> queries) {
  std::string out;
  for (const geom::PlanQuery& query : queries) {
    out += geom::JsonLine().add("id", query.id).add("from", query.from).add("to", query.to).line();
  }
  return out;
}

Run judge_lines(const std::string& method, const AnswerLines& output,
                const geom::CollisionScene& scene, std::span<const geom::PlanQuery> queries) {
  Run run;
  run.method = method;
  run.one_process = true;
  run.peak_rss = output.peak_rss;
  std::map<std::string, Answer> answers;
  for (const geom::PlanQuery& query : queries) answers[query.id];
  std::map<std::string, bool> answered;
  for (std::size_t i = 0; i < output.lines.size(); ++i) {
    geom::PathRecord record = geom::parse_path_record(output.lines[i], "planner-cmd", i + 1);
    require_ours(record, scene, i + 1);
    const auto slot = answers.find(record.id);
    if (slot == answers.end() || std::exchange(answered[record.id], true)) {
      ++run.extra;
    } else {
      slot->second = {record.status, std::move(record.points), std::nullopt};
    }
  }
  const double mean = output.seconds / static_cast<double>(queries.size());
  for (const geom::PlanQuery& query : queries) {
    run.trials.push_back(trial_of(scene, query, answers.at(query.id), mean));
  }
  run.missing = queries.size() - (output.lines.size() - run.extra);
  return run;
}

}  // namespace plan::bench
