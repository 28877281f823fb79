#include "geom/map/label_colour.h"

#include <charconv>

namespace geom {

std::optional<Rgb> colour_of_label(std::string_view label) {
  Rgb out{};
  const char* at = label.data();
  const char* const end = at + label.size();
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (i > 0 && (at == end || *at++ != ' ')) return std::nullopt;
    const auto [next, error] = std::from_chars(at, end, out[i]);
    if (error != std::errc()) return std::nullopt;
    at = next;
  }
  return at == end ? std::optional(out) : std::nullopt;
}

Rgb label_colour(std::uint32_t label) {
  constexpr std::array<Rgb, 6> kColours = {{{176, 176, 176},
                                            {204, 102, 85},
                                            {86, 140, 196},
                                            {104, 164, 104},
                                            {196, 164, 76},
                                            {150, 110, 180}}};
  return kColours[label % kColours.size()];
}

Rgb label_colour(std::uint32_t label, std::string_view name) {
  return colour_of_label(name).value_or(label_colour(label));
}

}  // namespace geom
