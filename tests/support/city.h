#pragma once

// The map that benchmarks and long comparisons run on: the real table where SKYWAY_REALDATA names a
// folder that has it, else the demo's city.

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>

#include "geom/import/fcnd_csv.h"
#include "geom/map/make_map.h"

namespace support {

inline std::string city_file() {
  const char* folder = std::getenv("SKYWAY_REALDATA");
  if (folder) return std::string(folder) + "/colliders/udacity_colliders.csv";
  return SKYWAY_SOURCE_DIR "/data/downtown.csv";
}

inline geom::BoxMap load_city(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file);
  geom::FcndTable table = geom::read_fcnd_csv(in, file);
  geom::MakeMapOptions options;
  options.floor = 0;
  options.seal = 1;
  return geom::make_map(std::move(table.table), {geom::Axes::neu, table.origin, ""}, "[]", file,
                        options)
      .map;
}

}  // namespace support
