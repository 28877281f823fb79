#pragma once

// --patch and --old-map: an artefact of an older map to start from.

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <string>

#include "geom/archive/array_archive.h"
#include "plan/patch/map_change.h"
#include "scenes.h"
#include "vehicle_option.h"

namespace cli {

struct PatchOptions {
  std::string artefact;  // --patch
  std::string old_map;   // --old-map

  // `kind` in words, for the help; the artefact itself says what `excluded` would.
  void add_to(CLI::App& app, const std::string& kind, std::initializer_list<CLI::Option*> excluded);
  bool asked() const { return !artefact.empty(); }

  // The artefact, undamaged: what is copied of it gets new checksums.
  geom::ArrayArchive open(const geom::Execution& run) const;

  // The new map's scene for what the artefact was made for; options must agree with it.
  const geom::CollisionScene& scene(Scenes& scenes, geom::Provenance made_for) const;

  // Throws geom::InputError where the artefact was made for a map other than the old one.
  plan::MapChange change(const geom::Provenance& made_for, const geom::CollisionScene& scene) const;
};

}  // namespace cli
