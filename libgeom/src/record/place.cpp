#include "geom/record/place.h"

#include <array>
#include <cmath>

#include "geom/text/number.h"

namespace geom {
namespace {

constexpr std::string_view kAbove = "above";

std::optional<double> metres(std::string_view text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = read_number(text.data(), end, value);
  if (error != std::errc() || rest != end || !(std::abs(value) <= kLargestCoordinate)) {
    return std::nullopt;
  }
  return value;
}

// Degrees before one of two letters, the second of which makes them negative.
std::optional<double> degrees(std::string_view text, std::string_view letters, double most) {
  if (text.empty() || text.front() == '-') return std::nullopt;
  const std::size_t which = letters.find(text.back());
  if (which == letters.npos) return std::nullopt;
  text.remove_suffix(1);
  const auto value = metres(text);
  if (!value || !(*value <= most)) return std::nullopt;
  return which == 0 ? *value : -*value;
}

std::optional<std::array<std::string_view, 3>> three_fields(std::string_view text) {
  std::array<std::string_view, 3> out;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::size_t end = i + 1 < out.size() ? text.find(',') : text.size();
    if (end == text.npos) return std::nullopt;
    out[i] = text.substr(0, end);
    text.remove_prefix(i + 1 < out.size() ? end + 1 : end);
  }
  return out;
}

std::optional<EarthPlace> on_earth(std::string_view latitude, std::string_view longitude,
                                   std::string_view height) {
  const auto north = degrees(latitude, "NS", 90);
  const auto east = degrees(longitude, "EW", 180);
  const auto up = parse_height(height);
  if (!north || !east || !up) return std::nullopt;
  return EarthPlace{*north, *east, up->metres, up->above};
}

}  // namespace

std::optional<Height> parse_height(std::string_view text) {
  const bool above = text.ends_with(kAbove);
  if (above) text.remove_suffix(kAbove.size());
  const auto value = metres(text);
  return value ? std::optional(Height{*value, above}) : std::nullopt;
}

std::optional<Place> parse_place(std::string_view text) {
  const auto fields = three_fields(text);
  if (!fields) return std::nullopt;
  const auto [a, b, c] = *fields;
  if (const auto x = metres(a), y = metres(b), z = metres(c); x && y && z) return Vec3(*x, *y, *z);
  if (const auto place = on_earth(a, b, c)) return *place;
  if (const auto place = on_earth(b, a, c)) return *place;
  return std::nullopt;
}

}  // namespace geom
