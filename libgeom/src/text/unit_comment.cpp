#include "text/unit_comment.h"

#include <string>
#include <utility>

namespace geom {
namespace {

constexpr std::pair<std::string_view, double> kUnits[] = {{"m", 1},
                                                          {"meter", 1},
                                                          {"meters", 1},
                                                          {"metre", 1},
                                                          {"metres", 1},
                                                          {"mm", 1e-3},
                                                          {"millimeter", 1e-3},
                                                          {"millimeters", 1e-3},
                                                          {"cm", 1e-2},
                                                          {"centimeter", 1e-2},
                                                          {"centimeters", 1e-2},
                                                          {"millimetres", 1e-3},
                                                          {"centimetres", 1e-2},
                                                          {"km", 1e3},
                                                          {"kilometers", 1e3},
                                                          {"in", 0.0254},
                                                          {"inch", 0.0254},
                                                          {"inches", 0.0254},
                                                          {"ft", 0.3048},
                                                          {"foot", 0.3048},
                                                          {"feet", 0.3048},
                                                          {"yard", 0.9144},
                                                          {"yards", 0.9144}};

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

bool is_letter(char c) { return c >= 'a' && c <= 'z'; }

}  // namespace

std::optional<double> unit_of_comment(std::string_view comment) {
  const std::string words = lower(comment);
  std::string_view rest = words;
  const std::size_t unit = rest.find("unit");
  if (unit == rest.npos || (unit > 0 && is_letter(rest[unit - 1]))) return std::nullopt;
  rest.remove_prefix(unit + 4);
  if (rest.starts_with('s')) rest.remove_prefix(1);
  const std::size_t mark = rest.find_first_not_of(' ');
  if (mark == rest.npos || (rest[mark] != '=' && rest[mark] != ':')) return std::nullopt;
  const std::size_t first = rest.find_first_not_of(' ', mark + 1);
  if (first == rest.npos) return std::nullopt;
  std::size_t end = first;
  while (end < rest.size() && is_letter(rest[end])) ++end;
  for (const auto& [word, metres] : kUnits) {
    if (word == rest.substr(first, end - first)) return metres;
  }
  return std::nullopt;
}

}  // namespace geom
