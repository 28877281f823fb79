#include "contingency.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geom/text/json_fields.h"

namespace cli {
namespace {

double required_time(const geom::JsonFields& fields, const char* key, double least) {
  const double value = fields.number(fields.value(key), key);
  if (value >= least) return value;
  fields.refuse(
      {.key = key, .expected = fmt::format(">= {}", least), .found = fmt::to_string(value)});
}

// A record without energy has no such key; null says that there is never enough.
double latest_of(const geom::JsonFields& fields, const Contingency& way) {
  if (!way.bounds_energy) return way.until;
  const auto latest = fields.number("latest_departure");
  return latest ? std::min(*latest, way.until) : way.from - 1;
}

}  // namespace

Contingency parse_contingency(std::string_view json, std::string_view source, std::size_t line) {
  const geom::JsonFields fields(json, source, line);
  fields.require_type("contingency");
  Contingency way;
  way.id = fields.text("id");
  way.from = required_time(fields, "from", 0);
  way.until = required_time(fields, "until", way.from);
  way.message = fields.text("message", "");
  way.provenance = geom::read_provenance(fields);
  way.latest = way.until;
  if (fields.text("status", "found") != "found") return way;
  way.site = fields.text("site");
  way.points = fields.points("points");
  if (way.points.empty()) {
    fields.refuse({.key = "points", .expected = "at least one", .found = "none"});
  }
  way.length = fields.number("length");
  way.duration = fields.number("duration");
  way.bounds_energy = fields.object().contains("latest_departure");
  way.latest = latest_of(fields, way);
  return way;
}

}  // namespace cli
