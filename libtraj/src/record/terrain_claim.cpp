#include "traj/record/terrain_claim.h"

#include <fmt/format.h>

#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"

namespace traj {
namespace {

double metres(const geom::JsonFields& fields, const char* key) {
  constexpr double kMost = 1e6;
  const auto value = fields.number(key);
  if (value && *value >= 0 && *value <= kMost) return *value;
  fields.refuse({.key = key,
                 .expected = "metres from 0 to 1e6",
                 .found = value ? fmt::to_string(*value) : "none"});
}

}  // namespace

void add(geom::JsonLine& line, const TerrainClaim& claim) {
  line.add("model", claim.model).add("error", claim.error).add("spacing", claim.spacing);
  line.add("lag", claim.lag).add("band", claim.band);
}

TerrainClaim read_terrain_claim(const geom::JsonFields& fields) {
  return {fields.text("model"), metres(fields, "error"), metres(fields, "spacing"),
          metres(fields, "lag"), metres(fields, "band")};
}

}  // namespace traj
