// skyway-plan: collision-free paths through a box map, one per query.

#include <fmt/format.h>

#include <chrono>
#include <map>
#include <optional>

#include "cli/artefacts.h"
#include "cli/files.h"
#include "cli/numbers_option.h"
#include "cli/quality_option.h"
#include "cli/record_output.h"
#include "cli/run.h"
#include "cli/vehicle_option.h"
#include "geom/error.h"
#include "geom/io/query_record.h"
#include "geom/mapped_file.h"
#include "geom/parallel.h"
#include "plan/build_lattice.h"
#include "plan/io/path_record.h"
#include "plan/io/search_tree.h"
#include "plan/plan.h"

namespace {

// What `--method` may be refined with.
struct Search {
  plan::PlanOptions options;
  plan::LatticeSpec lattice{10, plan::Connectivity::twenty_six, {}};
  int connect = 26;
  double seconds = 0;
  std::string tree_file;
};

const std::map<std::string, plan::Method> kMethod = [] {
  std::map<std::string, plan::Method> out;
  using plan::Method;
  for (const Method method : {Method::automatic, Method::astar, Method::rrt, Method::rrt_connect,
                              Method::rrt_star, Method::informed_rrt_star}) {
    out.emplace(plan::name(method), method);
  }
  return out;
}();

void add_search_options(CLI::App& app, Search& search) {
  plan::PlanOptions& options = search.options;
  plan::SamplingOptions& sampling = options.sampling;
  app.add_option("--method", options.method,
                 "auto (default), astar, rrt, rrt-connect, rrt-star or informed-rrt-star")
      ->transform(CLI::CheckedTransformer(kMethod));
  app.add_option("--spacing", search.lattice.spacing,
                 "astar without --lattice: distance of neighbouring nodes, metres (default 10)")
      ->check(CLI::Range(1e-3, 1e6));
  app.add_option("--connect", search.connect,
                 "astar without --lattice: neighbours of a node: 6, 18 or 26 (default 26)")
      ->check(CLI::IsMember({6, 18, 26}));
  app.add_option("--step", sampling.step, "rrt…: longest edge, metres (default 15)")
      ->check(CLI::Range(1e-3, 1e6));
  app.add_option("--goal-bias", sampling.goal_bias,
                 "rrt…: how often the goal is the sample (default 0.05)")
      ->check(CLI::Range(0.0, 1.0));
  app.add_option("--iterations", sampling.iterations, "rrt…: at most (default 20000)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000000000}));
  app.add_option("--radius", sampling.radius,
                 "rrt-star…: largest neighbourhood, metres (default 30)")
      ->check(CLI::Range(0.0, 1e6));
  app.add_option("--patience", sampling.patience,
                 "rrt-star…: end after this many iterations that shorten the path by less than "
                 "0.1 % (default: use all)");
  app.add_option("--seconds", search.seconds,
                 "rrt…: end a search after this time; results then depend on the machine")
      ->check(CLI::Range(0.0, 1e6));
  app.add_option("--seed", sampling.seed, "rrt…: of the random numbers (default 0)");
  app.add_option("--tree", search.tree_file,
                 "rrt…: write the tree of the one query: .ply, .glb, else JSON Lines");
}

// Each search has its own clock.
plan::PlanOptions with_deadline(const Search& search) {
  plan::PlanOptions options = search.options;
  if (search.seconds <= 0) return options;
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(search.seconds));
  options.sampling.stop = [end] { return Clock::now() >= end; };
  return options;
}

void write_tree(const std::string& path, const plan::PlanResult& result,
                const geom::PathRecord& record, geom::Axes axes) {
  const bool is_text = !path.ends_with(".ply") && !path.ends_with(".glb");
  cli::OutputFile out(path, is_text ? cli::OutputKind::text : cli::OutputKind::artefact);
  if (path.ends_with(".ply")) {
    plan::write_ply(out.stream(), result.tree, axes);
  } else if (path.ends_with(".glb")) {
    plan::write_glb(out.stream(), result.tree, axes);
  } else {
    plan::write_jsonl(out.stream(), result.tree, record.id, record.provenance);
  }
  out.commit();
}

// The lattice that astar is asked to search where no file gives one.
std::optional<plan::Lattice> named_lattice(const Search& search,
                                           const geom::CollisionScene& scene) {
  if (search.options.method != plan::Method::astar || !scene.free_bounds()) return std::nullopt;
  plan::LatticeSpec spec = search.lattice;
  spec.connectivity = static_cast<plan::Connectivity>(search.connect);
  spec.origin = scene.free_bounds()->min;
  return plan::lazy_lattice(scene, spec);
}

std::vector<geom::PlanQuery> read_queries(const std::string& path) {
  cli::InputFile file(path);
  return geom::read_plan_queries(file.stream(), file.name());
}

void check(const Search& search, std::size_t queries) {
  const plan::Method method = search.options.method;
  const bool samples = method != plan::Method::automatic && method != plan::Method::astar;
  if (!search.tree_file.empty() && !samples) {
    throw cli::UsageError("--tree needs one of the rrt methods: the others grow no tree");
  }
  if (!search.tree_file.empty() && queries != 1) {
    throw cli::UsageError(fmt::format("--tree needs one query, found {}", queries));
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Plan collision-free paths through a box map.", "skyway-plan"};
  cli::Common common(app, true);
  cli::VehicleOptions vehicle;
  Search search;
  plan::PlanOptions& options = search.options;
  std::string map_file;
  cli::ArtefactFiles artefact_files;
  std::string queries_file;
  std::string output = "-";
  std::optional<geom::Vec3> from;
  std::optional<geom::Vec3> to;
  cli::Sharding sharding;
  app.add_option("map", map_file, "box map; - for stdin")->required();
  artefact_files.add_to(app);
  cli::add_quality(app, options.quality);
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
  add_search_options(app, search);
  vehicle.add_to(app);
  sharding.add_to(app)->needs(queries)->excludes("--tree");
  return cli::run_tool(app, argc, argv, [&] {
    if (queries_file.empty() && !from) throw cli::UsageError("give --from and --to, or --queries");
    cli::at_most_one_stdin(
        {map_file, artefact_files.lattice, artefact_files.roadmap, queries_file});
    sharding.begin(app,
                   {{"map", map_file},
                    {"lattice", artefact_files.lattice},
                    {"roadmap", artefact_files.roadmap},
                    {"queries", queries_file}},
                   {{"output", output}});
    if (const auto done = sharding.finished(common)) return *done;
    cli::Scenes scenes(cli::open_map(map_file), vehicle, cli::Scenes::Differences::refused);
    const geom::CollisionScene& scene = scenes.scene();
    const cli::Artefacts artefacts(artefact_files);
    artefacts.require_made_for(scene);
    const auto named = artefacts.lattice() ? std::nullopt : named_lattice(search, scene);
    const std::vector<geom::PlanQuery> list =
        from ? std::vector<geom::PlanQuery>{{"q1", *from, *to}} : read_queries(queries_file);
    check(search, list.size());
    options.keep_tree = !search.tree_file.empty();
    const geom::Execution run = common.execution("paths");
    plan::Planner planner(scene, named ? &*named : artefacts.lattice(), artefacts.roadmap());
    const std::vector<std::size_t> chosen = sharding.shard().items(list.size());
    std::vector<geom::PathRecord> records(chosen.size());
    plan::PlanResult last;
    geom::parallel_for(chosen.size(), run, [&](std::size_t i) {
      const geom::PlanQuery& query = list[chosen[i]];
      plan::PlanResult result = planner.plan(query.from, query.to, with_deadline(search));
      records[i] = plan::path_record(scene, query.id, result);
      if (options.keep_tree) last = std::move(result);
      geom::trim_mapped_files();
    });
    cli::RecordOutput out(output, "output", sharding);
    std::size_t found = 0;
    for (const geom::PathRecord& record : records) {
      found += record.status == "found";
      out.add(geom::to_json_line(record));
    }
    const cli::Exit exit = found == records.size() ? cli::Exit::yes : cli::Exit::no;
    out.commit(list.size(), exit);
    if (options.keep_tree) {
      write_tree(search.tree_file, last, records[0], scene.map().spec().frame.axes);
    }
    common.write_stats({{"queries", records.size()}, {"found", found}});
    if (list.size() == 1 && !found) fmt::print(stderr, "skyway-plan: {}\n", records[0].message);
    return exit;
  });
}
