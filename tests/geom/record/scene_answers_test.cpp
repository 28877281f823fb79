#include "geom/record/scene_answers.h"

#include <gtest/gtest.h>

#include "geom/base/usage_error.h"
#include "geom/text/json_fields.h"
#include "support/reading.h"

namespace geom {
namespace {

using support::says;

// A tower around (5, 5) with id 7, a vehicle of 1 m half sizes.
CollisionScene tower(const std::optional<GeodeticOrigin>& origin = {}) {
  BoxTable table;
  table.add({{4, 4, 0}, {6, 6, 8}}, 7);
  BoxMapSpec spec;
  spec.bounds = {{0, 0, 0}, {20, 20, 20}};
  spec.bounds_from = "option";
  spec.frame.origin = origin;
  return {BoxMap(spec, table), Vehicle{"cube", Vec3::Constant(1)}, 0};
}

std::string answer(const std::string& record) {
  const CollisionScene scene = tower();
  return SceneAnswers(scene).answer(record, "q", 3);
}

std::string refusal(const std::string& record) {
  return support::refusal_of([&] { answer(record); });
}

// Of a number in the answer.
double value_of(const std::string& line, const char* key) {
  return *JsonFields(line, "answer", 1).number(key);
}

TEST(SceneAnswers, SaysHitClearanceAndNearestBoxOfAPoint) {
  const std::string free = answer(R"({"id":"a","point":[12,5,4]})");
  EXPECT_EQ(free.find(R"({"type":"answer","id":"a","hit":false,"inside_bounds":true,"clearance":)"),
            0u);
  EXPECT_NEAR(value_of(free, "clearance"), 5, 1e-6);
  EXPECT_EQ(value_of(free, "nearest"), 7);
  EXPECT_EQ(
      answer(R"({"point":[5,5,4]})"),
      R"({"type":"answer","id":"q3","hit":true,"inside_bounds":true,"clearance":0,"nearest":7})"
      "\n");
}

TEST(SceneAnswers, ListsSeveralNearestBoxesIfAsked) {
  EXPECT_TRUE(says(answer(R"({"point":[12,5,4],"k":2})"), R"("nearest":[{"box":7,"distance":)"));
}

TEST(SceneAnswers, SaysWhetherASegmentHits) {
  EXPECT_TRUE(says(answer(R"({"segment":[[1,5,4],[12,5,4]]})"), R"("hit":true)"));
  const std::string free = answer(R"({"segment":[[2,15,4],[12,15,4]],"planes":9,"empty_box":2})");
  EXPECT_TRUE(says(free, R"("hit":false)"));
  EXPECT_TRUE(says(free, R"("planes":[{"box":7)"));
  EXPECT_TRUE(says(free, R"("empty_box":[[)"));
}

TEST(SceneAnswers, NamesTheObstaclesThatABoxMeets) {
  EXPECT_TRUE(says(answer(R"({"box":[[0,0,0],[9,9,9]]})"), R"("hit":true,"boxes":[7])"));
  EXPECT_TRUE(says(answer(R"({"box":[[9,9,9],[10,10,10]]})"), R"("hit":false,"boxes":[])"));
}

TEST(SceneAnswers, SweepsABoxOfOtherHalfSizes) {
  const auto sweep = [](double half) {
    return answer(R"({"sweep":[[1,9,4],[12,9,4]],"half":[)" + std::to_string(half) + ",1,1]}");
  };
  EXPECT_TRUE(says(sweep(0), R"("hit":false)"));
  EXPECT_TRUE(says(answer(R"({"sweep":[[1,9,4],[12,9,4]],"half":[1,3,1]})"), R"("hit":true)"));
}

// A key that is passed over would make the answer one to another question.
TEST(SceneAnswers, RefusesTwoQuestionsAndKeysOfAnotherQuestion) {
  for (const char* const record :
       {R"({"point":[1,2,3],"segment":[[1,2,3],[4,5,6]]})",
        R"({"box":[[1,2,3],[4,5,6]],"sweep":[[1,2,3],[4,5,6]],"half":[1,1,1]})",
        R"({"point":[1,2,3],"half":[1,1,1]})", R"({"point":[1,2,3],"planes":3})",
        R"({"segment":[[1,2,3],[4,5,6]],"half":[9,9,9]})", R"({"segment":[[1,2,3],[4,5,6]],"k":2})",
        R"({"box":[[1,2,3],[4,5,6]],"empty_box":2})",
        R"({"sweep":[[1,2,3],[4,5,6]],"half":[1,1,1],"k":2})"}) {
    EXPECT_FALSE(refusal(record).empty()) << record;
  }
  EXPECT_TRUE(says(refusal(R"({"point":[1,2,3],"half":[1,1,1]})"),
                   R"("half" is only for "sweep", and would change nothing beside "point")"));
}

TEST(SceneAnswers, RefusesARecordOfAnotherMapFrameVehicleOrMargin) {
  for (const char* const asked_of : {R"("map":"sha256:1")", R"("frame":"neu")", R"("margin":3)",
                                     R"("vehicle":{"half":[2,1,1]})"}) {
    const std::string record = std::string(R"({"point":[12,5,4],)") + asked_of + "}";
    EXPECT_TRUE(says(refusal(record), "made for another")) << record;
  }
  EXPECT_TRUE(says(answer(R"({"point":[12,5,4],"frame":"enu","margin":0,)"
                          R"("vehicle":{"name":"x","half":[1,1,1]}})"),
                   R"("hit":false)"));
}

TEST(SceneAnswers, RefusesARecordThatIsMalformed) {
  EXPECT_EQ(refusal(R"({"id":"a"})").find("q:3: "), 0u);
  for (const char* const record :
       {R"({"point":[1,2]})", R"({"point":[1,2,3],"k":0})", R"({"point":[1,2,3],"k":1.5})",
        R"({"segment":[[1,2,3]]})", R"({"segment":[[1,2,3],[4,5,6]],"planes":-1})",
        R"({"box":[[1,2,3],[0,5,6]]})", R"({"sweep":[[1,2,3],[4,5,6]],"half":[-1,0,0]})",
        R"({"point":"nowhere"})"}) {
    EXPECT_NE(refusal(record), "") << record;
  }
}

TEST(SceneAnswers, SaysThePlaceOfAPointOnEarth) {
  const CollisionScene scene = tower(GeodeticOrigin{60, 25, 0});
  const std::string said = SceneAnswers(scene, true).answer(R"({"point":[0,0,0]})", "q", 1);
  EXPECT_TRUE(says(said, R"("place":"60.0000000N,25.0000000E")"));
  const CollisionScene nowhere = tower();
  EXPECT_THROW(SceneAnswers(nowhere, true), UsageError);
}

TEST(PointsAsked, AreThoseInMetresAndNoneOfWhatIsMalformed) {
  EXPECT_EQ(points_asked(R"({"point":[1,2,3]})"), std::vector<Vec3>{Vec3(1, 2, 3)});
  EXPECT_EQ(points_asked(R"({"segment":[[1,2,3],[4,5,6]]})").size(), 2u);
  EXPECT_TRUE(points_asked(R"({"point":"60N,25E,3"})").empty());
  EXPECT_TRUE(points_asked(R"({"point":[1,2]})").empty());
  EXPECT_TRUE(points_asked("{").empty());
}

}  // namespace
}  // namespace geom
