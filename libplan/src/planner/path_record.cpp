#include "plan/planner/path_record.h"

namespace plan {
namespace {

geom::SearchReport search_report(const PlanResult& result) {
  geom::SearchReport report;
  report.method = name(*result.route);
  report.expanded = result.expanded;
  if (result.resolution > 0) report.resolution = result.resolution;
  if (result.steps.size() > 1) report.steps = result.steps;
  report.layer = result.layer;
  report.snapped_start = result.snapped_start;
  report.snapped_goal = result.snapped_goal;
  return report;
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
