#pragma once

// Colours that people with any colour vision can tell apart, on white paper and in grey print.
//
// Example:
//   assert(geom::figure::colour(0) == "#0072b2" && geom::figure::colour(8) == "#0072b2");

#include <array>
#include <cstddef>
#include <string_view>

namespace geom::figure {

// Blue, vermilion and green of Okabe and Ito (2008), and five found by search: any two are 26 apart
// in CIE 1976 to the usual eye, to protanopes and to deuteranopes, and each has a contrast of 3 and
// more on white (tests/tools/view/palette_test.py).
inline constexpr std::array<std::string_view, 8> kPalette = {
    "#0072b2", "#d55e00", "#009e73", "#8b1d62", "#2b62ff", "#593300", "#e00047", "#111111"};
inline std::string_view colour(std::size_t i) { return kPalette[i % kPalette.size()]; }

inline constexpr std::string_view kInk = "#222222";
inline constexpr std::string_view kLimit = "#707070";
inline constexpr std::string_view kWarning = "#c25400";  // vermilion, dark enough for words

}  // namespace geom::figure
