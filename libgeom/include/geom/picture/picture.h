#pragma once

// Pictures in memory.
//
// Example:
//   geom::picture::Picture picture{2, 1, {{255, 0, 0}, {0, 0, 255}}, {}, {}};
//   assert(picture.pixels() == 2 && picture.depth.empty());

#include <cstdint>
#include <vector>

namespace geom::picture {

struct Colour {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;

  friend bool operator==(const Colour&, const Colour&) = default;
};

// Row by row from the top. What was not asked for is empty.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<Colour> colour;
  std::vector<float> depth;       // metres along the optical axis; 0 where nothing is seen
  std::vector<std::uint32_t> id;  // row of the box in the map, plus 1; 0 for everything else

  std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

}  // namespace geom::picture
