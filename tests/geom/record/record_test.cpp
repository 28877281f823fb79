#include "geom/record/record.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "geom/text/json_fields.h"
#include "support/reading.h"

namespace geom {
namespace {

std::string refusal(const std::string& extra) {
  return support::refusal_of([&] {
    parse_path_record(R"({"type":"path","id":"a","points":[[0,0,0],[1,0,0]],)" + extra + "}", "p",
                      1);
  });
}

TEST(PathRecord, CarriesHoldsAndVelocitiesThereAndBack) {
  PathRecord record;
  record.id = "a";
  record.status = geom::PathStatus::found;
  record.points = {Vec3(0, 0, 0), Vec3(1, 0, 0)};
  record.hold = {0, 2.5};
  record.velocity = {Vec3(0.1, 0, -1), std::nullopt};
  const std::string line = to_json_line(record);
  EXPECT_TRUE(support::says(line, R"("hold":[0,2.5],"velocity":[[0.1,0,-1],null]})"));
  const PathRecord back = parse_path_record(line, "p", 1);
  EXPECT_EQ(back.hold, record.hold);
  EXPECT_EQ(back.velocity, record.velocity);
  EXPECT_EQ(to_json_line(back), line);
}

TEST(PathRecord, RefusesMarginsThatNoSceneHolds) {
  EXPECT_EQ(refusal(R"("margin":1e154)"), "p:1: margin must be within 1e8 m, found 1e+154");
  EXPECT_EQ(refusal(R"("margin":-1)"), "p:1: margin must be >= 0, found -1");
}

TEST(PathRecord, RefusesHoldsAndVelocitiesThatCannotBe) {
  EXPECT_EQ(refusal(R"("hold":[1])"), "p:1: hold must be a list of 2, one a point, found 1");
  EXPECT_EQ(refusal(R"("hold":[0,-1])"), "p:1: hold[1] must be >= 0 s, found -1");
  EXPECT_EQ(refusal(R"("velocity":3)"), "p:1: velocity must be a list of 2, one a point, found 3");
  EXPECT_EQ(refusal(R"("hold":[0,1],"velocity":[null,[1,0,0]])"),
            "p:1: velocity[1] must be zero or null where the path holds, found [1,0,0]");
}

TEST(Provenance, IsWhatARecordSaysOfIt) {
  const auto read = [](const std::string& json) {
    return read_provenance(JsonFields(json, "r.jsonl", 7));
  };
  const Provenance none = read("{}");
  EXPECT_FALSE(none.map || none.frame || none.vehicle || none.margin);
  const Provenance all = read(R"({"map":"sha256:1","frame":"neu","margin":0.5,)"
                              R"("vehicle":{"name":"quad","half":[1,2,0],"limits":{"vmax":8}}})");
  EXPECT_EQ(all.map, "sha256:1");
  EXPECT_EQ(all.frame, Axes::neu);
  EXPECT_EQ(all.margin, 0.5);
  EXPECT_EQ(all.vehicle, (Vehicle{"quad", {1, 2, 0}, {{Limit::speed, 8}}}));
  for (const auto& [json, named] :
       {std::pair(R"({"frame":"ned"})", "frame"), std::pair(R"({"vehicle":{}})", "vehicle"),
        std::pair(R"({"vehicle":{"half":[1,-1,1]}})", "vehicle.half"),
        std::pair(R"({"margin":-1})", "margin"), std::pair(R"({"margin":1e9})", "margin")}) {
    const std::string said = support::refusal_of([&] { read(json); });
    EXPECT_TRUE(said.starts_with("r.jsonl:7: ")) << json << ": " << said;
    EXPECT_TRUE(support::says(said, named)) << json << ": " << said;
  }
}

}  // namespace
}  // namespace geom
