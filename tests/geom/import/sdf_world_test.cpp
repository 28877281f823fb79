#include "geom/import/sdf_world.h"

#include <gtest/gtest.h>

#include "support/reading.h"
#include "support/sdf_text.h"

namespace geom {
namespace {

using support::sdf;
using support::sdf_box;
using support::sdf_model;

SdfWorld read(const std::string& inside, const SdfOptions& options = {}) {
  return read_sdf_world(support::Text(sdf(inside)), "w", options);
}

std::string plane(const std::string& pose, const std::string& kind = "collision") {
  return "<model name='g'><static>1</static><pose>" + pose + "</pose><link name='l'><" + kind +
         " name='c'><geometry><plane><normal>0 0 1</normal><size>50 "
         "50</size></plane></geometry></" +
         kind + "></link></model>";
}

std::string link(const std::string& inside) {
  return "<model name='m'><static>1</static><link name='l'>" + inside + "</link></model>";
}

std::string part(const std::string& kind, const std::string& geometry) {
  return "<" + kind + " name='p'><geometry>" + geometry + "</geometry></" + kind + ">";
}

TEST(SdfWorld, IsABoxALinkWithoutPosesToo) {
  const SdfWorld out =
      read(sdf_model("a", "", sdf_box("2 4 6")) + sdf_model("b", "10 0 3 0 0 0", sdf_box("1 1 0")));
  ASSERT_EQ(out.table.boxes.size(), 2u);
  EXPECT_EQ(out.table.boxes[0], (Aabb{{-1, -2, -3}, {1, 2, 3}}));
  EXPECT_EQ(out.table.boxes[1], (Aabb{{9.5, -0.5, 3}, {10.5, 0.5, 3}}));
  EXPECT_EQ(out.table.ids, (std::vector<std::uint64_t>{0, 1}));
  EXPECT_EQ(out.table.labels, (std::vector<std::string>{"", "a", "b"}));
  EXPECT_EQ(out.flat, 1u);
  EXPECT_FALSE(out.floor);
}

TEST(SdfWorld, TakesWhatIsSeenBesidesWhatCollides) {
  const std::string same =
      link(part("collision", sdf_box("1 1 1")) + part("visual", sdf_box("1 1 1")));
  EXPECT_EQ(read(same).table.boxes.size(), 1u) << "the same box is there once";
  const std::string wider =
      link(part("collision", sdf_box("1 1 1")) + part("visual", sdf_box("3 1 1")));
  EXPECT_EQ(read(wider).table.boxes.size(), 2u);
  SdfOptions collisions;
  collisions.visuals = false;
  EXPECT_EQ(read(wider, collisions).table.boxes.size(), 1u);
}

TEST(SdfWorld, TheHighestPlaneThatCollidesIsTheFloor) {
  EXPECT_EQ(read(plane("0 0 0 0 0 0") + plane("5 5 1.5 0 0 0")).floor, 1.5);
  EXPECT_EQ(read(plane("0 0 0 0 0 0") + sdf_model("a", "", sdf_box("2 4 6"))).table.boxes.size(),
            1u);
  EXPECT_EQ(read(plane("0 0 0 0.1 0 0")).skipped.count(), 1u) << "tilted";
  EXPECT_EQ(read(plane("0 0 0 3.141592653589793 0 0")).skipped.count(), 1u) << "upside down";
}

TEST(SdfWorld, APlaneThatIsOnlySeenIsARectangleAboveTheFloor) {
  EXPECT_EQ(read(plane("0 0 2 0 0 0", "visual")).table.boxes[0],
            (Aabb{{-25, -25, 2}, {25, 25, 2}}));
  EXPECT_FALSE(read(plane("0 0 2 0 0 0", "visual")).floor);
  EXPECT_EQ(read(plane("0 0 2 0 0 0") + plane("0 0 2 0 0 0", "visual") +
                 sdf_model("a", "", sdf_box("2 4 6")))
                .table.boxes.size(),
            1u);
  EXPECT_EQ(read(plane("0 0 2 0 0 0") + plane("0 0 3 0 0 0", "visual")).table.boxes.size(), 1u);
}

TEST(SdfWorld, SkipsWhatMovesAndWhatIsNotKnown) {
  for (const char* text : {"<actor name='a'/>", "<road name='r'/>", "<population name='p'/>",
                           "<castle/>", "<model name='m'><wall/></model>",
                           "<model name='m'><link name='l'><hull/></link></model>"}) {
    EXPECT_EQ(read(text).skipped.count(), 1u) << text;
  }
  EXPECT_EQ(read("<plugin name='p' filename='q'/><light name='s' type='sun'/><physics/>"
                 "<gui><camera/></gui><other:thing/>")
                .skipped.count(),
            0u);
}

TEST(SdfWorld, CountsModelsThatMayMove) {
  EXPECT_EQ(read("<model name='m'><link name='l'/></model>").movable, 1u);
  EXPECT_EQ(read("<model name='m'><static>0</static></model>").movable, 1u);
  EXPECT_EQ(read("<model name='m'><static>true</static></model>").movable, 0u);
}

TEST(SdfWorld, LeavesOutModelsByTheirNames) {
  SdfOptions options;
  options.without = {"a", "c"};
  const SdfWorld out =
      read(sdf_model("a", "", sdf_box("1 1 1")) + sdf_model("b", "", sdf_box("1 1 1")), options);
  EXPECT_EQ(out.table.boxes.size(), 1u);
  EXPECT_EQ(out.left_out, (std::set<std::string>{"a"}));
}

TEST(SdfWorld, SkipsModelsThatAStateHasMoved) {
  const std::string model = sdf_model("a", "1 2 3 0 0 0.5", sdf_box("1 1 1"));
  const auto state = [](const std::string& inside) {
    return "<state world_name='w'><sim_time>0 0</sim_time>" + inside + "</state>";
  };
  EXPECT_EQ(
      read(model + state("<model name='a'><pose>1 2 3 0 0 0.5</pose></model>")).skipped.count(),
      0u);
  EXPECT_EQ(
      read(model + state("<model name='a'><pose>1 2 4 0 0 0.5</pose></model>")).skipped.count(),
      1u);
  EXPECT_EQ(
      read(model + state("<model name='b'><pose>1 2 3 0 0 0.5</pose></model>")).skipped.count(),
      1u);
  EXPECT_EQ(read(model + state("<insertions/>")).skipped.count(), 1u);
}

TEST(SdfWorld, SkipsModelsOfWhichAStateMovesOrScalesAPart) {
  const std::string model = sdf_model("a", "1 2 3 0 0 0", sdf_box("1 1 1"));
  const auto skipped = [&](const std::string& inside) {
    return read(model + "<state world_name='w'><model name='a'><pose>1 2 3 0 0 0</pose>" + inside +
                "</model></state>")
        .skipped.count();
  };
  const auto moved = [&](const std::string& pose) {
    return skipped("<link name='l'><pose>" + pose + "</pose></link>");
  };
  EXPECT_EQ(skipped("<scale>1 1 1</scale>"), 0u);
  EXPECT_EQ(skipped("<scale>1 1 3</scale>"), 1u);
  EXPECT_EQ(moved("1 2 3 0 -0 0"), 0u) << "in the world";
  EXPECT_EQ(moved("0 0 0 0 0 0"), 0u) << "in the model";
  EXPECT_EQ(moved("9 2 3 0 0 0"), 1u);
  EXPECT_EQ(moved("1 2 3 0 0 1"), 1u);
  EXPECT_EQ(skipped("<model name='none'><pose>0 0 0 0 0 0</pose></model>"), 1u);
}

TEST(SdfWorld, LabelsOfNestedModelsNameThemAll) {
  const SdfWorld out = read("<model name='o'><static>1</static>" +
                            sdf_model("i", "", sdf_box("1 1 1")) + "</model>");
  EXPECT_EQ(out.table.labels.back(), "o::i");
  EXPECT_EQ(
      read("<model name='o'><skyway:label>a::b</skyway:label><static>1</static><link name='l'>" +
           part("visual", sdf_box("1 1 1")) + "</link></model>")
          .table.labels.back(),
      "a::b");
}

TEST(SdfWorld, RefusesWhatIsBeyondTheWorld) {
  const auto refusal = [](const std::string& inside) {
    return support::refusal_of([&] { read(inside); });
  };
  EXPECT_TRUE(
      support::says(refusal(sdf_model("a", "1e8 0 0 0 0 0", sdf_box("2 1 1"))), "within 1e8"));
  EXPECT_NE(refusal(sdf_model("a", "0 0 0 0 0", sdf_box("2 1 1"))), "");
  EXPECT_TRUE(support::says(refusal(link("<collision name='c'/>")), "expected <geometry>"));
  EXPECT_EQ(refusal(sdf_model("a", "", "<box><size>1 1 -2</size></box>")),
            "w:4: <size> must be >= 0, found -2");
}

TEST(SdfWorld, IsItsGroundWhereThereIsNothingElse) {
  const SdfWorld out = read(plane("0 0 2 0 0 0") + plane("0 0 2 0 0 0", "visual"));
  ASSERT_EQ(out.table.boxes.size(), 1u);
  EXPECT_EQ(out.table.boxes[0], (Aabb{{-25, -25, 2}, {25, 25, 2}}));
  EXPECT_EQ(out.floor, 2);
  EXPECT_TRUE(read(plane("0 0 2 0 0 0") + "<actor name='a'/>").table.boxes.empty());
}

TEST(SdfWorld, SkipsABodyOfWhichSomethingIsNotKnown) {
  EXPECT_EQ(read(link("<collision name='c'><scale>2 2 2</scale><geometry>" + sdf_box("1 1 1") +
                      "</geometry></collision>"))
                .skipped.count(),
            1u);
}

}  // namespace
}  // namespace geom
