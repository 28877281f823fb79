#pragma once

// What skyway-cloud is asked of a cloud's coordinates: their unit, reference system and origin.

#include <CLI/CLI.hpp>
#include <string>

#include "geom/cloud/cloud_place.h"

namespace cloud {

class PlaceOptions {
 public:
  void add_to(CLI::App& app);               // --crs, --units, --vertical-units, --origin
  geom::CloudPlaceOptions options() const;  // throws cli::UsageError

 private:
  void parse_origin(const std::string& text);

  geom::CloudPlaceOptions options_;
  std::string units_;
  std::string vertical_units_;
};

}  // namespace cloud
