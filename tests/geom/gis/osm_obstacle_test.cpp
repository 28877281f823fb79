#include "gis/osm_obstacle.h"

#include <gtest/gtest.h>

#include <utility>

namespace geom::gis {
namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

OsmTags tags(const Pairs& pairs) {
  OsmTags out;
  for (const auto& [key, value] : pairs) out.add(key, value);
  return out;
}

std::string kind(const Pairs& pairs) { return other_obstacle(tags(pairs)).value_or("nothing"); }

TEST(OsmObstacle, IsEveryValueThatIsNotKnownToBeFlat) {
  for (const char* key : {"man_made", "power", "aerialway", "bridge", "tower:type", "telecom",
                          "historic", "attraction", "electrified", "bridge:support", "airmark"}) {
    EXPECT_EQ(kind({{key, "what nobody has listed"}}),
              std::string(key) + "=what nobody has listed");
    EXPECT_EQ(kind({{key, "no"}}), "nothing");
    EXPECT_EQ(kind({{key, ""}}), "nothing");
  }
  EXPECT_EQ(kind({{"historic", "monument"}}), "historic=monument");
  EXPECT_EQ(kind({{"electrified", "contact_line"}}), "electrified=contact_line");
  EXPECT_EQ(kind({{"bridge", "aqueduct"}}), "bridge=aqueduct");
  EXPECT_EQ(kind({{"man_made", "pier"}}), "nothing");
  EXPECT_EQ(kind({{"power", "cable"}}), "nothing");
  EXPECT_EQ(kind({{"electrified", "rail"}}), "nothing");
  EXPECT_EQ(kind({{"highway", "footway"}}), "nothing");
}

TEST(OsmObstacle, IsWhatIsNoBuildingByItsTags) {
  for (const auto& [key, value] : Pairs{{"aeroway", "hangar"},
                                        {"aeroway", "terminal"},
                                        {"parking", "multi-storey"},
                                        {"railway", "monorail"},
                                        {"railway", "signal"},
                                        {"roller_coaster", "track"},
                                        {"waterway", "dam"},
                                        {"amenity", "shelter"},
                                        {"amenity", "hunting_stand"},
                                        {"aeroway", "jet_bridge"},
                                        {"seamark:type", "landmark"},
                                        {"seamark:type", "beacon_lateral"},
                                        {"piste:type", "ski_jump"},
                                        {"leisure", "stadium"},
                                        {"leisure", "grandstand"},
                                        {"highway", "traffic_signals"},
                                        {"lifeguard", "tower"}}) {
    EXPECT_EQ(kind({{key, value}}), key + "=" + value);
  }
  EXPECT_EQ(kind({{"aeroway", "runway"}}), "nothing");
  EXPECT_EQ(kind({{"railway", "rail"}}), "nothing");
  EXPECT_EQ(kind({{"seamark:type", "cable_submarine"}}), "nothing");
  EXPECT_EQ(kind({{"piste:type", "nordic"}}), "nothing");
}

TEST(OsmObstacle, IsWhatHasAHeight) {
  for (const char* key :
       {"height", "est_height", "min_height", "building:levels", "building:levels:aboveground"}) {
    EXPECT_EQ(kind({{"artwork_type", "statue"}, {key, "11.7"}}), "thing with a height") << key;
    EXPECT_EQ(kind({{key, "very"}}), "thing with a height") << key;
  }
  EXPECT_EQ(kind({{"man_made", "pier"}, {"height", "3 m"}}), "thing with a height");
  EXPECT_EQ(kind({{"historic", "memorial"}, {"height", "11.7"}}),
            "historic=memorial with a height");
  EXPECT_EQ(kind({{"height", "0"}}), "nothing");
}

TEST(OsmObstacle, StandsWhereItIsDisusedOrBeingBuilt) {
  for (const char* prefix :
       {"disused:", "abandoned:", "ruins:", "construction:", "disused:construction:"}) {
    EXPECT_EQ(kind({{std::string(prefix) + "man_made", "gantry"}}), "man_made=gantry");
    EXPECT_TRUE(is_built(tags({{std::string(prefix) + "building", "yes"}})));
    EXPECT_TRUE(is_high_line(tags({{std::string(prefix) + "power", "line"}})));
  }
  EXPECT_EQ(kind({{"demolished:man_made", "gantry"}}), "nothing");
  EXPECT_EQ(kind({{"proposed:bridge", "yes"}}), "nothing");
}

TEST(OsmObstacle, IsAnyValueOfAList) {
  EXPECT_TRUE(is_built(tags({{"man_made", "tower;antenna"}})));
  EXPECT_TRUE(is_built(tags({{"man_made", "pier; lighthouse"}})));
  EXPECT_EQ(kind({{"man_made", "pier;flagpole"}}), "man_made=flagpole");
  EXPECT_TRUE(is_high_line(tags({{"power", "cable;line"}})));
  EXPECT_EQ(kind({{"natural", "rock;tree"}}), "natural=tree");
}

TEST(OsmObstacle, IsReadInAnyCase) {
  EXPECT_TRUE(is_built(tags({{"Building", "Yes"}})));
  EXPECT_TRUE(is_built(tags({{" man_made ", "TOWER"}})));
  EXPECT_FALSE(is_built(tags({{"building", "No"}})));
  EXPECT_EQ(kind({{"BRIDGE", "Viaduct"}}), "bridge=viaduct");
}

TEST(OsmObstacle, IsNotFlatAboveTheGround) {
  EXPECT_EQ(kind({{"man_made", "pipeline"}}), "nothing");
  EXPECT_EQ(kind({{"man_made", "pipeline"}, {"location", "overhead"}}), "man_made=pipeline");
  EXPECT_EQ(kind({{"power", "generator"}, {"generator:source", "solar"}}), "nothing");
  EXPECT_EQ(kind({{"power", "generator"}, {"generator:source", "gas"}}), "power=generator");
}

TEST(OsmObstacle, HasATypeWhereItIsBuilt) {
  const auto type = [](std::string_view key, std::string_view value) {
    OsmTags tags;
    tags.add(key, value);
    EXPECT_EQ(is_built(tags), !type_of_built(tags).empty());
    return type_of_built(tags);
  };
  EXPECT_EQ(type("building", "yes"), "building");
  EXPECT_EQ(type("disused:building:part", "roof"), "building:part");
  EXPECT_EQ(type("man_made", "chimney"), "chimney");
  EXPECT_EQ(type("man_made", "pier"), "");
  EXPECT_EQ(type("building", "no"), "");
}

TEST(OsmTags, GiveTheTextsOfAKeyTogether) {
  const OsmTags both = tags({{"height", "5"}, {"construction:height", "40 m"}});
  EXPECT_EQ(both.text("height"), "5;40 m");
  EXPECT_EQ(both.text("HEIGHT"), "5;40 m");
  EXPECT_EQ(both.text("name"), "");
}

}  // namespace
}  // namespace geom::gis
