// skyway-plan: collision-free paths through a box map, one per query.

#include <fmt/format.h>

#include <map>
#include <optional>

#include "cli/files.h"
#include "cli/numbers_option.h"
#include "cli/run.h"
#include "cli/vehicle_option.h"
#include "geom/error.h"
#include "geom/io/query_record.h"
#include "geom/parallel.h"
#include "plan/io/lattice_file.h"
#include "plan/io/roadmap_file.h"
#include "plan/plan.h"

namespace {

std::string search_report(const plan::PlanResult& result) {
  std::string out = fmt::format(R"({{"method":"{}","expanded":{})", result.method, result.expanded);
  const auto add = [&](const char* key, const auto& value) {
    out += fmt::format(",\"{}\":", key);
    geom::append_json(out, value);
  };
  if (result.resolution > 0) add("resolution", result.resolution);
  if (result.snapped_start) add("snapped_start", *result.snapped_start);
  if (result.snapped_goal) add("snapped_goal", *result.snapped_goal);
  return out + '}';
}

geom::PathRecord record_of(const geom::CollisionScene& scene, const geom::PlanQuery& query,
                           const plan::PlanResult& result) {
  geom::PathRecord record;
  record.id = query.id;
  record.status = plan::name(result.status);
  record.points = result.path;
  record.provenance = cli::provenance_of(scene);
  record.message = result.message;
  if (!result.method.empty()) record.search = search_report(result);
  return record;
}

const std::map<std::string, plan::Quality> kQuality = {{"fast", plan::Quality::fast},
                                                       {"normal", plan::Quality::normal},
                                                       {"best", plan::Quality::best}};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Plan collision-free paths through a box map.", "skyway-plan"};
  cli::Common common(app, true);
  cli::VehicleOptions vehicle;
  plan::PlanOptions options;
  std::string map_file;
  std::string lattice_file;
  std::string roadmap_file;
  std::string queries_file;
  std::string output = "-";
  std::optional<geom::Vec3> from;
  std::optional<geom::Vec3> to;
  app.add_option("map", map_file, "box map; - for stdin")->required();
  app.add_option("--lattice", lattice_file,
                 "lattice of the same map and vehicle (default: built as needed)");
  app.add_option("--roadmap", roadmap_file,
                 "roadmap of the same map and vehicle: shorter paths, sooner");
  app.add_option("--quality", options.quality, "fast, normal (default) or best")
      ->transform(CLI::CheckedTransformer(kQuality));
  auto* queries = app.add_option("--queries", queries_file, "JSON Lines or CSV; - for stdin");
  auto* start = cli::add_point(app, "--from", from, "start, metres");
  auto* goal = cli::add_point(app, "--to", to, "goal, metres");
  start->needs(goal)->excludes(queries);
  goal->needs(start)->excludes(queries);
  app.add_option("-o,--output", output, "paths (default: stdout)");
  app.add_flag("--raw", options.raw, "the search's own path, not shortened");
  app.add_option("--resample", options.resample, "cut the path into parts of at most this, metres")
      ->check(CLI::Range(1e-3, 1e6));
  app.add_option("--snap-ends", options.snap_ends,
                 "move a blocked or outside end to a free place within this, metres")
      ->check(CLI::Range(0.0, 1e4));
  vehicle.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    if (queries_file.empty() && !from) throw cli::UsageError("give --from and --to, or --queries");
    cli::at_most_one_stdin({map_file, lattice_file, roadmap_file, queries_file});
    cli::Scenes scenes(cli::open_map(map_file), vehicle, cli::Scenes::Differences::refused);
    const geom::CollisionScene& scene = scenes.scene();
    std::optional<plan::Lattice> lattice;
    if (!lattice_file.empty()) {
      lattice = plan::read_lattice(cli::open_archive(lattice_file));
      cli::require_same(lattice->made_for(), scene, lattice_file, "lattice");
    }
    std::optional<plan::Roadmap> roadmap;
    if (!roadmap_file.empty()) {
      roadmap = plan::read_roadmap(cli::open_archive(roadmap_file));
      cli::require_same(roadmap->made_for, scene, roadmap_file, "roadmap");
    }
    std::vector<geom::PlanQuery> list;
    if (from) {
      list.push_back({"q1", *from, *to});
    } else {
      cli::InputFile file(queries_file);
      list = geom::read_plan_queries(file.stream(), file.name());
    }
    const geom::Execution run = common.execution("paths");
    plan::Planner planner(scene, lattice ? &*lattice : nullptr, roadmap ? &*roadmap : nullptr);
    std::vector<geom::PathRecord> records(list.size());
    geom::parallel_for(list.size(), run, [&](std::size_t i) {
      records[i] = record_of(scene, list[i], planner.plan(list[i].from, list[i].to, options));
    });
    cli::OutputFile out(output, cli::OutputKind::text);
    std::size_t found = 0;
    for (const geom::PathRecord& record : records) {
      found += record.status == "found";
      out.stream() << geom::to_json_line(record);
    }
    out.commit();
    common.write_stats({{"queries", records.size()}, {"found", found}});
    if (records.size() == 1 && !found) fmt::print(stderr, "skyway-plan: {}\n", records[0].message);
    return found == records.size() ? cli::Exit::yes : cli::Exit::no;
  });
}
