#pragma once

// The colours in which meshes and pictures show labels.

#include <array>
#include <cstdint>

namespace geom {

// Red, green, blue. Distinct enough, the same for the same label number: grey first.
inline std::array<std::uint8_t, 3> label_colour(std::uint32_t label) {
  constexpr std::array<std::array<std::uint8_t, 3>, 6> kColours = {{{176, 176, 176},
                                                                    {204, 102, 85},
                                                                    {86, 140, 196},
                                                                    {104, 164, 104},
                                                                    {196, 164, 76},
                                                                    {150, 110, 180}}};
  return kColours[label % kColours.size()];
}

}  // namespace geom
