#include "geom/import/building_height.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "geom/text/text_table.h"

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

// Calls f(part) for each of "3;4", "3-5" and "3 - 5"; a sign belongs to its number.
template <class F>
void for_each_part(std::string_view text, const F& f) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const bool range = i < text.size() && text[i] == '-' &&
                       text.substr(begin, i - begin).find_first_of("0123456789") < i;
    if (i < text.size() && text[i] != ';' && !range) continue;
    f(trimmed(text.substr(begin, i - begin)));
    begin = i + 1;
  }
}

// The first number of a part with its sign, whatever stands around it.
std::optional<double> level_of(std::string_view part) {
  const std::size_t at = part.find_first_of("0123456789");
  if (at == std::string_view::npos) return std::nullopt;
  part.remove_prefix(at > 0 && part[at - 1] == '-' ? at - 1 : at);
  return leading_number(part);
}

}  // namespace

std::optional<double> parse_length(std::string_view text, double bare) {
  text = trimmed(text);
  while (!text.empty() && (text[0] == '~' || text[0] == '<' || text[0] == '>')) {
    text = trimmed(text.substr(1));
  }
  const auto value = leading_number(text);
  if (!value) return std::nullopt;
  text = trimmed(text);
  double metres = *value;
  if (text.empty() || text[0] == ';') {
    metres *= bare;
  } else if (text.starts_with("'")) {
    metres *= 0.3048;
    text = trimmed(text.substr(1));
    if (const auto inches = leading_number(text)) metres += *inches * 0.0254;
  } else if (text.starts_with("ft") || text.starts_with("feet") || text.starts_with("foot")) {
    metres *= 0.3048;
  } else if (text.starts_with("cm")) {
    metres *= 0.01;
  } else if (text.starts_with("km")) {
    metres *= 1000;
  } else if (text.starts_with("mi") || text.starts_with("mm")) {
    return std::nullopt;
  } else if (text[0] != 'm' && text[0] != 'M') {
    return std::nullopt;
  }
  if (!(std::abs(metres) <= 1e4)) return std::nullopt;
  return metres;
}

std::optional<double> parse_highest(std::string_view text, double bare) {
  std::optional<double> most;
  for_each_part(text, [&](std::string_view part) {
    const auto value = parse_length(part, bare);
    if (value) most = std::max(most.value_or(*value), *value);
  });
  return most;
}

std::optional<double> parse_lowest(std::string_view text, double bare) {
  std::optional<double> least;
  bool junk = false;
  for_each_part(text, [&](std::string_view part) {
    const auto value = parse_length(part, bare);
    if (value) least = std::min(least.value_or(*value), *value);
    junk |= !value;
  });
  return junk ? std::nullopt : least;
}

std::optional<double> parse_levels(std::string_view text) {
  std::optional<double> most;
  for_each_part(text, [&](std::string_view part) {
    const auto value = level_of(part);
    if (value && std::abs(*value) <= 300) most = std::max(most.value_or(*value), *value);
  });
  return most;
}

std::optional<double> parse_lowest_level(std::string_view text) {
  std::optional<double> least;
  bool junk = false;
  for_each_part(text, [&](std::string_view part) {
    const auto value = level_of(part);
    if (value) least = std::min(least.value_or(*value), *value);
    junk |= !value || std::abs(*value) > 300;
  });
  return junk ? std::nullopt : least;
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
  const auto length = [&](const auto& parse) {
    return [&out, &options, &parse](std::string_view text) {
      out.bare |= parse(text, 1) != parse(text, 2);
      return parse(text, options.unit);
    };
  };
  const auto metres = [&](const char* key) { return read(key, length(parse_highest)); };
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
  out.unread = out.junk;
  if (top && !(*top > 0)) {
    out.junk = true;
    out.from = HeightFrom::nothing;
    top.reset();
  }
  out.top = top.value_or(options.default_height);
  auto bottom = read("min_height", length(parse_lowest));
  if (!bottom) {
    if (const auto level = read("building:min_level", parse_lowest_level))
      bottom = *level * options.storey;
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
