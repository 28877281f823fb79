#include "geom/record/made_for_another.h"

#include <fmt/format.h>

namespace geom {
namespace {

std::string value_of(const Provenance& p, std::string_view what, bool exact) {
  if (what == "map") return p.map.value_or("none");
  if (what == "frame") return p.frame ? std::string(name(*p.frame)) : "none";
  if (what == "vehicle") return p.vehicle ? in_words(*p.vehicle, exact) : "none";
  return p.margin ? fmt::format("{} m", *p.margin) : "none";
}

}  // namespace

std::string in_words(const Vehicle& vehicle, bool exact) {
  const Vec3& half = vehicle.half;
  const auto sizes = exact ? fmt::format("{}, {}, {}", half[0], half[1], half[2])
                           : fmt::format("{:.4g}, {:.4g}, {:.4g}", half[0], half[1], half[2]);
  return fmt::format("{} (half sizes {} m)", vehicle.name, sizes);
}

std::optional<std::string> made_for_another(const Provenance& made_for, const Provenance& ours) {
  const auto what = mismatch(made_for, ours);
  if (!what) return std::nullopt;
  const bool exact = value_of(made_for, *what, false) == value_of(ours, *what, false);
  return fmt::format("made for another {}, {}, not {}", *what, value_of(made_for, *what, exact),
                     value_of(ours, *what, exact));
}

std::string in_words(const LimitKind& kind, double value) {
  return fmt::format("{:.10g} {}", value * (1 / kind.in_unit), kind.unit);
}

}  // namespace geom
