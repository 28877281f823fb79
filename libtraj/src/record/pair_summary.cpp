#include "traj/record/pair_summary.h"

#include <fmt/format.h>

#include <cstdint>
#include <nlohmann/json.hpp>

#include "geom/text/json_fields.h"

namespace traj {
namespace {

bool ok_of(const geom::JsonFields& fields) {
  const nlohmann::json& value = fields.value("ok");
  if (!value.is_boolean()) {
    fields.refuse({.key = "ok", .expected = "true or false", .found = value.dump()});
  }
  return value.get<bool>();
}

double number(const geom::JsonFields& fields, const char* key) {
  const auto value = fields.number(key);
  if (!value) fields.refuse({.expected = fmt::format("a number as \"{}\"", key), .found = "none"});
  return *value;
}

std::size_t count(const geom::JsonFields& fields, const char* key) {
  const nlohmann::json& value = fields.value(key);
  if (!value.is_number_unsigned()) {
    fields.refuse(
        {.key = std::string(key), .expected = "a whole number >= 0", .found = value.dump()});
  }
  return value.get<std::uint64_t>();
}

// The zone under that key: {"shape":"cylinder" or "box","reach":[x,y,z]}. Nothing without the key,
// and where a word stands there instead ("vehicles").
std::optional<Zone> zone_of(const geom::JsonFields& fields, const char* key) {
  if (!fields.has(key) || fields.value(key).is_string()) return {};
  const nlohmann::json& zone = fields.value(key);
  const auto refuse = [&] {
    fields.refuse({.key = std::string(key),
                   .expected = "a cylinder or a box with its reach",
                   .found = zone.dump()});
  };
  const nlohmann::json reach = zone.is_object() ? zone.value("reach", nlohmann::json()) : zone;
  if (!reach.is_array() || reach.size() != 3) refuse();
  Zone out{zone.value("shape", nlohmann::json()) == "cylinder", {}};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!reach[i].is_number()) refuse();
    out.reach[static_cast<Eigen::Index>(i)] = reach[i].get<double>();
  }
  return out;
}

}  // namespace

PairSummary parse_pair_record(std::string_view json, std::string_view source, std::size_t line) {
  const geom::JsonFields fields(json, source, line);
  fields.require_type("pair");
  const nlohmann::json& ids = fields.value("ids");
  if (!ids.is_array() || ids.size() != 2 || !ids[0].is_string() || !ids[1].is_string()) {
    fields.refuse({.key = "ids", .expected = "the ids of two flights", .found = ids.dump()});
  }
  if (ok_of(fields))
    fields.refuse({.expected = "a pair that was refused", .found = "one with ok true"});
  PairSummary pair;
  pair.first = ids[0].get<std::string>();
  pair.second = ids[1].get<std::string>();
  pair.reason = fields.text("reason");
  pair.time = number(fields, "time");
  pair.share = number(fields, "share");
  pair.across = number(fields, "across");
  pair.up = number(fields, "up");
  pair.zone = zone_of(fields, "zone");
  return pair;
}

TogetherSummary parse_together_record(std::string_view json, std::string_view source,
                                      std::size_t line) {
  const geom::JsonFields fields(json, source, line);
  fields.require_type("together");
  TogetherSummary all;
  all.ok = ok_of(fields);
  all.flights = count(fields, "flights");
  all.pairs = count(fields, "pairs");
  all.refused = count(fields, "refused");
  if (fields.has("left_out")) all.left_out = count(fields, "left_out");
  all.overridden = fields.has("overridden");
  if (fields.has("map")) all.map = fields.text("map");
  all.separation = zone_of(fields, "separation");
  all.flights_hash = fields.text("flights_hash");
  if (all.ok && (all.refused > 0 || all.left_out > 0)) {
    fields.refuse({.says = fmt::format("ok is true beside {} refused pairs and {} flights left out",
                                       all.refused, all.left_out)});
  }
  return all;
}

}  // namespace traj
