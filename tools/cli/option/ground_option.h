#pragma once

// --ground-model and --agl: the ground of a map, and heights above it that a vehicle keeps to.

#include <CLI/CLI.hpp>
#include <string>

#include "geom/map/ground_model.h"
#include "geom/map/map_patch.h"
#include "geom/zone/ground_band.h"

namespace cli {

inline constexpr const char* kGroundHelp =
    "the ground that heights above ground count from: a file of skyway-footprints --ground-of, or "
    "the map's z of flat ground, metres";

// A file of the ground, or the height of flat ground in the map's z.
geom::GroundModel ground_from(const std::string& word);

// "LOW,HIGH", metres above the ground. Throws UsageError.
geom::GroundBand band_from(const std::string& agl);

// Says in the history what the ground is. Throws InputError where it is that of another map.
void note_ground(const geom::GroundModel& ground, const std::string& word, geom::MapPatch& patch);

// Adds what is outside of the band, and says so in the history; how many boxes that are.
std::size_t close_band(const geom::GroundBand& band, const geom::GroundModel& ground,
                       const std::string& word, geom::MapPatch& patch);

// Both options of a tool that reads a map.
class AglOption {
 public:
  void add_to(CLI::App& app);
  void refuse_idle(const CLI::App& app) const;  // throws UsageError

  // The map as `skyway-map patch --agl` makes it, with the same hash; the map itself without --agl.
  geom::BoxMap applied(const geom::BoxMap& map, const std::string& name) const;

 private:
  std::string ground_;
  std::string agl_;
};

}  // namespace cli
