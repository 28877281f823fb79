#include "unit_hint.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <system_error>

#include "geom/text/number.h"

namespace cli {
namespace {

struct Unit {
  std::string_view word;
  double factor;          // to ours
  std::string_view ours;  // as descriptions of options name it
};

constexpr double kDegrees = 57.29577951308232;  // in a radian

constexpr std::array kUnits = {
    Unit{"mm", 1e-3, "metres"},
    Unit{"cm", 1e-2, "metres"},
    Unit{"dm", 1e-1, "metres"},
    Unit{"m", 1, "metres"},
    Unit{"metres", 1, "metres"},
    Unit{"meters", 1, "metres"},
    Unit{"km", 1e3, "metres"},
    Unit{"ft", 0.3048, "metres"},
    Unit{"in", 0.0254, "metres"},
    Unit{"m/s", 1, "m/s"},
    Unit{"mps", 1, "m/s"},
    Unit{"km/h", 1 / 3.6, "m/s"},
    Unit{"kmh", 1 / 3.6, "m/s"},
    Unit{"kph", 1 / 3.6, "m/s"},
    Unit{"mph", 0.44704, "m/s"},
    Unit{"kn", 1.852 / 3.6, "m/s"},
    Unit{"m/s2", 1, "m/s2"},
    Unit{"m/s^2", 1, "m/s2"},
    Unit{"g", 9.80665, "m/s2"},
    Unit{"deg", 1, "degrees"},
    Unit{"degrees", 1, "degrees"},
    Unit{"°", 1, "degrees"},
    Unit{"rad", kDegrees, "degrees"},
    Unit{"ms", 1e-3, "seconds"},
    Unit{"s", 1, "seconds"},
    Unit{"sec", 1, "seconds"},
    Unit{"min", 60, "seconds"},
    Unit{"Hz", 1, "Hz"},
    Unit{"hz", 1, "Hz"},
    Unit{"%", 1e-2, ""},
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
  const auto unit =
      std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& u) { return u.word == word; });
  if (unit == kUnits.end()) return "";
  const bool ours = !unit->ours.empty() && has_word(description, unit->ours);
  if (!ours) return fmt::format("; give the number alone, without \"{}\"", word);
  return fmt::format("; give {} without the unit, {:.6g}", unit->ours, value * unit->factor);
}

}  // namespace cli
