#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "marked_obstacle.h"

namespace geom::gis {
namespace {

constexpr std::array kBuildings{"yes", "house", "Apartments", "ruins", "roof", "church;yes"};
constexpr std::array kMadeThings{"tower",
                                 "mast",
                                 "chimney",
                                 "crane",
                                 "silo",
                                 "gasometer",
                                 "lighthouse",
                                 "flagpole",
                                 "kiln",
                                 "tower;antenna",
                                 "antenna;mast",
                                 "pier;tower",
                                 "satellite_dish",
                                 "bridge",
                                 "gantry",
                                 "windpump",
                                 "communications_transponder",
                                 "street_lamp",
                                 "ventilation_shaft",
                                 "telescope",
                                 "Tower",
                                 "goods_conveyor",
                                 "offshore_platform",
                                 "statue",
                                 "cross",
                                 "something new"};
constexpr std::array kPower{"tower",         "pole",      "line",      "minor_line", "portal",
                            "catenary_mast", "insulator", "heliostat", "substation", "generator",
                            "line;cable",    "terminal",  "switchgear"};
constexpr std::array kHistoric{"monument", "memorial",      "castle",   "tower",  "city_gate",
                               "ruins",    "wayside_cross", "aqueduct", "obelisk"};
constexpr std::array kAttractions{"big_wheel",   "roller_coaster", "drop_tower",
                                  "water_slide", "bungee_jumping", "swing_carousel"};
constexpr std::array kBridges{"yes", "viaduct", "aqueduct", "movable", "covered", "boardwalk;yes"};
constexpr std::array kAerialways{"gondola", "pylon", "zip_line", "chair_lift", "station", "t-bar"};
constexpr std::array kTowers{"communication", "bell_tower", "observation", "cooling", "lighting"};
constexpr std::array kTelecoms{"antenna", "line", "exchange", "connection_point"};
constexpr std::array kLifecycles{"disused:", "abandoned:", "ruins:", "construction:"};
constexpr std::array kPlain{"artwork_type", "amenity", "leisure", "tourism", "shop", "name"};
constexpr std::array kHeightKeys{"height", "est_height", "min_height", "building:levels"};

Tags thing(geom::SplitMix64& random) {
  switch (random.whole(0, 9)) {
    case 0:
      return {{"power", any_of(kPower, random)}};
    case 1:
      return {{"historic", any_of(kHistoric, random)}};
    case 2:
      return {{"attraction", any_of(kAttractions, random)}};
    case 3:
      return {{"highway", "primary"}, {"bridge", any_of(kBridges, random)}};
    case 4:
      return {{"aerialway", any_of(kAerialways, random)}};
    case 5:
      return {{"tower:type", any_of(kTowers, random)}};
    case 6:
      return {{"telecom", any_of(kTelecoms, random)}};
    case 7:
      return {{"railway", "tram"}, {"electrified", "contact_line"}};
    case 8:
      return {{any_of(kPlain, random), "statue"},
              {any_of(kHeightKeys, random), fmt::format("{}", random.whole(3, 90))}};
    default:
      return {{"man_made", any_of(kMadeThings, random)}};
  }
}

Tags marked_tags(Obstacle& obstacle, geom::SplitMix64& random) {
  Tags tags;
  if (random.chance(0.5)) {
    tags = {{random.chance(0.8) ? "building" : "building:part", any_of(kBuildings, random)}};
    for (auto& tag : height_tags(obstacle, random)) tags.push_back(tag);
  } else {
    tags = thing(random);
    obstacle.no_default = true;
    if (random.chance(0.3)) {
      const double metres = random.whole(12, 900) / 4.0;
      tags.emplace_back("height", spelled(metres, random));
      obstacle.top = metres;
    }
  }
  if (random.chance(0.2)) tags.front().first = any_of(kLifecycles, random) + tags.front().first;
  if (random.chance(0.05)) tags.front().first = " " + tags.front().first;
  if (random.chance(0.3)) tags.emplace_back("name", "no. 5");
  if (random.chance(0.5)) std::reverse(tags.begin(), tags.end());
  return tags;
}

std::string xml(const Tags& tags) {
  std::string out;
  for (const auto& [key, value] : tags) {
    std::string safe;
    for (const char c : value) safe += c == '"' ? "&quot;" : c == '>' ? "&gt;" : std::string(1, c);
    out += fmt::format(R"(<tag k="{}" v="{}"/>)", key, safe);
  }
  return out;
}

struct OsmText {
  std::string nodes;
  std::string ways;
  std::string relations;
  int next = 1;

  std::string node(const geom::Vec2& at, const Tags& tags = {}) {
    const int id = next++;
    nodes += fmt::format(R"(<node id="{}" version="1" lat="{:.7f}" lon="{:.7f}">{}</node>)", id,
                         at.y(), at.x(), xml(tags));
    return fmt::format(R"(<nd ref="{}"/>)", id);
  }
  int way(const Obstacle& square, const Tags& tags, bool closed) {
    std::string refs;
    std::string first;
    for (const geom::Vec2& p : square.corners()) {
      const std::string ref = node(p);
      if (first.empty()) first = ref;
      refs += ref;
    }
    if (closed) refs += first;
    const int id = next++;
    ways += fmt::format(R"(<way id="{}" version="1">{}{}</way>)", id, refs, xml(tags));
    return id;
  }
  void relation(int way, Tags tags, const char* type) {
    if (*type) tags.emplace_back("type", type);
    relations += fmt::format(
        R"(<relation id="{}" version="1"><member type="way" ref="{}" role="outer"/>{}</relation>)",
        next++, way, xml(tags));
  }
  std::string text() const {
    return "<?xml version=\"1.0\"?><osm version=\"0.6\">" + nodes + ways + relations + "</osm>";
  }
};

void add_marked(OsmText& osm, const Obstacle& obstacle, const Tags& tags,
                geom::SplitMix64& random) {
  switch (random.whole(0, 5)) {
    case 0:
      osm.node(obstacle.corner, tags);
      break;
    case 1:
      osm.way(obstacle, tags, false);
      break;
    case 2:
      osm.relation(osm.way(obstacle, {}, true), tags, "multipolygon");
      break;
    case 3:
      osm.relation(osm.way(obstacle, {}, true), tags, random.chance(0.5) ? "site" : "");
      break;
    default:
      osm.way(obstacle, tags, true);
  }
}

TEST(NothingSilent, OpenStreetMap) {
  const std::string path = testing::TempDir() + fmt::format("silent.{}.osm", getpid());
  expect_told(kFiles, [&](int things, int marked, geom::SplitMix64& random) {
    Obstacle obstacle;
    OsmText osm;
    for (int k = 0; k < things; ++k) {
      const Obstacle square{place(k), 0.0002, 0, std::nullopt, false};
      if (k != marked) {
        osm.way(square, {{"building", "yes"}, {"height", "12"}}, true);
        continue;
      }
      obstacle = square;
      const Tags tags = marked_tags(obstacle, random);
      add_marked(osm, obstacle, tags, random);
    }
    std::ofstream(path) << osm.text();
    return Told{is_told(obstacle, [&] { return read_osm(path, "silent.osm", {}); }), osm.text()};
  });
  std::remove(path.c_str());
}

}  // namespace
}  // namespace geom::gis
