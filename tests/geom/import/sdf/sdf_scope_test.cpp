#include "import/sdf/sdf_scope.h"

#include <gtest/gtest.h>

#include "geom/import/sdf_world.h"
#include "support/reading.h"
#include "support/sdf_text.h"

namespace geom {
namespace {

// The middle of the one box, of size 2, in the model's text.
Vec3 middle(const std::string& world) {
  const SdfWorld out = read_sdf_world(support::Text(support::sdf(world)), "w", {});
  EXPECT_EQ(out.table.boxes.size(), 1u);
  return 0.5 * (out.table.boxes.at(0).min + out.table.boxes.at(0).max);
}

const std::string kBox = "<geometry>" + support::sdf_box("2 2 2") + "</geometry>";

std::string model(const std::string& inside, const std::string& attributes = "") {
  return "<model name='m' " + attributes + "><static>1</static>" + inside + "</model>";
}

TEST(SdfScope, PosesAreNestedAndMayBeRelative) {
  EXPECT_EQ(middle(model("<pose>1 0 0 0 0 0</pose><link name='l'><pose>0 2 0 0 0 0</pose>"
                         "<collision name='c'><pose>0 0 3 0 0 0</pose>" +
                         kBox + "</collision></link>")),
            Vec3(1, 2, 3));
  EXPECT_EQ(
      middle(model("<frame name='f'><pose degrees='1'>0 5 0 0 0 90</pose></frame>"
                   "<frame name='g' attached_to='f'><pose>1 0 0 0 0 0</pose></frame>"
                   "<link name='l'><pose relative_to='g'>2 0 0 0 0 0</pose><collision name='c'>" +
                   kBox + "</collision></link>")),
      Vec3(0, 8, 0));
}

TEST(SdfScope, ReadsTheOlderAttribute) {
  EXPECT_EQ(middle(model("<link name='a'><pose>1 0 0 0 0 0</pose></link><link name='l'>"
                         "<pose frame='a'>0 1 0 0 0 0</pose><collision name='c'>" +
                         kBox + "</collision></link>")),
            Vec3(1, 1, 0));
}

TEST(SdfScope, KnowsJointsNestedModelsAndTheCollisionsOwnFrame) {
  EXPECT_EQ(middle(model("<link name='a'><pose>1 0 0 0 0 0</pose></link>"
                         "<joint name='j' type='fixed'><parent>world</parent><child>a</child>"
                         "<pose>0 1 0 0 0 0</pose></joint>"
                         "<model name='n'><pose relative_to='j'>0 0 1 0 0 0</pose>"
                         "<link name='b'><pose>4 0 0 0 0 0</pose></link></model>"
                         "<link name='l'><pose>100 0 0 0 0 0</pose><collision name='c'>"
                         "<pose relative_to='n::b'>0 0 0.5 0 0 0</pose>" +
                         kBox + "</collision></link>")),
            Vec3(5, 1, 1.5));
}

TEST(SdfScope, PutsThePlacementFrameWhereThePoseSays) {
  EXPECT_EQ(middle(model("<pose>10 0 0 0 0 0</pose><frame name='f'><pose>0 3 0 0 0 0</pose></frame>"
                         "<link name='l'><collision name='c'>" +
                             kBox + "</collision></link>",
                         "placement_frame='f'")),
            Vec3(10, -3, 0));
}

TEST(SdfScope, IsRelativeToFramesAndModelsOfTheWorld) {
  EXPECT_EQ(middle("<frame name='f'><pose>7 0 0 0 0 0</pose></frame>"
                   "<model name='a'><pose relative_to='f'>0 1 0 0 0 0</pose></model>" +
                   model("<pose relative_to='a'>0 0 1 0 0 0</pose><link name='l'>"
                         "<collision name='c'>" +
                         kBox + "</collision></link>")),
            Vec3(7, 1, 1));
}

TEST(SdfScope, RefusesNamesThatAreNotThereOrLeadBack) {
  const auto refusal = [](const std::string& inside) {
    return support::refusal_of([&] { middle(inside); });
  };
  const std::string tail = "<collision name='c'>" + kBox + "</collision></link>";
  EXPECT_TRUE(support::says(refusal(model("<link name='l'><pose relative_to='x'/>" + tail)),
                            "found \"x\""));
  EXPECT_TRUE(
      support::says(refusal(model("<link name='l'><pose relative_to='l'/>" + tail)), "leads back"));
  EXPECT_TRUE(support::says(
      refusal(model("<frame name='f' attached_to='g'/><frame name='g' attached_to='f'/>"
                    "<link name='l'><pose relative_to='f'/>" +
                    tail)),
      "leads back"));
  EXPECT_TRUE(support::says(refusal(model("<frame name='f'/><frame name='f'/><link name='l'>"
                                          "<pose relative_to='f'/>" +
                                          tail)),
                            "more than once"));
  EXPECT_TRUE(support::says(
      refusal(model("<frame name='f'/><link name='l'><pose relative_to='f::g'/>" + tail)),
      "expected a model before ::"));
  std::string chain;
  for (int i = 1; i < 100000; ++i) {
    chain +=
        "<frame name='f" + std::to_string(i) + "' attached_to='f" + std::to_string(i - 1) + "'/>";
  }
  EXPECT_TRUE(support::says(refusal(model("<frame name='f0'/>" + chain +
                                          "<link name='l'><pose relative_to='f99999'/>" + tail)),
                            "at most"));
}

}  // namespace
}  // namespace geom
