#pragma once

// A city's footprints in the coordinates of its map, as skyway-footprints has them.

#include <fstream>
#include <string>
#include <vector>

#include "footprints/formats.h"
#include "footprints/place.h"
#include "footprints/source.h"

namespace support {

inline std::vector<geom::Footprint> projected_city(const std::string& path, double slack) {
  std::ifstream in(path, std::ios::binary);
  std::string head(4096, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  in.clear();
  in.seekg(0);
  footprints::Source source = footprints::read(footprints::detect(head, path), path, path, in, {});
  const footprints::Projector projector(source, path, std::nullopt, true);
  footprints::sink_ground(source.footprints, std::nullopt);
  footprints::project(source, projector, slack);
  return std::move(source.footprints);
}

}  // namespace support
