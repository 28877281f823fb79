#pragma once

// Colours that people with any colour vision can tell apart, on white paper and in grey print.

#include <array>
#include <cstddef>
#include <string_view>

namespace plot {

// Okabe and Ito (2008), without yellow, which is too pale for lines.
inline constexpr std::array<std::string_view, 6> kPalette = {"#0072b2", "#d55e00", "#009e73",
                                                             "#cc79a7", "#e69f00", "#56b4e9"};
inline std::string_view colour(std::size_t i) { return kPalette[i % kPalette.size()]; }

inline constexpr std::string_view kInk = "#222222";
inline constexpr std::string_view kLimit = "#777777";
inline constexpr std::string_view kWarning = "#d55e00";  // vermilion

}  // namespace plot
