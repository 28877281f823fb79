#pragma once

// The options of skyway-plan that say how to search, and what follows from them.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/content/artefacts.h"
#include "plan/lattice/build_lattice.h"
#include "plan/planner/layers.h"
#include "plan/planner/plan.h"

namespace planning {

struct SearchOptions {
  plan::PlanOptions plan;
  std::optional<plan::Layers> layers;  // to cruise in
  std::optional<double> spacing;       // metres, of astar's lattice where no file gives one
  int connect = 26;                    // its neighbours of a node
  double seconds = 0;                  // a search; 0: no end
  std::string tree_file;               // empty: none
  std::string certificate;             // file of enclosures; empty: none

  void add_to(CLI::App& app);

  // Throws cli::UsageError for options that the method does not look at.
  void refuse_idle(const CLI::App& app, const cli::ArtefactFiles& files) const;

  // Throws cli::UsageError where there is no one tree for the file that was asked for.
  void check(std::size_t queries) const;

  // Of one search, whose clock starts now.
  plan::PlanOptions started() const;

  // The lattice that astar is to search where no file gives one.
  std::optional<plan::Lattice> named_lattice(const geom::CollisionScene& scene) const;
};

}  // namespace planning
