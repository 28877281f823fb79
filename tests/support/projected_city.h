#pragma once

// A city's footprints in the coordinates of its map, as skyway-footprints has them.

#include <fstream>
#include <string>
#include <vector>

#include "geom/gis/footprint_source.h"
#include "geom/gis/place_footprints.h"
#include "geom/gis/read_footprints.h"

namespace support {

inline std::vector<geom::Footprint> projected_city(const std::string& path, double slack) {
  std::ifstream in(path, std::ios::binary);
  std::string head(4096, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  in.clear();
  in.seekg(0);
  geom::gis::Source source =
      geom::gis::read(geom::gis::footprint_format_of(head, path), {path, path, in}, {});
  const geom::gis::Projector projector(source, path, std::nullopt, true);
  geom::gis::sink_ground(source.footprints, std::nullopt);
  geom::gis::project(source, projector, slack);
  return std::move(source.footprints);
}

}  // namespace support
