#include "plan/bound/bound_record.h"

#include <gtest/gtest.h>

#include <limits>

namespace plan {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

BoundRecord some_record() {
  BoundRecord record{"q", {0, 0, 0}, {9, 0, 0}, 9.5, {}, {{0, 0, 0}, {9, 9, 9}}, {}};
  const LengthProof::Part end{{0, 0, 0}, {0, 0, 0}};
  const LengthProof::Part corner{{4, 4, 4}, {4, 4, 4}, 3, {}, 1};
  const LengthProof::Part edge{{5, 1, 0}, {5, 1, 4}, 2, {1, -1}, 3};
  LengthProof::Level level;
  level.parts = {end, end, corner, edge};
  level.come = {{0, 0, kNone, kNone},
                {kNone, kNone, kNone, kNone},
                {4, 4, kNone, kNone},
                {1, 2, kNone, kNone}};
  level.hidden = {{0, 1, 0}, {0, 3, 0}, {2, 3, 0}};
  record.proof.levels = {level, level};
  record.proof.levels[1].go = level.come;
  record.proof.occluders = {{{1, 2, 3}, {4, 5, 6}}};
  return record;
}

TEST(BoundRecord, HasALineForEachStateAndARowForEachPartThatHides) {
  const std::string line = to_json_line(some_record());
  const auto has = [&](const char* text) { return line.find(text) != std::string::npos; };
  EXPECT_TRUE(has(R"("type":"bound","id":"q")"));
  EXPECT_TRUE(has(R"("from":[0,0,0],"to":[9,0,0],"bound":9.5,"occluders":[[[1,2,3],[4,5,6]]])"));
  EXPECT_TRUE(has(R"("levels":[{"parts":[[4,4,4],[5,1,0,4,2,1,-1]],)"));
  EXPECT_TRUE(has(R"("come":[[0,0,null],[null,null],[4,4,null],[1,2,null]],)"));
  EXPECT_TRUE(has(R"("hidden":[[0,1,0,3,0],[2,3,0]]})"));
  EXPECT_TRUE(has(R"({"parts":[[1],[3,0,4]],)"));
  EXPECT_TRUE(has(R"("go":[[0,0,null],)"));
  EXPECT_EQ(line.back(), '\n');
}

TEST(BoundRecord, OfAStraightLineHasNoLevels) {
  BoundRecord record = some_record();
  record.proof = {};
  EXPECT_NE(to_json_line(record).find(R"("occluders":[],"levels":[])"), std::string::npos);
}

}  // namespace
}  // namespace plan
