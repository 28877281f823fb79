#include "geom/record/made_for_another.h"

#include <fmt/format.h>

#include "geom/base/error.h"

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

void require_asked_of(const Provenance& asked, const Provenance& ours, std::string_view source,
                      std::size_t line) {
  const Provenance whole{asked.map ? asked.map : ours.map, asked.frame ? asked.frame : ours.frame,
                         asked.vehicle ? asked.vehicle : ours.vehicle,
                         asked.margin ? asked.margin : ours.margin};
  const auto what = mismatch(whole, ours);
  if (what && value_of(ours, *what, false) == "none") {
    throw InputError(source, line,
                     {.says = fmt::format("asked of the {} {}, and nobody says which is ours",
                                          *what, value_of(whole, *what, false)),
                      .advice = "give the scene that it is asked of"});
  }
  if (const auto why = made_for_another(whole, ours)) {
    throw InputError(source, line,
                     {.says = *why, .advice = "ask for that one, or take it out of the record"});
  }
}

}  // namespace geom
