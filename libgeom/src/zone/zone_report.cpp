#include "geom/zone/zone_report.h"

#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "geom/text/json_fields.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

using Json = nlohmann::ordered_json;

// An end that is open is null.
Json end_json(double at) { return std::isfinite(at) ? Json(at) : Json(); }

Json zone_json(const ListedZone& zone) {
  Json out = {{"identifier", zone.identifier}};
  if (!zone.name.empty()) out["name"] = zone.name;
  out["type"] = name(zone.type);
  out["boxes"] = zone.boxes;
  if (zone.times != std::vector<TimeSpan>{TimeSpan{}}) {
    Json times = Json::array();
    for (const TimeSpan& t : zone.times) times.push_back({end_json(t.from), end_json(t.until)});
    out["times"] = times;
  }
  if (!zone.authority.empty()) out["authority"] = zone.authority;
  if (!zone.message.empty()) out["message"] = zone.message;
  return out;
}

double end_of(const Json& json, double open) {
  return json.is_number() ? json.get<double>() : open;
}

ListedZone zone_of(const Json& json) {
  const JsonFields fields(json.dump(), "the map's history", 0);
  ListedZone out;
  out.identifier = fields.text("identifier");
  out.name = fields.text("name", "");
  out.type = fields.word("type", kZoneTypeWords, ZoneType::prohibited);
  out.boxes = static_cast<std::size_t>(fields.number("boxes").value_or(0));
  out.authority = fields.text("authority", "");
  out.message = fields.text("message", "");
  if (!json.contains("times")) {
    out.times = {TimeSpan{}};
    return out;
  }
  for (const Json& span : json["times"]) {
    if (!span.is_array() || span.size() != 2) {
      fields.refuse({.key = "times", .expected = "pairs of times", .found = shown(span)});
    }
    out.times.push_back({end_of(span[0], TimeSpan{}.from), end_of(span[1], TimeSpan{}.until)});
  }
  return out;
}

ZoneSource source_of(const Json& json) {
  const JsonFields fields(json.dump(), "the map's history", 0);
  ZoneSource out;
  out.file = fields.text("file");
  out.hash = fields.text("hash");
  out.format = fields.text("format", "");
  out.title = fields.text("title", "");
  out.issued = fields.text("issued", "");
  out.valid_to = fields.text("valid_to", "");
  out.zones_read = static_cast<std::size_t>(fields.number("read").value_or(0));
  if (json.contains("near")) {
    for (const Json& zone : json["near"]) out.zones.push_back(zone_of(zone));
  }
  return out;
}

// Boxes that are removed later may be those of a zone: nothing tells them apart.
bool removes(const Json& step) {
  return step.contains("removed") && step["removed"].is_number() && step["removed"] > 0;
}

std::vector<ZoneSource> collected(const Json& steps) {
  std::vector<ZoneSource> out;
  if (!steps.is_array()) return out;
  for (const Json& step : steps) {
    if (!step.is_object()) continue;
    if (removes(step)) out.clear();
    if (step.contains("zones") && step["zones"].is_object()) {
      out.push_back(source_of(step["zones"]));
    }
    if (!step.contains("histories") || !step["histories"].is_array()) continue;
    for (const Json& other : step["histories"]) {
      std::vector<ZoneSource> more = collected(other);
      std::move(more.begin(), more.end(), std::back_inserter(out));
    }
  }
  return out;
}

}  // namespace

ZoneSource zone_source(const ZoneFile& file, const ZoneBoxes& boxes) {
  ZoneSource out;
  out.format = file.format;
  out.title = file.title;
  out.issued = file.issued.value_or("");
  out.valid_to = file.valid_to.value_or("");
  out.zones_read = file.zones.size();
  for (const NearZone& near : boxes.near) {
    const Zone& zone = file.zones[near.index];
    out.zones.push_back({zone.identifier, zone.name, zone.type, near.boxes, near.times,
                         zone.authority, zone.message});
  }
  return out;
}

Json to_json(const ZoneSource& source) {
  Json out = {{"file", source.file}, {"hash", source.hash}, {"format", source.format}};
  if (!source.title.empty()) out["title"] = source.title;
  if (!source.issued.empty()) out["issued"] = source.issued;
  if (!source.valid_to.empty()) out["valid_to"] = source.valid_to;
  out["read"] = source.zones_read;
  Json zones = Json::array();
  for (const ListedZone& zone : source.zones) zones.push_back(zone_json(zone));
  out["near"] = zones;
  return out;
}

std::vector<ZoneSource> zone_sources(const BoxMapSpec& spec) {
  if (spec.history.empty()) return {};
  return collected(parse_ordered_json(spec.history, "the map's history"));
}

}  // namespace geom
