#include "search_options.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <map>

#include "cli/option/numbers_option.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/option/word_for.h"
#include "cli/run.h"
#include "plan/lattice/fitting_length.h"

namespace planning {
namespace {

constexpr double kSpacing = 10;  // metres, in a city
constexpr int kMostLayers = 360;

const std::map<std::string, plan::Method> kMethod = [] {
  std::map<std::string, plan::Method> out;
  for (const auto& [method, word] : plan::kMethodWords) out.emplace(word, method);
  return out;
}();

void add_path_options(CLI::App& app, plan::PlanOptions& options) {
  app.add_flag("--raw", options.raw, "the search's own path, not shortened");
  app.add_option("--resample", options.resample, "cut the path into parts of at most this, metres")
      ->check(CLI::Range(1e-3, 1e6));
  app.add_option(
         "--snap-ends", options.snap_ends,
         "move a blocked or outside end to the nearest free place within this, metres; stderr "
         "says where to")
      ->check(CLI::Range(0.0, 1e4));
}

void add_layers(CLI::App& app, std::optional<plan::Layers>& layers) {
  app.add_option_function<std::string>(
         "--layers",
         [&layers](const std::string& text) {
           const auto v = cli::parse_numbers(text, 3);
           const bool good = v && (*v)[1] > 0 && (*v)[2] >= 1 && (*v)[2] <= kMostLayers &&
                             (*v)[2] == std::floor((*v)[2]);
           if (!good) {
             throw cli::UsageError(
                 fmt::format("--layers: expected LOW,STEP,COUNT: metres, metres above 0, and "
                             "1 to {} layers, found \"{}\"",
                             kMostLayers, text));
           }
           layers = plan::Layers{(*v)[0], (*v)[1], static_cast<int>((*v)[2])};
         },
         "cruise in one of COUNT layers, each STEP metres high, from LOW on upwards, by the "
         "direction: the first is for flights from north to before 360/COUNT degrees clockwise")
      ->type_name("LOW,STEP,COUNT")
      ->excludes("--bound")
      ->excludes("--resample")
      ->excludes("--raw")
      ->excludes("--certificate");
}

void add_sampling_options(CLI::App& app, plan::SamplingOptions& sampling) {
  app.add_option("--step", sampling.step,
                 "sampling methods: longest edge, metres (default 15, less on maps under 300 m)")
      ->check(CLI::Range(1e-3, 1e6));
  app.add_option("--goal-bias", sampling.goal_bias,
                 "sampling methods: how often the goal is the sample (default 0.05)")
      ->check(CLI::Range(0.0, 1.0));
  app.add_option(
         "--iterations", sampling.iterations,
         "sampling methods: at most this many (default 20000; 100000 of rrt and rrt-connect on "
         "maps under 300 m)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000000000}));
  app.add_option("--radius", sampling.radius,
                 "rrt-star, informed-rrt-star: largest neighbourhood, metres (default 30, less on "
                 "maps under 300 m)")
      ->check(CLI::Range(0.0, 1e6));
  app.add_option("--patience", sampling.patience,
                 "rrt-star, informed-rrt-star: end after this many iterations that together "
                 "shorten the path by less than 0.1 % (default: use all)");
}

}  // namespace

void SearchOptions::add_to(CLI::App& app) {
  add_path_options(app, plan);
  app.add_option("--method", plan.method,
                 "auto (default), astar, rrt, rrt-connect, rrt-star or informed-rrt-star")
      ->transform(cli::word_for(kMethod))
      ->type_name("TEXT");
  app.add_option("--spacing", spacing,
                 "astar without --lattice: distance of neighbouring nodes, metres (default 10, "
                 "less on maps under 300 m)")
      ->check(CLI::Range(1e-3, 1e6));
  app.add_option("--connect", connect,
                 "astar without --lattice: neighbours of a node: 6, 18 or 26 (default 26)")
      ->check(CLI::IsMember({6, 18, 26}));
  add_sampling_options(app, plan.sampling);
  app.add_option(
         "--seconds", seconds,
         "sampling methods: end a search after this time; results then depend on the machine")
      ->check(CLI::Range(0.0, 1e6));
  app.add_option("--seed", plan.sampling.seed,
                 "sampling methods: seed of the random numbers (default 0)");
  app.add_option("--bound", plan.gap,
                 "prove how short a path can be at all, to within this share of the length found "
                 "(keys bound and gap)")
      ->check(CLI::Range(1e-6, 1.0));
  cli::add_output(app, "--certificate", certificate,
                  "write for each unreachable goal (auto) and each bound what shows it "
                  "(docs/certificates.md)");
  add_layers(app, layers);
  cli::add_output(app, "--tree", tree_file,
                  "sampling methods: write the search tree, of one query only");
}

void SearchOptions::refuse_idle(const CLI::App& app, const cli::ArtefactFiles& files) const {
  using plan::Method;
  const bool star = plan.method == Method::rrt_star || plan.method == Method::informed_rrt_star;
  const bool astar = plan.method == Method::astar;
  const bool sampling = !astar && plan.method != Method::automatic;
  cli::only_for(app, sampling, {"--step", "--goal-bias", "--iterations", "--seconds", "--seed"},
                "the rrt methods");
  cli::only_for(app, star, {"--radius", "--patience"}, "rrt-star and informed-rrt-star");
  cli::only_for(app, astar && files.lattice.empty(), {"--spacing", "--connect"},
                "--method astar without --lattice");
  cli::only_for(app, plan.method == Method::automatic || plan.gap > 0, {"--certificate"},
                "the method auto, and for --bound");
  cli::only_for(app, !sampling, {"--lattice", "--roadmap"}, "the methods auto and astar");
  cli::only_for(app, plan.method == Method::automatic, {"--layers"}, "the method auto");
}

void SearchOptions::check(std::size_t queries) const {
  if (tree_file.empty()) return;
  if (plan.method == plan::Method::automatic || plan.method == plan::Method::astar) {
    throw cli::UsageError("--tree needs one of the rrt methods: the others grow no tree");
  }
  if (queries != 1) {
    throw cli::UsageError(fmt::format("--tree needs one query, found {}", queries));
  }
}

plan::PlanOptions SearchOptions::started() const {
  plan::PlanOptions options = plan;
  options.keep_tree = !tree_file.empty();
  options.keep_cells = options.keep_proof = !certificate.empty();
  if (seconds <= 0) return options;
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(seconds));
  options.sampling.stop = [end] { return Clock::now() >= end; };
  return options;
}

std::optional<plan::Lattice> SearchOptions::named_lattice(const geom::CollisionScene& scene) const {
  if (plan.method != plan::Method::astar || !scene.free_bounds()) return std::nullopt;
  const geom::Aabb& inner = *scene.free_bounds();
  const double between = spacing ? *spacing : plan::fitting_length(inner, kSpacing);
  return plan::lazy_lattice(scene, {between, static_cast<plan::Connectivity>(connect), inner.min});
}

}  // namespace planning
