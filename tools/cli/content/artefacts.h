#pragma once

// The lattice and the roadmap that a planner may be given.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "geom/collision/collision.h"
#include "plan/planner/plan.h"

namespace cli {

struct ArtefactFiles {
  std::string lattice;  // empty: none
  std::string roadmap;

  void add_to(CLI::App& app);  // --lattice and --roadmap
};

class Artefacts {
 public:
  // Throws geom::InputError or std::system_error as opening does.
  explicit Artefacts(const ArtefactFiles& files);

  // Each serves one map, frame, vehicle and margin: throws geom::InputError where these are not the
  // scene's.
  void require_made_for(const geom::CollisionScene& scene) const;

  const plan::Lattice* lattice() const { return lattice_ ? &*lattice_ : nullptr; }
  const plan::Roadmap* roadmap() const { return roadmap_ ? &*roadmap_ : nullptr; }

 private:
  ArtefactFiles files_;
  std::optional<plan::Lattice> lattice_;
  std::optional<plan::Roadmap> roadmap_;
};

}  // namespace cli
