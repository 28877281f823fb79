#include "xyz_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "geom/base/error.h"
#include "geom/text/excerpt.h"
#include "geom/text/text_table.h"

namespace geom {
namespace {

enum class Way { metres, degrees, downward, other_unit };

// What a column's name says.
struct Meaning {
  std::size_t axis;
  Way way = Way::metres;
  bool letter = false;  // x, y or z itself
};

struct Name {
  std::string_view word;
  Meaning meaning;
};

constexpr Name kNames[] = {{"x", {0, Way::metres, true}},
                           {"y", {1, Way::metres, true}},
                           {"z", {2, Way::metres, true}},
                           {"e", {0}},
                           {"east", {0}},
                           {"easting", {0}},
                           {"n", {1}},
                           {"north", {1}},
                           {"northing", {1}},
                           {"h", {2}},
                           {"height", {2}},
                           {"u", {2}},
                           {"up", {2}},
                           {"alt", {2}},
                           {"altitude", {2}},
                           {"elev", {2}},
                           {"elevation", {2}},
                           {"lon", {0, Way::degrees}},
                           {"lng", {0, Way::degrees}},
                           {"long", {0, Way::degrees}},
                           {"longitude", {0, Way::degrees}},
                           {"lat", {1, Way::degrees}},
                           {"latitude", {1, Way::degrees}},
                           {"d", {2, Way::downward}},
                           {"down", {2, Way::downward}},
                           {"depth", {2, Way::downward}}};
// Before or behind a letter: point_x, xcoord.
constexpr std::string_view kBeside[] = {"coordinate", "coord", "point", "pos", "position", "utm"};

constexpr std::string_view kMetre[] = {"", "m", "metre", "metres", "meter", "meters"};
constexpr std::string_view kUnits[] = {"m",      "metre", "metres", "meter",   "meters", "ft",
                                       "feet",   "usft",  "cm",     "mm",      "km",     "in",
                                       "inches", "deg",   "degree", "degrees", "rad"};

// Small letters and digits alone.
std::string plain(std::string_view text) {
  std::string out;
  for (char c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) out += c;
  }
  return out;
}

std::optional<Meaning> named(std::string_view word) {
  for (const Name& name : kNames) {
    if (name.word == word) return name.meaning;
  }
  for (const std::string_view beside : kBeside) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string letter(1, "xyz"[axis]);
      const std::string more(beside);
      if (word == letter + more || word == more + letter) return Meaning{axis};
    }
  }
  return std::nullopt;
}

// Of "x", "\"X\"", "Y [m]", "z_m" or "Easting(ft)".
std::optional<Meaning> meaning_of(std::string_view field) {
  const std::size_t bracket = std::min(field.find_first_of("([{"), field.size());
  std::string unit = plain(field.substr(bracket));
  const std::string_view name = field.substr(0, bracket);
  std::optional<Meaning> out = named(plain(name));
  if (const std::size_t mark = name.find_last_of("_ "); !out && mark != name.npos) {
    const std::string behind = plain(name.substr(mark));
    if (std::find(std::begin(kUnits), std::end(kUnits), behind) != std::end(kUnits)) {
      out = named(plain(name.substr(0, mark)));
      unit = behind;
    }
  }
  if (!out) return std::nullopt;
  const bool metre = std::find(std::begin(kMetre), std::end(kMetre), unit) != std::end(kMetre);
  if (unit.starts_with("deg") || unit == "rad") out->way = Way::degrees;
  if (!metre && out->way == Way::metres) out->way = Way::other_unit;
  return out;
}

void require_metres_upward(std::string_view name, Way way, const TextPlace& place) {
  const auto refuse = [&](Fault fault) {
    throw InputError(place.source, place.line, std::move(fault));
  };
  const std::string shown = excerpt(trimmed(name), 40);
  if (way == Way::degrees) {
    refuse({.expected = "columns in metres",
            .found = fmt::format("\"{}\", which is in degrees", shown),
            .advice = "project the points first, for example with `cs2cs`, and name the columns x, "
                      "y and z"});
  }
  if (way == Way::downward) {
    refuse({.expected = "a column of heights",
            .found = fmt::format("\"{}\", which counts downward", shown),
            .advice = "write z upward"});
  }
  if (way == Way::other_unit) {
    refuse({.expected = "columns in metres",
            .found = in_quotes(shown),
            .advice = "name them x, y and z alone, and give --units"});
  }
}

std::string listed(std::span<const std::string_view> names) {
  std::string out;
  for (const std::string_view name : names) out += (out.empty() ? "" : " ") + std::string(name);
  return excerpt(out, 60);
}

}  // namespace

XyzColumns xyz_columns(std::span<const std::string_view> names, const TextPlace& place) {
  XyzColumns out;
  out.count = names.size();
  std::vector<std::size_t> by_letter[3];
  std::vector<std::size_t> by_word[3];
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto meaning = meaning_of(names[i]);
    if (!meaning) continue;
    (meaning->letter ? by_letter : by_word)[meaning->axis].push_back(i);
  }
  const bool letters = std::none_of(std::begin(by_letter), std::end(by_letter),
                                    [](const auto& found) { return found.empty(); });
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<std::size_t> found = by_letter[axis];
    if (!letters) found.insert(found.end(), by_word[axis].begin(), by_word[axis].end());
    if (found.size() != 1) {
      throw InputError(
          place.source, place.line,
          {.expected = fmt::format("the names of columns, one of them for {} (as in \"x y z\" or "
                                   "\"id Easting Northing Height\")",
                                   "xyz"[axis]),
           .found = fmt::format("{} in \"{}\"", found.empty() ? "none" : "more", listed(names))});
    }
    out.of_axis[axis] = found[0];
  }
  for (const std::size_t i : out.of_axis) {
    require_metres_upward(names[i], meaning_of(names[i])->way, place);
  }
  return out;
}

bool name_all_axes(std::span<const std::string_view> words) {
  bool found[3] = {};
  for (const std::string_view word : words) {
    if (parse_number(word)) return false;
    if (const auto meaning = meaning_of(word)) found[meaning->axis] = true;
  }
  return found[0] && found[1] && found[2];
}

void fields_of(char separator, std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  if (separator != ' ') {
    for (std::size_t end = line.find(separator); end != line.npos; end = line.find(separator)) {
      fields.push_back(trimmed(line.substr(0, end)));
      line.remove_prefix(end + 1);
    }
    fields.push_back(trimmed(line));
    return;
  }
  for (std::size_t at = 0; (at = line.find_first_not_of(' ', at)) != line.npos;) {
    const std::size_t end = std::min(line.find(' ', at), line.size());
    fields.push_back(line.substr(at, end - at));
    at = end;
  }
}

char separator_of(std::string_view line) {
  const std::size_t end = line.find_first_of(" \t,;");
  if (end == line.npos) return ' ';
  if (!parse_number(line.substr(0, end))) {
    for (const char c : {';', ',', '\t'}) {
      if (line.find(c) != line.npos) return c;
    }
    return ' ';
  }
  const std::size_t next = std::min(line.find_first_not_of(" \t", end), line.size());
  if (next < line.size() && (line[next] == ',' || line[next] == ';')) return line[next];
  return line.substr(end, next - end).find('\t') != line.npos ? '\t' : ' ';
}

std::string_view name_of_separator(char separator) {
  switch (separator) {
    case ';':
      return "semicolons";
    case ',':
      return "commas";
    case '\t':
      return "tabs";
    default:
      return "blanks";
  }
}

}  // namespace geom
