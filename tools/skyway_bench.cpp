// skyway-bench: planners compared on the same queries, each path judged by proof.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>

#include "bench/command.h"
#include "bench/measure.h"
#include "bench/method.h"
#include "bench/peak_memory.h"
#include "bench/query_set.h"
#include "bench/report.h"
#include "cli/files.h"
#include "cli/run.h"
#include "cli/vehicle_option.h"
#include "geom/error.h"
#include "plan/io/lattice_file.h"
#include "plan/io/roadmap_file.h"

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFooter = R"(
The protocol of the older system: 50 A* searches of 600-700 m, 25 m, 6-connected; and sampling
planners on 45-50 m, until the mean time is known to 1 %:
  skyway-bench MAP --vehicle V --method astar --spacing 25 --connectivity 6 --length 600 700 --trials 50
  skyway-bench MAP --vehicle V --method rrt-connect-ompl --length 45 50 --within 1
)";

const std::map<std::string, plan::Quality> kQuality = {{"fast", plan::Quality::fast},
                                                       {"normal", plan::Quality::normal},
                                                       {"best", plan::Quality::best}};
const std::map<std::string, bench::Ends> kSets = {{"uniform", bench::Ends::uniform},
                                                  {"street", bench::Ends::street},
                                                  {"street-blocked", bench::Ends::street_blocked}};

struct Files {
  std::string map;
  std::string lattice;
  std::string roadmap;
  std::string queries;
  std::string reference;
  std::string output = "-";
};

struct Options {
  bench::RandomSpec random;
  bench::TrialRule rule;
  bench::MethodOptions method;
  std::string set = "uniform";
  std::vector<double> length;
  std::vector<std::string> methods;
  std::vector<std::string> commands;
  double within = 1;  // percent
  int connect = 6;
};

void add_queries(CLI::App& app, Files& files, Options& options) {
  auto* queries = app.add_option("--queries", files.queries, "JSON Lines or CSV; - for stdin");
  app.add_option("--reference", files.reference,
                 "CSV of the best lengths known, with columns id and length")
      ->needs(queries);
  app.add_option("--set", options.set,
                 "random queries: uniform in free space (default); street: within 30 m of the "
                 "floor; street-blocked: and the straight line blocked")
      ->check(CLI::IsMember({"uniform", "street", "street-blocked"}))
      ->excludes(queries);
  app.add_option("--length", options.length, "between the ends of random queries, metres")
      ->expected(2)
      ->type_name("MIN MAX")
      ->check(CLI::Range(0.0, 1e6))
      ->excludes(queries);
  app.add_option("--seed", options.random.seed, "of random queries and planners (default 0)");
  app.add_flag("--until-converged,!--all-trials", options.rule.converge,
               "random queries until the mean time is known (default), or as many as --trials")
      ->excludes(queries);
  app.add_option("--within", options.within,
                 "the mean is known when its standard error is within this, percent (default 1)")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option("--min-trials", options.rule.least, "at least (default 100)")
      ->check(CLI::Range(1, 1000000000));
  app.add_option("--trials", options.rule.most, "at most (default 10000)")
      ->check(CLI::Range(1, 1000000000))
      ->excludes(queries);
  app.add_option("--repeat", options.rule.repeat, "the median time of this many (default 1)")
      ->check(CLI::Range(1, 1000));
}

void add_methods(CLI::App& app, Files& files, Options& options) {
  std::vector<std::string> names;
  for (const auto& known : bench::known_methods()) names.emplace_back(known.name);
  app.add_option("--method", options.methods,
                 fmt::format("what to compare, by commas; the first is what the others are held "
                             "against: {} (default auto)",
                             fmt::join(names, ", ")))
      ->delimiter(',')
      ->check(CLI::IsMember(names));
  app.add_option("--planner-cmd", options.commands,
                 "a planner of anybody's: a shell command that reads queries as JSON Lines and "
                 "writes path records; may be repeated")
      ->take_all()
      ->expected(1);
  app.add_option("--lattice", files.lattice, "auto: lattice of the same map and vehicle");
  app.add_option("--roadmap", files.roadmap, "auto: roadmap of the same map and vehicle");
  app.add_option("--quality", options.method.quality, "auto: fast, normal (default) or best")
      ->transform(CLI::CheckedTransformer(kQuality));
  app.add_option("--spacing", options.method.spec.spacing,
                 "astar: of the lattice, metres (default 25)")
      ->check(CLI::Range(1e-3, 1e6));
  app.add_option("--connectivity", options.connect, "astar: 6, 18 or 26 neighbours (default 6)")
      ->check(CLI::IsMember({6, 18, 26}));
  app.add_option("--ompl-seconds", options.method.ompl_seconds,
                 "planners of OMPL: time for a query, of CPU for Informed RRT* (default 1)")
      ->check(CLI::Range(1e-3, 1e5));
}

std::vector<geom::PlanQuery> read_queries(const Files& files) {
  cli::InputFile file(files.queries);
  auto queries = geom::read_plan_queries(file.stream(), file.name());
  if (files.reference.empty()) return queries;
  cli::InputFile reference(files.reference);
  const auto lengths = geom::read_reference_lengths(reference.stream(), reference.name());
  std::size_t known = 0;
  for (geom::PlanQuery& query : queries) {
    const auto at = lengths.find(query.id);
    if (at == lengths.end()) continue;
    query.best_known = at->second;
    ++known;
  }
  if (!known) throw geom::InputError(reference.name(), "none of its ids is one of the queries'");
  return queries;
}

bench::QuerySet query_set(const Files& files, Options& options, const geom::CollisionScene& scene) {
  if (!files.queries.empty()) return bench::QuerySet(read_queries(files));
  options.random.ends = kSets.at(options.set);
  if (!options.length.empty()) {
    if (!(options.length[0] <= options.length[1]) || options.length[1] == 0) {
      throw cli::UsageError("--length: expected MIN <= MAX and MAX > 0");
    }
    options.random.length = {options.length[0], options.length[1]};
  }
  return {scene, options.random};
}

Json describe(const bench::QuerySet& queries, const Files& files, const Options& options) {
  if (queries.size()) return {{"queries", files.queries}, {"count", *queries.size()}};
  Json out = {{"name", options.set}};
  if (options.random.length) out["length"] = options.length;
  out["seed"] = options.random.seed;
  out["rejected"] = {{"outside", queries.rejected().outside},
                     {"blocked", queries.rejected().blocked},
                     {"line_free", queries.rejected().line_free}};
  return out;
}

// A record may say for what it was made; then it must be this.
void require_ours(const geom::PathRecord& record, const geom::CollisionScene& scene,
                  std::size_t line) {
  geom::Provenance said = cli::provenance_of(scene);
  if (record.provenance.map) said.map = record.provenance.map;
  if (record.provenance.frame) said.frame = record.provenance.frame;
  if (record.provenance.vehicle) said.vehicle = record.provenance.vehicle;
  if (record.provenance.margin) said.margin = record.provenance.margin;
  cli::require_same(said, scene, fmt::format("planner-cmd:{}", line), "path");
}

bench::Run run_method(const std::string& name, const geom::CollisionScene& scene,
                      bench::QuerySet& queries, const Options& options, const cli::Common& common) {
  const auto known = bench::known_methods();
  const auto method =
      std::find_if(known.begin(), known.end(), [&](const auto& k) { return k.name == name; });
  bench::reset_peak_memory();
  return bench::measure(name, method->make(scene, options.method), scene, queries, options.rule,
                        common.execution(name));
}

// The queries that the longest run before it had, or the fewest trials.
std::vector<geom::PlanQuery> for_command(bench::QuerySet& queries, const Options& options,
                                         const std::vector<bench::Run>& before) {
  std::size_t count = queries.size().value_or(std::min(options.rule.least, options.rule.most));
  for (const bench::Run& run : before) count = std::max(count, run.trials.size());
  std::vector<geom::PlanQuery> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(queries.at(i));
  return out;
}

bench::Run run_command(const std::string& command, const geom::CollisionScene& scene,
                       const std::vector<geom::PlanQuery>& queries, const cli::Common& common) {
  const bench::CommandOutput output = bench::run_command(
      command, bench::to_json_lines(queries), queries.size(), common.execution("planner-cmd"));
  if (output.status > 1) {
    common.warn(
        fmt::format("the planner command ended with status {}: {}", output.status, command));
  }
  return bench::judge_command(
      command, output, scene, queries,
      [&](const geom::PathRecord& record, std::size_t line) { require_ours(record, scene, line); });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Compare planners on the same queries; each path is judged by proof.",
               "skyway-bench"};
  cli::Common common(app, true);
  cli::VehicleOptions vehicle;
  Files files;
  Options options;
  app.add_option("map", files.map, "box map; - for stdin")->required();
  add_queries(app, files, options);
  add_methods(app, files, options);
  app.add_option("-o,--output", files.output, "report, JSON (default: stdout)");
  vehicle.add_to(app);
  app.footer(kFooter);
  return cli::run_tool(app, argc, argv, [&] {
    cli::at_most_one_stdin(
        {files.map, files.lattice, files.roadmap, files.queries, files.reference});
    cli::Scenes scenes(cli::open_map(files.map), vehicle, cli::Scenes::Differences::refused);
    const geom::CollisionScene& scene = scenes.scene();
    std::optional<plan::Lattice> lattice;
    if (!files.lattice.empty()) {
      lattice = plan::read_lattice(cli::open_archive(files.lattice));
      cli::require_same(lattice->made_for(), scene, files.lattice, "lattice");
      options.method.lattice = &*lattice;
    }
    std::optional<plan::Roadmap> roadmap;
    if (!files.roadmap.empty()) {
      roadmap = plan::read_roadmap(cli::open_archive(files.roadmap));
      cli::require_same(roadmap->made_for, scene, files.roadmap, "roadmap");
      options.method.roadmap = &*roadmap;
    }
    options.rule.within = options.within / 100;
    options.method.seed = options.random.seed;
    options.method.spec.connectivity = static_cast<plan::Connectivity>(options.connect);
    options.method.spec.origin = scene.map().spec().bounds.min;
    options.method.build = common.execution("layers");
    if (options.methods.empty() && options.commands.empty()) options.methods = {"auto"};

    bench::QuerySet queries = query_set(files, options, scene);
    std::vector<bench::Run> runs;
    for (const std::string& name : options.methods) {
      runs.push_back(run_method(name, scene, queries, options, common));
    }
    if (!options.commands.empty()) {
      const auto asked = for_command(queries, options, runs);
      for (const std::string& command : options.commands) {
        runs.push_back(run_command(command, scene, asked, common));
      }
    }

    const geom::Provenance made_for = cli::provenance_of(scene);
    Json report = {
        {"type", "benchmark"},
        {"map", *made_for.map},
        {"frame", geom::name(*made_for.frame)},
        {"vehicle",
         {{"name", scene.vehicle().name},
          {"half", {scene.vehicle().half[0], scene.vehicle().half[1], scene.vehicle().half[2]}}}},
        {"margin", scene.margin()},
        {"set", describe(queries, files, options)}};
    Json stats = {{"set", report["set"]}};
    bool sound = true;
    for (const bench::Run& run : runs) {
      report["methods"].push_back(bench::report(run, runs.front()));
      stats["methods"].push_back(bench::counts(run));
      sound = sound && !bench::count(run, bench::Verdict::invalid) && !run.missing && !run.extra;
    }
    cli::OutputFile out(files.output, cli::OutputKind::text);
    out.stream() << report.dump(2) << '\n';
    out.commit();
    common.note(bench::table(runs));
    common.write_stats(stats);
    return sound ? cli::Exit::yes : cli::Exit::no;
  });
}
