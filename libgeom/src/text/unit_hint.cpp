#include "geom/text/unit_hint.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <system_error>

#include "geom/text/number.h"

namespace geom {
namespace {

struct NamedUnit {
  std::string_view word;
  double factor;          // to ours
  std::string_view ours;  // as descriptions of options name it
};

constexpr double kDegrees = 57.29577951308232;  // in a radian

constexpr std::array kUnits = {
    NamedUnit{"mm", 1e-3, "metres"},
    NamedUnit{"cm", 1e-2, "metres"},
    NamedUnit{"dm", 1e-1, "metres"},
    NamedUnit{"m", 1, "metres"},
    NamedUnit{"metres", 1, "metres"},
    NamedUnit{"meters", 1, "metres"},
    NamedUnit{"km", 1e3, "metres"},
    NamedUnit{"ft", 0.3048, "metres"},
    NamedUnit{"in", 0.0254, "metres"},
    NamedUnit{"m/s", 1, "m/s"},
    NamedUnit{"mps", 1, "m/s"},
    NamedUnit{"km/h", 1 / 3.6, "m/s"},
    NamedUnit{"kmh", 1 / 3.6, "m/s"},
    NamedUnit{"kph", 1 / 3.6, "m/s"},
    NamedUnit{"mph", 0.44704, "m/s"},
    NamedUnit{"kn", 1.852 / 3.6, "m/s"},
    NamedUnit{"m/s2", 1, "m/s2"},
    NamedUnit{"m/s^2", 1, "m/s2"},
    NamedUnit{"g", 9.80665, "m/s2"},
    NamedUnit{"deg", 1, "degrees"},
    NamedUnit{"degrees", 1, "degrees"},
    NamedUnit{"°", 1, "degrees"},
    NamedUnit{"rad", kDegrees, "degrees"},
    NamedUnit{"ms", 1e-3, "seconds"},
    NamedUnit{"s", 1, "seconds"},
    NamedUnit{"sec", 1, "seconds"},
    NamedUnit{"min", 60, "seconds"},
    NamedUnit{"Hz", 1, "Hz"},
    NamedUnit{"hz", 1, "Hz"},
    NamedUnit{"%", 1e-2, ""},
};

std::optional<double> whole_number(std::string_view text) {
  double value = 0;
  const auto [rest, error] = geom::read_number(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size()) return std::nullopt;
  return value;
}

// "0.5" of "0,5"; a second comma makes a list of it.
std::optional<std::string> with_point(std::string_view text) {
  if (std::count(text.begin(), text.end(), ',') != 1) return std::nullopt;
  std::string out(text);
  out[out.find(',')] = '.';
  return whole_number(out) ? std::optional(out) : std::nullopt;
}

// Whether the description's words name the unit: "m/s" is none in "m/s2".
bool has_word(std::string_view description, std::string_view unit) {
  for (std::size_t at = description.find(unit); at != description.npos;
       at = description.find(unit, at + 1)) {
    const std::size_t end = at + unit.size();
    const auto letter = [&](std::size_t i) {
      return i < description.size() && (std::isalnum(static_cast<unsigned char>(description[i])) ||
                                        description[i] == '/' || description[i] == '^');
    };
    if (!letter(end) && !(at > 0 && letter(at - 1))) return true;
  }
  return false;
}

}  // namespace

std::string unit_hint(std::string_view text, std::string_view description) {
  if (const auto point = with_point(text)) return fmt::format("; write {}", *point);
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = geom::read_number(text.data(), end, value);
  if (error != std::errc() || rest == end) return "";
  std::string_view word(rest, static_cast<std::size_t>(end - rest));
  word.remove_prefix(std::min(word.find_first_not_of(' '), word.size()));
  const auto unit = std::find_if(kUnits.begin(), kUnits.end(),
                                 [&](const NamedUnit& u) { return u.word == word; });
  if (unit == kUnits.end()) return "";
  const bool ours = !unit->ours.empty() && has_word(description, unit->ours);
  if (!ours) return fmt::format("; give the number alone, without \"{}\"", word);
  return fmt::format("; give {} without the unit, {:.6g}", unit->ours, value * unit->factor);
}

}  // namespace geom
