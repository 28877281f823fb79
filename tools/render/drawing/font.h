#pragma once

// Letters of 5 x 7 dots.

#include <cstdint>

namespace render {

// Whether the dot in column x (0 to 4) and row y (0 to 6, from the top) of a character is set.
bool dot(char character, int x, int y);

}  // namespace render
