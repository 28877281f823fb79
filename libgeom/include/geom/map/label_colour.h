#pragma once

// The colours in which meshes and pictures show labels.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace geom {

using Rgb = std::array<std::uint8_t, 3>;  // red, green, blue

// The colour that a label itself says: three numbers from 0 to 255 between single blanks, as block
// texts give them ("255 0 0" is red), or, where none is over 1, shares of full colour, as RotorPy's
// worlds give them ("1 0 0" is red too). Nothing for any other label.
std::optional<Rgb> colour_of_label(std::string_view label);

// Distinct enough, the same for the same label number: grey first.
Rgb label_colour(std::uint32_t label);

// The colour that the label says, else the one of its number.
Rgb label_colour(std::uint32_t label, std::string_view name);

}  // namespace geom
