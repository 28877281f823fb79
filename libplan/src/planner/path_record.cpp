#include "plan/planner/path_record.h"

#include "geom/text/json_line.h"

namespace plan {
namespace {

std::string search_report(const PlanResult& result) {
  geom::JsonLine report;
  report.add("method", name(*result.route)).add("expanded", result.expanded);
  if (result.resolution > 0) report.add("resolution", result.resolution);
  if (result.steps.size() > 1) {
    report.add("steps", result.steps, [](const PathStep& s) {
      return geom::JsonLine().add("step", s.name).add("points", s.points).add("length", s.length);
    });
  }
  report.add("layer", result.layer);
  report.add("snapped_start", result.snapped_start).add("snapped_goal", result.snapped_goal);
  return report.object();
}

}  // namespace

geom::PathRecord path_record(const geom::CollisionScene& scene, std::string id,
                             const PlanResult& result) {
  geom::PathRecord record;
  record.id = std::move(id);
  record.status = result.status;
  record.points = result.path;
  record.provenance = geom::provenance_of(scene);
  record.closed_times = !scene.map().timed().empty();
  record.message = result.message;
  if (result.bound) record.bound = result.bound->bound;
  if (result.route) record.search = search_report(result);
  return record;
}

}  // namespace plan
