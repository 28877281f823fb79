#include "geom/map/map_doubts.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geom/map/map_draft.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

using Json = nlohmann::json;

void look_at(const Json& steps, MapDoubts& out) {
  if (!steps.is_array()) return;
  for (const Json& step : steps) {
    if (!step.is_object()) continue;
    const auto at = [&](const char* key) { return step.value(key, Json()); };
    out.unknown_free = out.unknown_free || at("unknown") == "free";
    out.widened = out.widened || at("widened") == true;
    if (const Json gap = at("joined_gap"); gap.is_number())
      out.gap = std::max(out.gap, gap.get<double>());
    if (const Json others = at("histories"); others.is_array()) {
      for (const Json& other : others) look_at(other, out);
    }
  }
}

}  // namespace

MapDoubts doubts_of(const BoxMapSpec& spec) {
  MapDoubts out;
  if (spec.history.empty()) return out;
  look_at(parse_json(spec.history, "the map's history"), out);
  out.skipped = skipped_in(spec);  // a join counts those of all its maps
  return out;
}

}  // namespace geom
