#include "geom/map/label_colour.h"

#include <algorithm>
#include <cmath>

#include "geom/text/number.h"

namespace geom {
namespace {

// Three numbers from 0 to 255 between single blanks.
std::optional<std::array<double, 3>> three_numbers(std::string_view label) {
  std::array<double, 3> out{};
  const char* at = label.data();
  const char* const end = at + label.size();
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (i > 0 && (at == end || *at++ != ' ')) return std::nullopt;
    const auto [next, error] = read_number(at, end, out[i]);
    if (error != std::errc() || !(out[i] >= 0 && out[i] <= 255)) return std::nullopt;
    at = next;
  }
  return at == end ? std::optional(out) : std::nullopt;
}

}  // namespace

std::optional<Rgb> colour_of_label(std::string_view label) {
  const auto numbers = three_numbers(label);
  if (!numbers) return std::nullopt;
  const double full = *std::max_element(numbers->begin(), numbers->end()) <= 1 ? 255 : 1;
  Rgb out{};
  std::transform(numbers->begin(), numbers->end(), out.begin(),
                 [full](double v) { return static_cast<std::uint8_t>(std::lround(full * v)); });
  return out;
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
