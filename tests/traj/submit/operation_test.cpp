#include "traj/submit/operation.h"

#include <gtest/gtest.h>

#include <string>

#include "geom/base/error.h"

namespace {

const std::string kGood =
    R"({"operator":{"name":"Ann","registration":"AUT1"},)"
    R"("uas":{"model":"quad","serial":"7","class":"C3","dimension_m":0.7},"lost_link":"lands"})";

std::string with(std::string text, const std::string& old, const std::string& now) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), now);
}

geom::Fault fault_of(const std::string& json) {
  try {
    traj::read_operation(json, "operation.json");
  } catch (const geom::InputError& error) {
    return error.fault();
  }
  ADD_FAILURE() << "accepted: " << json;
  return {};
}

TEST(Operation, IsWhatTheFileSays) {
  const traj::Operation read = traj::read_operation(
      with(kGood, R"("serial":"7",)", R"("serial":"7","mass_kg":2,"endurance_s":900,)"), "o");
  EXPECT_EQ(read.by.name, "Ann");
  EXPECT_EQ(read.by.registration, "AUT1");
  EXPECT_EQ(read.uas.uas_class, "C3");
  EXPECT_EQ(read.uas.dimension, 0.7);
  EXPECT_EQ(read.uas.mass, 2);
  EXPECT_EQ(read.uas.endurance, 900);
  EXPECT_EQ(read.lost_link, "lands");
  EXPECT_TRUE(read.by.contact.empty());
}

TEST(Operation, NamesTheMemberThatIsWrong) {
  EXPECT_EQ(fault_of(with(kGood, R"("name":"Ann",)", "")).key, "operator.name");
  EXPECT_EQ(fault_of(with(kGood, R"("name":"Ann")", R"("name":"")")).key, "operator.name");
  EXPECT_EQ(fault_of(with(kGood, R"("name":"Ann")", R"("name":7)")).key, "operator.name");
  EXPECT_EQ(fault_of(with(kGood, R"("serial":"7")", R"("serial":null)")).key, "uas.serial");
  EXPECT_EQ(fault_of(with(kGood, "0.7", "0")).key, "uas.dimension_m");
  EXPECT_EQ(fault_of(with(kGood, "0.7", "1e9")).key, "uas.dimension_m");
  EXPECT_EQ(fault_of(with(kGood, "C3", "C9")).key, "uas.class");
  EXPECT_EQ(fault_of(with(kGood, R"(,"lost_link":"lands")", "")).key, "lost_link");
  EXPECT_EQ(fault_of(with(kGood, R"("uas":{)", R"("uas":[],"x":{)")).says.substr(0, 1), "x");
}

TEST(WhyDimensionWrong, HoldsItAgainstTheBoxAndTheBody) {
  const geom::Vehicle box{"box", {0.3, 0.4, 0.1}};
  EXPECT_FALSE(traj::why_dimension_wrong(0.63, box));
  EXPECT_FALSE(traj::why_dimension_wrong(0.1, box)) << "a box may be larger than what it holds";
  EXPECT_NE(traj::why_dimension_wrong(0.64, box)->find("has room for 0.632 m"), std::string::npos);
  EXPECT_FALSE(traj::why_dimension_wrong(0.5, box, geom::Vec3(0.2, 0.25, 0.1)));
  EXPECT_NE(traj::why_dimension_wrong(0.49, box, geom::Vec3(0.2, 0.25, 0.1))->find("0.5 m long"),
            std::string::npos);
}

TEST(WhyDimensionWrong, KnowsTheBodiesOfBuiltInVehicles) {
  const traj::VehicleProfile quad = *traj::vehicle_named("quad2kg");
  EXPECT_FALSE(traj::why_dimension_wrong(0.7, quad.vehicle));
  EXPECT_TRUE(traj::why_dimension_wrong(0.69, quad.vehicle));
  geom::Vehicle other = quad.vehicle;
  other.half *= 1.5;
  EXPECT_FALSE(traj::why_dimension_wrong(0.69, other)) << "only the name is the same";
}

TEST(Operation, HasNoMembersThatNobodyReads) {
  EXPECT_NE(fault_of(with(kGood, R"("model")", R"("weight":1,"model")")).says.find("uas.weight"),
            std::string::npos);
}

}  // namespace
