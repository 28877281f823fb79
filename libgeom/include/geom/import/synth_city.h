#pragma once

// A made-up city: blocks of buildings, towers with set-backs, trees, lamps, trucks, an overpass.
//
// Example:
//   const geom::SynthSpec small{.seed = 7, .size_x = 200, .size_y = 200};
//   const std::vector<geom::CenteredBox> city = geom::synth_city(small);
//   std::ostringstream out;
//   geom::write_fcnd_csv(out, {47.4, 8.5, 0}, city);

#include <cstdint>
#include <vector>

#include "geom/import/fcnd_csv.h"

namespace geom {

struct SynthSpec {
  std::uint64_t seed = 0;
  double size_x = 900;  // metres, around (0, 0)
  double size_y = 900;
  double height = 200;  // of the tallest towers, metres
};

// The same boxes for the same numbers on every machine: only + - * / and an integer generator, and
// coordinates on a grid of 1 mm. About 4 boxes a 1000 m2; cost is linear in the area.
std::vector<CenteredBox> synth_city(const SynthSpec& spec);

}  // namespace geom
