// skyway-plan: collision-free paths through a box map, one per query.

#include <fmt/format.h>

#include <optional>

#include "cli/artefacts.h"
#include "cli/files.h"
#include "cli/numbers_option.h"
#include "cli/quality_option.h"
#include "cli/record_output.h"
#include "cli/run.h"
#include "cli/vehicle_option.h"
#include "geom/io/query_record.h"
#include "geom/mapped_file.h"
#include "geom/parallel.h"
#include "plan/io/path_record.h"
#include "plan/io/search_tree.h"
#include "planning/search_options.h"

namespace {

// The one query of the options, or those of a file.
struct Asked {
  std::optional<geom::Vec3> from;
  std::optional<geom::Vec3> to;
  std::string file;

  CLI::Option* add_to(CLI::App& app) {
    auto* queries = app.add_option("--queries", file, "JSON Lines or CSV; - for stdin");
    auto* start = cli::add_point(app, "--from", from, "start, metres");
    auto* goal = cli::add_point(app, "--to", to, "goal, metres");
    start->needs(goal)->excludes(queries);
    goal->needs(start)->excludes(queries);
    return queries;
  }
  std::vector<geom::PlanQuery> queries() const {
    if (from) return {{"q1", *from, *to}};
    cli::InputFile input(file);
    return geom::read_plan_queries(input.stream(), input.name());
  }
};

struct Planned {
  std::vector<geom::PathRecord> records;
  plan::SearchTree tree;  // of the one query, where it is to be written
};

Planned plan_each(plan::Planner& planner, const geom::CollisionScene& scene,
                  const std::vector<geom::PlanQuery>& queries, const geom::Shard& shard,
                  const planning::SearchOptions& search, const geom::Execution& run) {
  const std::vector<std::size_t> chosen = shard.items(queries.size());
  Planned out;
  out.records.resize(chosen.size());
  geom::parallel_for(chosen.size(), run, [&](std::size_t i) {
    const geom::PlanQuery& query = queries[chosen[i]];
    plan::PlanResult result = planner.plan(query.from, query.to, search.started());
    out.records[i] = plan::path_record(scene, query.id, result);
    if (!search.tree_file.empty()) out.tree = std::move(result.tree);
    geom::trim_mapped_files();
  });
  return out;
}

// Returns how many of them are paths.
std::size_t add_all(cli::RecordOutput& out, const std::vector<geom::PathRecord>& records) {
  std::size_t found = 0;
  for (const geom::PathRecord& record : records) {
    found += record.status == "found";
    out.add(geom::to_json_line(record));
  }
  return found;
}

void write_tree(const std::string& path, const plan::SearchTree& tree,
                const geom::PathRecord& record, geom::Axes axes) {
  const bool is_text = !path.ends_with(".ply") && !path.ends_with(".glb");
  cli::OutputFile out(path, is_text ? cli::OutputKind::text : cli::OutputKind::artefact);
  if (path.ends_with(".ply")) {
    plan::write_ply(out.stream(), tree, axes);
  } else if (path.ends_with(".glb")) {
    plan::write_glb(out.stream(), tree, axes);
  } else {
    plan::write_jsonl(out.stream(), tree, record.id, record.provenance);
  }
  out.commit();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Plan collision-free paths through a box map.", "skyway-plan"};
  cli::Common common(app, true);
  cli::VehicleOptions vehicle;
  cli::ArtefactFiles prepared;
  planning::SearchOptions search;
  Asked asked;
  std::string map_file;
  std::string output = "-";
  cli::Sharding sharding;
  app.add_option("map", map_file, "box map; - for stdin")->required();
  prepared.add_to(app);
  cli::add_quality(app, search.plan.quality);
  CLI::Option* queries_option = asked.add_to(app);
  app.add_option("-o,--output", output, "paths (default: stdout)");
  search.add_to(app);
  vehicle.add_to(app);
  sharding.add_to(app)->needs(queries_option)->excludes("--tree");
  return cli::run_tool(app, argc, argv, [&] {
    if (asked.file.empty() && !asked.from) {
      throw cli::UsageError("give --from and --to, or --queries");
    }
    cli::at_most_one_stdin({map_file, prepared.lattice, prepared.roadmap, asked.file});
    sharding.begin(app,
                   {{"map", map_file},
                    {"lattice", prepared.lattice},
                    {"roadmap", prepared.roadmap},
                    {"queries", asked.file}},
                   {{"output", output}});
    if (const auto done = sharding.finished(common)) return *done;
    cli::Scenes scenes(cli::open_map(map_file), vehicle, cli::Scenes::Differences::refused);
    const geom::CollisionScene& scene = scenes.scene();
    const cli::Artefacts artefacts(prepared);
    artefacts.require_made_for(scene);
    const auto named = artefacts.lattice() ? std::nullopt : search.named_lattice(scene);
    const std::vector<geom::PlanQuery> queries = asked.queries();
    search.check(queries.size());
    plan::Planner planner(scene, named ? &*named : artefacts.lattice(), artefacts.roadmap());
    const Planned planned =
        plan_each(planner, scene, queries, sharding.shard(), search, common.execution("paths"));
    cli::RecordOutput out(output, "output", sharding);
    const std::size_t found = add_all(out, planned.records);
    const cli::Exit exit = found == planned.records.size() ? cli::Exit::yes : cli::Exit::no;
    out.commit(queries.size(), exit);
    if (!search.tree_file.empty()) {
      write_tree(search.tree_file, planned.tree, planned.records[0], scene.map().spec().frame.axes);
    }
    common.write_stats({{"queries", planned.records.size()}, {"found", found}});
    if (queries.size() == 1 && !found) {
      fmt::print(stderr, "skyway-plan: {}\n", planned.records[0].message);
    }
    return exit;
  });
}
