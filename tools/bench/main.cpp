// skyway-bench: planners compared on the same queries, each path judged by proof.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "cli/content/artefacts.h"
#include "cli/file/files.h"
#include "cli/option/scenes.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "command.h"
#include "methods.h"
#include "options.h"
#include "peak_memory.h"
#include "plan/bench/trial_bounds.h"
#include "plan/bench/trial_report.h"

namespace {

using Json = nlohmann::ordered_json;

Json describe(const geom::CollisionScene& scene) {
  const geom::Vec3& half = scene.vehicle().half;
  return {{"type", "benchmark"},
          {"map", scene.map().hash()},
          {"frame", geom::name(scene.map().spec().frame.axes)},
          {"vehicle", {{"name", scene.vehicle().name}, {"half", {half[0], half[1], half[2]}}}},
          {"margin", scene.margin()}};
}

Json describe(const plan::bench::QuerySet& queries, const bench::Files& files,
              const bench::Options& options) {
  if (queries.size()) return {{"queries", files.queries}, {"count", *queries.size()}};
  Json out = {{"name", geom::word_of(plan::bench::kEndsWords, options.random.ends)}};
  if (options.random.length) out["length"] = options.length;
  out["seed"] = options.random.seed;
  out["rejected"] = {{"outside", queries.rejected().outside},
                     {"blocked", queries.rejected().blocked},
                     {"line_free", queries.rejected().line_free}};
  return out;
}

plan::bench::Run run_method(const std::string& name, const geom::CollisionScene& scene,
                            plan::bench::QuerySet& queries, const bench::Options& options,
                            const cli::Common& common) {
  const std::vector<plan::bench::KnownMethod> all = bench::methods();
  const auto known =
      std::find_if(all.begin(), all.end(), [&](const auto& k) { return k.name == name; });
  bench::reset_peak_memory();
  const auto begin = std::chrono::steady_clock::now();
  const plan::bench::Method method = known->make(scene, options.method);
  const std::chrono::duration<double> built = std::chrono::steady_clock::now() - begin;
  plan::bench::Run run =
      plan::bench::measure(name, method, scene, queries, options.rule, common.execution(name));
  if (known->builds) run.build_seconds = built.count();
  run.peak_rss = bench::peak_memory();
  return run;
}

// The queries that the longest run before it had, or the fewest trials.
std::vector<geom::PlanQuery> for_command(plan::bench::QuerySet& queries,
                                         const bench::Options& options,
                                         const std::vector<plan::bench::Run>& before) {
  std::size_t count = queries.size().value_or(std::min(options.rule.least, options.rule.most));
  for (const plan::bench::Run& run : before) count = std::max(count, run.trials.size());
  std::vector<geom::PlanQuery> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(queries.at(i));
  return out;
}

plan::bench::Run run_command(const std::string& command, const geom::CollisionScene& scene,
                             const std::vector<geom::PlanQuery>& queries,
                             const cli::Common& common) {
  const bench::CommandOutput output = bench::run_command(
      command, plan::bench::query_lines(queries), queries.size(), common.execution("planner-cmd"));
  constexpr int kNotExecutable = 126;  // what a shell ends with where it cannot start a program
  constexpr int kNotFound = 127;
  if (output.answers.lines.empty() &&
      (output.status == kNotExecutable || output.status == kNotFound)) {
    throw std::runtime_error(fmt::format("cannot start the planner command: {}", command));
  }
  if (output.status > 1) {
    common.warn(
        fmt::format("the planner command ended with status {}: {}", output.status, command));
  }
  return plan::bench::judge_lines(command, output.answers, scene, queries);
}

std::vector<plan::bench::Run> run_all(const geom::CollisionScene& scene,
                                      plan::bench::QuerySet& queries, const bench::Options& options,
                                      const cli::Common& common) {
  std::vector<plan::bench::Run> runs;
  for (const std::string& name : options.methods) {
    runs.push_back(run_method(name, scene, queries, options, common));
  }
  if (options.commands.empty()) return runs;
  const auto asked = for_command(queries, options, runs);
  for (const std::string& command : options.commands) {
    runs.push_back(run_command(command, scene, asked, common));
  }
  return runs;
}

bool sound(const plan::bench::Run& run) {
  return plan::bench::count(run, plan::bench::Verdict::invalid) == 0 && !run.missing && !run.extra;
}

struct Compared {
  Json report;
  Json counts;
  bool sound = true;
};

Compared compare_all(const geom::CollisionScene& scene, const bench::Files& files,
                     bench::Options& options, const cli::Common& common) {
  bench::complete(options, scene.map());
  options.method.build = common.execution("layers");
  plan::bench::QuerySet queries = files.queries.empty()
                                      ? plan::bench::QuerySet(scene, options.random)
                                      : plan::bench::QuerySet(bench::read_queries(files, scene));
  std::vector<plan::bench::Run> runs = run_all(scene, queries, options, common);
  if (options.bound) {
    plan::bench::add_bounds(runs, scene, queries, *options.bound, common.execution("bounds"));
  }
  const Json set = describe(queries, files, options);
  Compared done{{{"set", set}}, {{"set", set}}};
  for (const plan::bench::Run& run : runs) {
    done.report["methods"].push_back(plan::bench::report(run, runs.front()));
    done.counts["methods"].push_back(plan::bench::counts(run));
    done.sound = done.sound && sound(run);
  }
  common.note(plan::bench::table(runs));
  return done;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Compare planners on the same queries; each path is judged by proof.",
               "skyway-bench"};
  cli::Common common(app, true);
  cli::VehicleOptions vehicle;
  bench::Files files;
  bench::Options options;
  bench::add_options(app, files, options);
  vehicle.add_to(app);
  vehicle.add_memory_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    cli::at_most_one_stdin(
        {files.map, files.artefacts.lattice, files.artefacts.roadmap, files.queries});
    cli::Scenes scenes(
        cli::open_map(files.map, geom::Verified::extents, common.execution("verify")), vehicle,
        cli::Scenes::Differences::refused);
    const geom::CollisionScene& scene = scenes.scene();
    const cli::Artefacts artefacts(files.artefacts);
    artefacts.require_made_for(scene);
    options.method.lattice = artefacts.lattice();
    options.method.roadmap = artefacts.roadmap();
    Json report = describe(scene);
    const Compared done = compare_all(scene, files, options, common);
    report.update(done.report);
    cli::OutputFile out(files.output, cli::OutputKind::text);
    out.stream() << report.dump(2) << '\n';
    out.commit();
    common.write_stats(done.counts);
    return done.sound ? cli::Exit::yes : cli::Exit::no;
  });
}
