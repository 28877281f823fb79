#include "geom/map/label_colour.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "geom/base/text_stream.h"
#include "geom/text/text_table.h"

namespace geom {
namespace {

constexpr std::array<Rgb8, 6> kColours = {{{176, 176, 176},
                                           {204, 102, 85},
                                           {86, 140, 196},
                                           {104, 164, 104},
                                           {196, 164, 76},
                                           {150, 110, 180}}};

}  // namespace

std::optional<Rgb8> written_colour(std::string_view label) {
  TextInput fields{std::string(label)};
  std::array<double, 3> part{};
  std::string field;
  for (double& p : part) {
    if (!(fields >> field)) return std::nullopt;
    const auto number = parse_number(field);
    if (!number || !(*number >= 0 && *number <= 255)) return std::nullopt;
    p = *number;
  }
  if (fields >> field) return std::nullopt;
  const double scale = *std::max_element(part.begin(), part.end()) > 1 ? 1 : 255;
  Rgb8 out{};
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = static_cast<std::uint8_t>(std::lround(part[i] * scale));
  }
  return out;
}

Rgb8 label_colour(std::uint32_t number, std::string_view label) {
  return written_colour(label).value_or(kColours[number % kColours.size()]);
}

bool is_keep_out(std::string_view label) {
  return label == "keep-out" || label.starts_with("keep-out: ") || label == "fence";
}

}  // namespace geom
