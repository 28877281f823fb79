#pragma once

// The colours in which meshes, pictures and pages show labels.
//
// Example:
//   assert((geom::written_colour("255 0 0") == geom::Rgb8{255, 0, 0}));
//   const geom::Rgb8 grey = geom::label_colour(0, "house");

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace geom {

using Rgb8 = std::array<std::uint8_t, 3>;  // red, green, blue

// The colour that a label is, as those of block texts and worlds are: three numbers between blanks,
// each 0 to 255, or each 0 to 1 where none is larger. "255 0 0" and "1 0 0" are red. Nothing for
// any other label.
std::optional<Rgb8> written_colour(std::string_view label);

// The colour to show a label in: the one that it is, or else one of six by its number in the map,
// grey first, which can be told apart.
Rgb8 label_colour(std::uint32_t number, std::string_view label = {});

// Whether boxes of this label are air that may not be flown through, rather than things that stand
// there: keep-out volumes and fences ("keep-out", "keep-out: NAME", "fence"). Pictures let them
// through, because flights lie around and inside.
bool is_keep_out(std::string_view label);

}  // namespace geom
