#include "traj/record/terrain_claim.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

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
  line.add("model", claim.model);
  if (claim.surface) {
    add(line, *claim.surface);
  } else {
    line.add("error", claim.error).add("spacing", claim.spacing).add("lag", claim.lag);
  }
  line.add("band", claim.band);
}

TerrainClaim read_terrain_claim(const geom::JsonFields& fields) {
  TerrainClaim out{.model = fields.text("model"), .band = metres(fields, "band")};
  if (!fields.has(kSurfaceBandKey)) {
    out.error = metres(fields, "error");
    out.spacing = metres(fields, "spacing");
    out.lag = metres(fields, "lag");
    return out;
  }
  out.surface = read_surface_band(fields);
  for (const char* other : {"error", "spacing", "lag"}) {
    if (fields.has(other)) {
      fields.refuse({.key = other,
                     .expected = fmt::format("none beside {}", kSurfaceBandKey),
                     .found = fmt::to_string(metres(fields, other))});
    }
  }
  return out;
}

void add(geom::JsonLine& line, const SurfaceBand& band) {
  line.add(kSurfaceBandKey, std::array{band.low, band.high});
}

SurfaceBand read_surface_band(const geom::JsonFields& fields) {
  const nlohmann::json& value = fields.value(kSurfaceBandKey);
  SurfaceBand out;
  if (value.is_array() && value.size() == 2) {
    out = {fields.number(value[0], kSurfaceBandKey), fields.number(value[1], kSurfaceBandKey)};
  }
  if (out.sound()) return out;
  fields.refuse(
      {.key = kSurfaceBandKey,
       .expected = fmt::format("[low, high], 0 < low <= high <= {:g}", SurfaceBand::kMost),
       .found = value.dump()});
}

}  // namespace traj
