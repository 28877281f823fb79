#include "osm_obstacle.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

#include "geom/import/building_height.h"
#include "geom/text/text_table.h"
#include "import/written_height.h"

namespace geom::gis {
namespace {

// Values of a key.
struct Words {
  std::string_view key;
  std::array<std::string_view, 16> values;  // the last ones may be empty

  bool has(std::string_view value) const {
    return !value.empty() && std::find(values.begin(), values.end(), value) != values.end();
  }
};

// Of these keys every value is an obstacle but what is flat.
constexpr std::array<std::string_view, 11> kObstacles{
    "man_made", "power",      "aerialway",   "bridge",         "tower:type", "telecom",
    "historic", "attraction", "electrified", "bridge:support", "airmark"};

constexpr std::array kFlat{Words{"man_made",
                                 {"clearcut", "courtyard", "cutline", "geoglyph", "manhole", "pier",
                                  "pipeline", "quay", "survey_point"}},
                           Words{"power", {"cable"}},
                           Words{"telecom", {"cable"}},
                           Words{"historic", {"battlefield", "district", "event"}},
                           Words{"attraction", {"boat_ride", "river_rafting"}},
                           Words{"electrified", {"rail", "4th_rail", "ground-level_power_supply"}}};

// Obstacles by keys of which most values are none.
constexpr std::array kOthers{
    Words{"natural", {"tree", "tree_row", "tree_group", "wood", "arch", "rock", "stone"}},
    Words{"landuse", {"forest", "orchard"}},
    Words{"landcover", {"trees"}},
    Words{"highway",
          {"street_lamp", "gantry", "toll_gantry", "traffic_signals", "speed_camera", "elevator"}},
    Words{"railway",
          {"monorail", "signal", "signal_box", "gantry", "catenary_mast", "water_tower",
           "water_crane", "coaling_facility"}},
    Words{"aeroway",
          {"hangar", "terminal", "control_tower", "tower", "navigationaid", "windsock",
           "jet_bridge", "launchpad", "launch_complex", "beacon"}},
    Words{"parking", {"multi-storey"}},
    Words{"roller_coaster", {"track", "support", "station"}},
    Words{"waterway", {"dam", "lock_gate", "sluice_gate", "boat_lift"}},
    Words{"military", {"bunker", "launchpad"}},
    Words{"leisure",
          {"bandstand", "bleachers", "stadium", "grandstand", "ski_jump", "sports_hall",
           "bird_hide", "wildlife_hide", "high_ropes_course"}},
    Words{"piste:type", {"ski_jump"}},
    Words{"playground", {"structure", "slide", "climbingframe", "zipwire", "aerialrotator"}},
    Words{"amenity", {"shelter", "hunting_stand", "clock", "fountain", "grandstand"}},
    Words{"lifeguard", {"tower"}},
    Words{"emergency", {"siren", "lifeguard_tower", "fire_lookout"}},
    Words{"barrier",
          {"wall", "city_wall", "fence", "hedge", "retaining_wall", "height_restrictor",
           "toll_booth", "lift_gate", "border_control"}},
    Words{"tourism", {"artwork"}},
    Words{"advertising", {"billboard", "column", "screen", "totem", "sculpture", "sign", "flag"}},
    Words{"seamark:type",
          {"landmark", "platform", "pile", "bridge", "cable_overhead", "pipeline_overhead", "light",
           "light_major", "light_minor", "light_vessel", "light_float", "daymark", "radar_station",
           "radio_station", "signal_station_traffic", "signal_station_warning"}},
    Words{"seamark:type",
          {"beacon_lateral", "beacon_cardinal", "beacon_isolated_danger", "beacon_safe_water",
           "beacon_special_purpose", "buoy_lateral", "buoy_cardinal", "buoy_isolated_danger",
           "buoy_safe_water", "buoy_special_purpose", "buoy_installation", "hulk", "gate", "crane",
           "tower", "wreck"}},
    Words{"generator:source", {"wind"}}};

// What stands on an area, beside buildings.
constexpr std::array kBuilt{Words{
    "man_made",
    {"tower", "mast", "water_tower", "communications_tower", "cooling_tower", "chimney", "crane",
     "silo", "storage_tank", "gasometer", "lighthouse", "windmill", "antenna", "obelisk"}}};

constexpr std::array kHighLines{
    Words{"power", {"tower", "pole", "line", "minor_line", "portal", "catenary_mast"}},
    Words{"generator:source", {"wind"}}};

constexpr std::array kHeights{"building:levels:aboveground",
                              "height",
                              "est_height",
                              "min_height",
                              "building:height",
                              "building:levels",
                              "building:min_level",
                              "roof:height",
                              "roof:levels"};

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return out;
}

bool is_none(std::string_view value) { return value.empty() || value == "no" || value == "none"; }

std::optional<std::string> first_of(const OsmTags& tags, std::span<const Words> table) {
  for (const Words& words : table) {
    for (const std::string_view value : words.values) {
      if (!value.empty() && tags.has(words.key, value)) {
        return fmt::format("{}={}", words.key, value);
      }
    }
  }
  return std::nullopt;
}

// Flat, or hardly so high as a person; not where it says that it is above the ground.
bool is_flat(const OsmTags& tags, std::string_view key, std::string_view value) {
  if (tags.has("location", "overhead") || tags.has("location", "overground")) return false;
  if (key == "power" && value == "generator") return tags.has("generator:source", "solar");
  return std::any_of(kFlat.begin(), kFlat.end(),
                     [&](const Words& words) { return words.key == key && words.has(value); });
}

// The first value of the key that is not flat.
std::optional<std::string> first_high(const OsmTags& tags, std::string_view key) {
  for (const std::string& value : tags.values(key)) {
    if (!is_none(value) && !is_flat(tags, key, value)) return fmt::format("{}={}", key, value);
  }
  return std::nullopt;
}

// A height of 0 and below tells nothing.
bool has_height(const OsmTags& tags) {
  for (const char* key : kHeights) {
    const std::string text = tags.text(key);
    if (is_none(text)) continue;
    const auto height = parse_highest(text);
    if (!height || *height > 0) return true;
  }
  return false;
}

}  // namespace

void OsmTags::add(std::string_view key, std::string_view value) {
  std::string plain = lower(trimmed(key));
  for (bool again = true; again;) {
    again = false;
    for (const std::string_view prefix : {"disused:", "abandoned:", "ruins:", "construction:"}) {
      if (!plain.starts_with(prefix)) continue;
      plain.erase(0, prefix.size());
      again = true;
    }
  }
  tags_.push_back({std::move(plain), std::string(value)});
}

std::string OsmTags::text(std::string_view key) const {
  std::string out;
  for (const Tag& tag : tags_) {
    if (is_attribute(tag.key, key)) add_value(tag.text, out);
  }
  return out;
}

std::vector<std::string> OsmTags::values(std::string_view key) const {
  std::vector<std::string> out;
  for (const Tag& tag : tags_) {
    if (tag.key != key) continue;
    for (std::string_view rest = tag.text; !rest.empty();) {
      const std::size_t end = std::min(rest.find(';'), rest.size());
      out.push_back(lower(trimmed(rest.substr(0, end))));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  return out;
}

bool OsmTags::has(std::string_view key, std::string_view value) const {
  const std::vector<std::string> all = values(key);
  return std::find(all.begin(), all.end(), value) != all.end();
}

bool is_built(const OsmTags& tags) { return !type_of_built(tags).empty(); }

std::string type_of_built(const OsmTags& tags) {
  for (const char* key : {"building", "building:part"}) {
    if (first_high(tags, key)) return key;
  }
  const auto other = first_of(tags, kBuilt);
  return other ? other->substr(other->find('=') + 1) : "";
}

bool is_high_line(const OsmTags& tags) {
  return first_of(tags, kHighLines) || first_high(tags, "aerialway");
}

std::optional<std::string> other_obstacle(const OsmTags& tags) {
  auto kind = first_of(tags, kOthers);
  for (auto key = kObstacles.rbegin(); key != kObstacles.rend(); ++key) {
    if (auto high = first_high(tags, *key)) kind = high;
  }
  if (has_height(tags)) return kind.value_or("thing") + " with a height";
  return kind;
}

}  // namespace geom::gis
