#include "geom/io/building_height.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "text_table.h"

namespace geom {
namespace {

// A decimal number, with point or comma, that leads `text`; what follows is left in it.
std::optional<double> leading_number(std::string_view& text) {
  std::string plain;
  std::size_t used = 0;
  for (; used < text.size(); ++used) {
    const char c = text[used] == ',' ? '.' : text[used];
    const bool sign = used == 0 && (c == '-' || c == '+');
    if (!sign && !(c >= '0' && c <= '9') && c != '.') break;
    if (c == '.' && plain.find('.') != std::string::npos) break;
    plain += c;
  }
  const auto value = parse_number(plain);
  if (!value) return std::nullopt;
  text.remove_prefix(used);
  return value;
}

}  // namespace

std::optional<double> parse_length(std::string_view text) {
  text = trimmed(text);
  while (!text.empty() && (text[0] == '~' || text[0] == '<' || text[0] == '>')) {
    text = trimmed(text.substr(1));
  }
  const auto value = leading_number(text);
  if (!value) return std::nullopt;
  text = trimmed(text);
  double metres = *value;
  if (text.starts_with("'")) {
    metres *= 0.3048;
    text = trimmed(text.substr(1));
    if (const auto inches = leading_number(text)) metres += *inches * 0.0254;
  } else if (text.starts_with("ft") || text.starts_with("feet") || text.starts_with("foot")) {
    metres *= 0.3048;
  } else if (text.starts_with("cm")) {
    metres *= 0.01;
  } else if (text.starts_with("km")) {
    metres *= 1000;
  } else if (!text.empty() && text[0] != 'm' && text[0] != 'M' && text[0] != ';') {
    return std::nullopt;
  }
  if (!(std::abs(metres) <= 1e4)) return std::nullopt;
  return metres;
}

std::optional<double> parse_levels(std::string_view text) {
  std::optional<double> most;
  while (!text.empty()) {
    if (text[0] < '0' || text[0] > '9') {
      text.remove_prefix(1);
      continue;
    }
    const auto value = leading_number(text);
    if (value && *value <= 300) most = std::max(most.value_or(0), *value);
    if (!value) text.remove_prefix(1);
  }
  return most;
}

BuildingHeight building_height(const std::function<std::string(const char*)>& tag,
                               const HeightOptions& options) {
  BuildingHeight out;
  const auto read = [&](const char* key, const auto& parse) -> std::optional<double> {
    const std::string text = tag(key);
    if (trimmed(text).empty()) return std::nullopt;
    const auto value = parse(text);
    if (!value) out.junk = true;
    return value;
  };
  const auto metres = [&](const char* key) { return read(key, parse_length); };
  const auto levels = [&](const char* key) { return read(key, parse_levels); };

  std::optional<double> top;
  if (!options.attribute.empty()) top = metres(options.attribute.c_str());
  if (!top) top = metres("height");
  if (!top) top = metres("building:height");
  out.from = top ? HeightFrom::height : HeightFrom::nothing;
  if (!top) {
    if (const auto storeys = levels("building:levels")) {
      const auto roof = metres("roof:height");
      const double above = roof ? *roof : levels("roof:levels").value_or(0) * options.storey;
      top = *storeys * options.storey + std::max(0.0, above);
      out.from = HeightFrom::levels;
    }
  }
  if (top && !(*top > 0)) {
    out.junk = true;
    out.from = HeightFrom::nothing;
    top.reset();
  }
  out.top = top.value_or(options.default_height);
  auto bottom = metres("min_height");
  if (!bottom) {
    if (const auto level = levels("building:min_level")) bottom = *level * options.storey;
  }
  if (bottom && *bottom > 0) {
    if (*bottom < out.top) {
      out.bottom = *bottom;
    } else {
      out.junk = true;  // hangs above its own roof: kept, down to the ground
    }
  }
  return out;
}

}  // namespace geom
