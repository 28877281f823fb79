#include "plan/planner/path_record.h"

#include <fmt/format.h>

namespace plan {
namespace {

std::string search_report(const PlanResult& result) {
  std::string out =
      fmt::format(R"({{"method":"{}","expanded":{})", name(*result.route), result.expanded);
  const auto add = [&](const char* key, const auto& value) {
    out += fmt::format(",\"{}\":", key);
    geom::append_json(out, value);
  };
  if (result.resolution > 0) add("resolution", result.resolution);
  if (result.steps.size() > 1) {
    out += ",\"steps\":[";
    for (const PathStep& step : result.steps) {
      out += fmt::format(R"({}{{"step":"{}","points":{},"length":)",
                         &step == result.steps.data() ? "" : ",", step.name, step.points);
      geom::append_json(out, step.length);
      out += '}';
    }
    out += ']';
  }
  if (result.snapped_start) add("snapped_start", *result.snapped_start);
  if (result.snapped_goal) add("snapped_goal", *result.snapped_goal);
  return out + '}';
}

}  // namespace

geom::PathRecord path_record(const geom::CollisionScene& scene, std::string id,
                             const PlanResult& result) {
  geom::PathRecord record;
  record.id = std::move(id);
  record.status = result.status;
  record.points = result.path;
  record.provenance = geom::provenance_of(scene);
  record.message = result.message;
  if (result.route) record.search = search_report(result);
  return record;
}

}  // namespace plan
