#include "queries_option.h"

#include "cli/file/files.h"
#include "cli/option/numbers_option.h"
#include "cli/run.h"
#include "geom/record/locator.h"

namespace planning {
namespace {

bool on_earth(const geom::Place& place) { return std::holds_alternative<geom::EarthPlace>(place); }

}  // namespace

void QueriesOption::add_to(CLI::App& app) {
  auto* queries = app.add_option("--queries", file_, "JSON Lines, CSV or GeoJSON; - for stdin");
  auto* start = cli::add_place(
      app, "--from", from_,
      "start: x,y,z in metres along the map's axes, or 60.1719N,24.9414E,30 (degrees, and "
      "metres above the map's zero; 2above: above what stands there)");
  auto* goal = cli::add_place(app, "--to", to_, "goal, in the same forms");
  start->needs(goal)->excludes(queries);
  goal->needs(start)->excludes(queries);
  metres_.add_to(app);
}

void QueriesOption::require_some(bool sharded) const {
  if (file_.empty() && !from_) throw cli::UsageError("give --from and --to, or --queries");
  if (sharded && file_.empty()) throw cli::UsageError("--shard requires --queries");
}

std::vector<geom::PlanQuery> QueriesOption::read(const geom::CollisionScene& scene) const {
  const geom::Locator locator(scene.map());
  if (from_) {
    const geom::PlanQuery query{"q1",
                                locator.at(*from_, "--from", 0),
                                locator.at(*to_, "--to", 0),
                                {},
                                0,
                                on_earth(*from_),
                                on_earth(*to_)};
    metres_.check_option(scene.map().spec().frame, geom::ends_in_metres(query), "--from and --to");
    return {query};
  }
  cli::InputFile input(file_);
  auto queries = geom::read_plan_queries(input.stream(), input.name(), &locator);
  metres_.check_queries(scene, queries, input.name());
  return queries;
}

}  // namespace planning
