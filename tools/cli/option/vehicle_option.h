#pragma once

// --vehicle and --margin; --spare and --memory for tools that ask a collision scene.

#include <CLI/CLI.hpp>
#include <cstddef>
#include <optional>
#include <string>

#include "geom/record/agreed_room.h"
#include "vehicle_word.h"

namespace cli {

struct VehicleOptions {
  std::string word;              // --vehicle
  std::optional<double> margin;  // --margin
  double spare = 0;              // --spare
  std::string memory;            // --memory

  void add_to(CLI::App& app);
  void add_spare_to(CLI::App& app);
  void add_memory_to(CLI::App& app);
  std::size_t budget() const;  // geom::CollisionOptions; a fair share where none was asked for
  std::optional<traj::VehicleProfile> profile() const;
  geom::AskedRoom asked(
      const std::optional<traj::VehicleProfile>& profile) const;  // with what profile() gave
};

}  // namespace cli
