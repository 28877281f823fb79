#include "import/sdf/sdf_pose.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "support/reading.h"

namespace geom {
namespace {

SdfPose pose(const std::string& values, const std::string& attributes = "") {
  const XmlElement root = parse_xml("<pose " + attributes + ">" + values + "</pose>", "w");
  const std::string source = "w";
  return parse_sdf_pose({&root, &source});
}

TEST(SdfPose, OfNothingIsNoMove) {
  EXPECT_TRUE(pose("").exact());
  EXPECT_EQ(pose(" ").place(), Vec3(0, 0, 0));
  EXPECT_EQ(pose("1 2 3 0 -0 0").place(), Vec3(1, 2, 3));
  EXPECT_TRUE(pose("1 2 3 0 -0 0").exact());
}

TEST(SdfPose, TurnsByRollThenPitchThenYaw) {
  const SdfPose p = pose("0 0 0 0.1 0.2 0.3");
  const Eigen::Matrix3d expected =
      (Eigen::AngleAxisd(0.3, Vec3::UnitZ()) * Eigen::AngleAxisd(0.2, Vec3::UnitY()) *
       Eigen::AngleAxisd(0.1, Vec3::UnitX()))
          .toRotationMatrix();
  EXPECT_LE((p.turn - expected).norm(), p.turn_error);
  EXPECT_FALSE(p.exact());
  const Eigen::Quaterniond q(expected);
  const SdfPose same = pose("0 0 0 " + std::to_string(q.x()) + ' ' + std::to_string(q.y()) + ' ' +
                                std::to_string(q.z()) + ' ' + std::to_string(q.w()),
                            "rotation_format='quat_xyzw'");
  EXPECT_LE((same.turn - expected).norm(), 1e-5);
}

TEST(SdfPose, IsExactInQuartersOfDegreesAndOfQuaternions) {
  EXPECT_TRUE(pose("1 2 3 90 180 -270", "degrees='true'").exact());
  EXPECT_TRUE(pose("1 2 3 0 0 1 0", "rotation_format='quat_xyzw'").exact());
  EXPECT_FALSE(pose("1 2 3 0 0 1.5707963267948966").exact());
  const SdfPose quarter = pose("0 0 0 0 0 90", "degrees='1'");
  EXPECT_EQ(quarter.turn * Vec3(1, 0, 0), Vec3(0, 1, 0));
  EXPECT_EQ(placed_box(quarter, {2, 1, 3}).max, Vec3(1, 2, 3));
}

TEST(SdfPose, JoinsWithoutLosingSmallMoves) {
  const SdfPose far = pose("1e8 0 0 0 0 0") * pose("1e-9 0 0 0 0 0") * pose("-1e8 0 0 0 0 0");
  EXPECT_TRUE(far.exact());
  EXPECT_EQ(far.place().x(), 1e-9);
  const Aabb box = placed_box(far, {0, 0, 0});
  EXPECT_EQ(box.min.x(), 1e-9);
  EXPECT_EQ(box.max.x(), 1e-9);
}

// More terms than there is room for are rounded, and the pose says so.
TEST(SdfPose, SaysWhatALongChainLoses) {
  SdfPose chain;
  for (int i = 0; i < 100; ++i) chain = chain * pose("0.1 0 0 0 0 0");
  EXPECT_FALSE(chain.exact());
  EXPECT_LE(std::abs(chain.place().x() - 10), chain.shift_error);
  EXPECT_LE(chain.shift_error, 1e-12);
}

TEST(SdfPose, ErrorsHoldInLongDouble) {
  using Matrix = Eigen::Matrix<long double, 3, 3>;
  using Vector = Eigen::Matrix<long double, 3, 1>;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(-100, 100);
  std::uniform_real_distribution<double> angle(-3, 3);
  for (int k = 0; k < 2000; ++k) {
    SdfPose joined;
    Matrix turn = Matrix::Identity();
    Vector shift = Vector::Zero();
    for (int i = 0; i < 5; ++i) {
      const Vec3 p(place(random), place(random), place(random));
      const Vec3 a(angle(random), angle(random), angle(random));
      XmlElement element;
      element.name = "pose";
      const std::string source = "w";
      char text[200];
      std::snprintf(text, sizeof text, "%.17g %.17g %.17g %.17g %.17g %.17g", p.x(), p.y(), p.z(),
                    a.x(), a.y(), a.z());
      element.text = text;
      joined = joined * parse_sdf_pose({&element, &source});
      shift += turn * p.cast<long double>();
      const auto about = [&](int axis, double by) {
        return Eigen::AngleAxis<long double>(by, Vector::Unit(axis)).toRotationMatrix();
      };
      turn = turn * about(2, a.z()) * about(1, a.y()) * about(0, a.x());
    }
    ASSERT_LE((joined.turn.cast<long double>() - turn).norm(), joined.turn_error);
    ASSERT_LE((joined.place().cast<long double>() - shift).norm(), joined.shift_error);
    const SdfPose none = joined * inverse(joined);
    ASSERT_LE(none.place().norm(), none.shift_error + 1e-300);
  }
}

TEST(SdfPose, RefusesWhatIsNotClear) {
  for (const auto& [values, attributes] :
       {std::pair{"1 2 3", ""},
        {"1 2 3 0 0", ""},
        {"1 2 3 0 0 nan", ""},
        {"1m 2 3 0 0 0", ""},
        {"0 0 0 0 0 0 1", ""},
        {"0 0 0 0 0 0 2", "rotation_format='quat_xyzw'"},
        {"0 0 0 0 0 0", "rotation_format='quat_xyzw'"},
        {"", "rotation_format='matrix'"},
        {"", "degrees='yes'"},
        {"0 0 0 0 0 0 1", "rotation_format='quat_xyzw' degrees='true'"},
        {"0 0 0 0 0 1e6", ""},
        {"", "relativ_to='a'"}}) {
    const std::string v = values;
    const std::string a = attributes;
    EXPECT_NE(support::refusal_of([&] { pose(v, a); }), "") << v << a;
  }
}

}  // namespace
}  // namespace geom
