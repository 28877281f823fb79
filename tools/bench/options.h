#pragma once

// The options of skyway-bench: what is asked, of whom, and until when.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/content/artefacts.h"
#include "cli/option/degrees.h"
#include "plan/bench/measure.h"
#include "plan/bench/method.h"
#include "plan/bench/query_set.h"

namespace bench {

struct Files {
  std::string map;
  cli::ArtefactFiles artefacts;  // for auto
  std::string queries;
  std::string output = "-";
  cli::MetresOption metres{true};
};

struct Options {
  plan::bench::RandomSpec random;
  plan::bench::TrialRule rule;
  plan::bench::MethodOptions method;
  std::vector<double> length;         // metres, least and most; or empty
  std::vector<std::string> methods;   // names in bench::methods()
  std::vector<std::string> commands;  // for the shell
  double within = 1;                  // percent
  int connect = 6;                    // neighbours of a node
  std::optional<double> bound;        // the gap wanted between the shortest path and a proved bound
};

void add_options(CLI::App& app, Files& files, Options& options);

// Once parsed: what follows from several of them, and from the map. Throws cli::UsageError.
void complete(Options& options, const geom::BoxMap& map);

// The queries of a file, with the lengths of --reference. Throws InputError for ends that look like
// degrees.
std::vector<geom::PlanQuery> read_queries(const Files& files, const geom::CollisionScene& scene);

}  // namespace bench
