#include "traj/record/corridor_record.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "support/reading.h"

namespace traj {
namespace {

std::string refusal(const std::string& pieces) {
  return support::refusal_of([&] {
    parse_corridor_record(R"({"type":"corridor","id":"a","pieces":)" + pieces + "}", "c.jsonl", 2);
  });
}

TEST(CorridorShape, ReadsWhatWasWritten) {
  // Between x = -1 and x = 2, else as far as the reach of 3 m.
  const Corridor corridor = {{{0, 0, 0}, {1, 0, 0}, {{Vec3::UnitX(), 2}, {-Vec3::UnitX(), 1}}}};
  const std::string line = to_json_line("q1", {.margin = 0.5}, corridor, 3);
  const CorridorShape shape = parse_corridor_record(line, "c.jsonl", 1);
  EXPECT_EQ(shape.id, "q1");
  EXPECT_EQ(shape.provenance.margin, 0.5);
  ASSERT_EQ(shape.pieces.size(), 1u);
  const CorridorShape::Piece& box = shape.pieces[0];
  EXPECT_EQ(box.vertices.size(), 8u);
  EXPECT_EQ(box.faces.size(), 6u);
  for (const Vec3& v : box.vertices) {
    EXPECT_TRUE(v.x() == -1 || v.x() == 2) << v.transpose();
    EXPECT_NEAR(std::abs(v.y()), 3, 1e-12);
    EXPECT_NEAR(std::abs(v.z()), 3, 1e-12);
  }
  for (const auto& face : box.faces) EXPECT_EQ(face.size(), 4u);
  EXPECT_TRUE(parse_corridor_record(to_json_line("e", {}, {}, 3), "c.jsonl", 1).pieces.empty());
}

TEST(CorridorShape, RefusesWhatIsNoCorridor) {
  EXPECT_EQ(refusal("[]"), "");
  EXPECT_EQ(refusal("3"), "c.jsonl:2: pieces must be a list, found none");
  EXPECT_EQ(refusal("[1]"), "c.jsonl:2: pieces[0].vertices must be a list, found none");
  EXPECT_EQ(refusal(R"([{"vertices":[]}])"),
            "c.jsonl:2: pieces[0].faces must be a list, found none");
  EXPECT_EQ(refusal(R"([{"vertices":[[0,0,0]],"faces":[[0,0]]}])"),
            "c.jsonl:2: pieces[0].faces must be a list of at least 3 vertices, found [0,0]");
  EXPECT_EQ(refusal(R"([{"vertices":[[0,0,0]],"faces":[[0,0,1]]}])"),
            "c.jsonl:2: pieces[0].faces must name vertices from 0 to below 1, found 1");
  EXPECT_NE(refusal(R"([{"vertices":[[0,0]],"faces":[]}])"), "");
}

}  // namespace
}  // namespace traj
