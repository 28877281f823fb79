#include "geom/map/closed_within.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "geom/base/error.h"
#include "geom/base/precondition.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

using Json = nlohmann::ordered_json;

std::optional<Aabb> box_of(const Json& step, const char* key) {
  if (!step.contains(key) || !step[key].is_array() || step[key].size() != 6) return std::nullopt;
  Aabb out;
  for (int i = 0; i < 6; ++i) {
    const Json& number = step[key][static_cast<std::size_t>(i)];
    if (!number.is_number()) return std::nullopt;
    (i < 3 ? out.min[i] : out.max[i - 3]) = number.get<double>();
  }
  return out;
}

// What both hold; where one is absent, the other.
std::optional<Aabb> both(const std::optional<Aabb>& a, const std::optional<Aabb>& b) {
  if (!a || !b) return a ? a : b;
  return Aabb{a->min.cwiseMax(b->min), a->max.cwiseMin(b->max)};
}

// "z from 0 to 120", "z up to 120": the sides that there are.
std::string in_words(const Aabb& box) {
  std::string out;
  for (int i = 0; i < 3; ++i) {
    const bool from = box.min[i] > -kFarthest;
    const bool to = box.max[i] < kFarthest;
    if (!from && !to) continue;
    if (!out.empty()) out += ", ";
    out += "xyz"[i];
    if (from) out += fmt::format(" from {:.6g}", box.min[i]);
    if (to) out += fmt::format(" {} {:.6g}", from ? "to" : "up to", box.max[i]);
  }
  return out;
}

std::optional<Aabb> within(const Json& steps) {
  std::optional<Aabb> out;
  if (!steps.is_array()) return out;
  for (const Json& step : steps) {
    if (!step.is_object()) continue;
    out = both(out, box_of(step, "closed_within"));
    if (out && step.value("tool", "") == "skyway-map crop") out = both(out, box_of(step, "bounds"));
    if (!step.contains("histories") || !step["histories"].is_array()) continue;
    for (const Json& other : step["histories"]) out = both(out, within(other));
  }
  return out;
}

}  // namespace

std::optional<Aabb> closed_within(const BoxMapSpec& spec) {
  if (spec.history.find("closed_within") == std::string::npos) return std::nullopt;
  return within(parse_ordered_json(spec.history, "the map's history"));
}

void require_closed_within(const BoxMapSpec& spec, const Aabb& bounds, const std::string& source) {
  const auto closed = closed_within(spec);
  if (!closed) return;
  if ((closed->min.array() <= bounds.min.array()).all() &&
      (bounds.max.array() <= closed->max.array()).all()) {
    return;
  }
  throw InputError(
      source,
      {.says = fmt::format("zones of airspace, limits over the ground, fences or keep-out volumes "
                           "are closed in this map only within {}",
                           in_words(*closed)),
       .advice = "change the bounds of the map before you patch these into it"});
}

}  // namespace geom
