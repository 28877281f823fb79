#include "options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/file/files.h"
#include "cli/option/output_option.h"
#include "cli/option/quality_option.h"
#include "cli/option/word_for.h"
#include "cli/run.h"
#include "geom/base/thread_seconds.h"
#include "methods.h"

namespace bench {
namespace {

void add_queries(CLI::App& app, Files& files, Options& options) {
  auto* queries = app.add_option("--queries", files.queries, "JSON Lines or CSV; - for stdin");
  files.metres.add_to(app);
  app.get_option("--metres")->needs(queries);
  cli::add_word(app, "--set", options.random.ends, plan::bench::kEndsWords,
                "random queries: uniform in free space (default); street: within 30 m of the "
                "floor; street-blocked: as street, and the straight line is blocked")
      ->excludes(queries);
  app.add_option("--length", options.length, "distance between the ends of random queries, metres")
      ->expected(2)
      ->type_name("MIN MAX")
      ->check(CLI::Range(0.0, 1e6))
      ->excludes(queries);
  app.add_option("--seed", options.random.seed, "seed of random queries and planners (default 0)");
  app.add_flag("--until-converged,!--all-trials", options.rule.converge,
               "draw random queries until the mean time is known (default), or as many as --trials")
      ->excludes(queries);
  app.add_option(
         "--precision", options.within,
         "the mean time is known when its standard error is within this, percent (default 1)")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option("--min-trials", options.rule.least,
                 "at least this many random queries (default 100)")
      ->check(CLI::Range(1, 1000000000));
  app.add_option("--trials", options.rule.most, "at most this many random queries (default 10000)")
      ->check(CLI::Range(1, 1000000000))
      ->excludes(queries);
  app.add_option("--repeat", options.rule.repeat,
                 "take the median time of this many runs of a query (default 1)")
      ->check(CLI::Range(1, 1000));
}

void add_methods(CLI::App& app, Files& files, Options& options) {
  std::vector<std::string_view> names;
  for (const plan::bench::KnownMethod& known : methods()) names.push_back(known.name);
  app.add_option("--method", options.methods,
                 fmt::format("what to compare, by commas; the others are compared with the first: "
                             "{} (default auto)",
                             fmt::join(names, ", ")))
      ->delimiter(',')
      ->check(CLI::IsMember(names));
  app.add_option("--planner-cmd", options.commands,
                 "any planner: a shell command that reads queries as JSON Lines and writes path "
                 "records; may be repeated")
      ->take_all()
      ->expected(1);
  files.artefacts.add_to(app);
  cli::add_quality(app, options.method.quality);
  app.add_option("--spacing", options.method.spacing,
                 "astar: spacing of the lattice, metres (default 25, less on maps under 300 m)")
      ->check(CLI::Range(1e-3, 1e6));
  app.add_option("--connect", options.connect, "astar: 6, 18 or 26 neighbours (default 6)")
      ->check(CLI::IsMember({6, 18, 26}));
  app.add_option(
         "--ompl-seconds", options.method.seconds,
         "planners of OMPL: seconds for a query; for Informed RRT*, of CPU time (default 1)")
      ->check(CLI::Range(1e-3, 1e5));
}

}  // namespace

void add_options(CLI::App& app, Files& files, Options& options) {
  app.add_option("map", files.map, "box map; - for stdin")->required();
  add_queries(app, files, options);
  add_methods(app, files, options);
  app.add_option("--bound", options.bound,
                 "prove how short the paths of each query can be at all, to within this share of "
                 "the shortest that was found, and compare all with that")
      ->check(CLI::Range(1e-6, 1.0));
  cli::add_output(app, "-o,--output", files.output, "report, JSON (default: stdout)");
}

void complete(Options& options, const geom::BoxMap& map) {
  if (!options.length.empty()) {
    if (!(options.length[0] <= options.length[1]) || options.length[1] == 0) {
      throw cli::UsageError(
          fmt::format("--length: expected MIN <= MAX and MAX > 0 metres, found {} and {}",
                      options.length[0], options.length[1]));
    }
    options.random.length = {options.length[0], options.length[1]};
  }
  options.rule.within = options.within / 100;
  options.rule.clock = geom::thread_seconds;
  options.method.seed = options.random.seed;
  options.method.spec.connectivity = static_cast<plan::Connectivity>(options.connect);
  options.method.spec.origin = map.spec().bounds.min;
  if (options.methods.empty() && options.commands.empty()) options.methods = {"auto"};
}

std::vector<geom::PlanQuery> read_queries(const Files& files, const geom::CollisionScene& scene) {
  cli::InputFile file(files.queries);
  const geom::Locator locator(scene.map());
  auto queries = geom::read_plan_queries(file.stream(), file.name(), &locator);
  files.metres.check_queries(scene, queries, file.name());
  return queries;
}

}  // namespace bench
