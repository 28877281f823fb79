#include "import/sdf/sdf_meshes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "support/collada_text.h"
#include "support/reading.h"

namespace geom {
namespace {

// A closed cuboid from (0, 0, 0) to (4, 2, 1).
const std::string kCrate =
    "v 0 0 0\nv 4 0 0\nv 4 2 0\nv 0 2 0\nv 0 0 1\nv 4 0 1\nv 4 2 1\nv 0 2 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
const std::string kSheet =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 3\nvertex 1 0 3\nvertex 0 1 3\n"
    "endloop\nendfacet\nendsolid s\n";

struct Made {
  std::vector<Aabb> boxes;
  Skipped skipped;
};

Made made(const std::string& inside, const std::string& pose = "", double slack = 0.1,
          const std::string& text = kCrate, std::optional<double> blur = {}) {
  const XmlElement shape = parse_xml("<mesh>" + inside + "</mesh>", "w");
  const XmlElement place = parse_xml("<pose degrees='true'>" + pose + "</pose>", "w");
  const std::string source = "w";
  const SdfFile crate{"models/crate.obj", text};
  const SdfFile sheet{"models/sheet.stl", kSheet};
  const SdfFile wedge{"models/wedge.dae", support::collada()};
  const SdfFile turned{"models/turned.dae", support::collada("<up_axis>Y_UP</up_axis>")};
  SdfOptions options;
  options.slack = slack;
  options.open_mesh = [&](const std::string& uri, const std::string& from) {
    EXPECT_EQ(from, "w");
    return uri == "crate.obj"    ? &crate
           : uri == "sheet.STL"  ? &sheet
           : uri == "wedge.dae"  ? &wedge
           : uri == "turned.dae" ? &turned
                                 : nullptr;
  };
  if (blur) {
    options.read_collada = [&](const SdfFile& file) {
      EXPECT_EQ(file.name, "models/wedge.dae");
      Model model = read_obj(support::Text(kCrate), file.name);
      model.blur = *blur;
      return model;
    };
  }
  Made m;
  m.boxes =
      SdfMeshes(options, m.skipped).boxes_of({&shape, &source}, parse_sdf_pose({&place, &source}));
  return m;
}

bool any_contains(const std::vector<Aabb>& boxes, const Vec3& p) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const Aabb& b) { return contains(b, p); });
}

std::string refusal(const std::string& inside, const std::string& pose = "",
                    const std::string& text = kCrate) {
  return support::refusal_of([&] { made(inside, pose, 0.1, text); });
}

TEST(SdfMeshes, AClosedCuboidIsItsBoxExactly) {
  const Made m = made("<uri>crate.obj</uri>", "10 20 30 0 0 90");
  EXPECT_EQ(m.boxes, (std::vector<Aabb>{{{8, 20, 30}, {10, 24, 31}}}));
  EXPECT_TRUE(m.skipped.empty());
}

TEST(SdfMeshes, ScaleComesBeforeThePoseAndMayMirror) {
  const Made m = made("<uri>crate.obj</uri><scale>0.5 -1 3</scale>", "10 0 0 0 0 0");
  ASSERT_EQ(m.boxes.size(), 1u);
  EXPECT_TRUE(m.boxes[0].min.isApprox(Vec3(10, -2, 0), 1e-12));
  EXPECT_TRUE(contains(m.boxes[0], Vec3(10, -2, 0)));
  EXPECT_TRUE(contains(m.boxes[0], Vec3(12, 0, 3)));
  EXPECT_LE(m.boxes[0].max.z(), 3 + 1e-9);
}

TEST(SdfMeshes, HoldWhatIsTurnedWithinTheSlack) {
  const double slack = 0.05;
  const Made m = made("<uri>crate.obj</uri>", "100 0 0 20 30 40", slack);
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(40 * std::numbers::pi / 180, Vec3::UnitZ()) *
                                Eigen::AngleAxisd(30 * std::numbers::pi / 180, Vec3::UnitY()) *
                                Eigen::AngleAxisd(20 * std::numbers::pi / 180, Vec3::UnitX()))
                                   .toRotationMatrix();
  const auto at = [&](double x, double y, double z) -> Vec3 {
    return turn * Vec3(x, y, z) + Vec3(100, 0, 0);
  };
  for (int i = 0; i <= 8; ++i) {
    for (int j = 0; j <= 8; ++j) {
      for (int k = 0; k <= 8; ++k) {
        EXPECT_TRUE(any_contains(m.boxes, at(i * 0.5, j * 0.25, k * 0.125)));
      }
    }
  }
  const double beside = 2 * slack;
  EXPECT_FALSE(any_contains(m.boxes, at(-beside, 1, 0.5)));
  EXPECT_FALSE(any_contains(m.boxes, at(2, 2 + beside, 0.5)));
  EXPECT_FALSE(any_contains(m.boxes, at(2, 1, 1 + beside)));
}

TEST(SdfMeshes, ReadStlWhateverTheCaseOfItsEnding) {
  const Made m = made("<uri> sheet.STL </uri>", "0 0 1 0 0 0");
  EXPECT_TRUE(any_contains(m.boxes, {0.2, 0.2, 4}));
  EXPECT_FALSE(any_contains(m.boxes, {0.2, 0.2, 3.8}));
}

TEST(SdfMeshes, ColladaGrowsByWhatItMayBeOffAndKeepsTheSlack) {
  const double blur = 0.004;
  const Made m = made("<uri>wedge.dae</uri><scale>1 1 2</scale>", "10 0 0 0 0 0", 0.1, "", blur);
  ASSERT_EQ(m.boxes.size(), 1u) << "as a cuboid that is filled";
  EXPECT_TRUE(m.skipped.empty());
  const double grown = std::sqrt(3.0) * 2 * blur;
  const Vec3 low = Vec3(10, 0, 0) - m.boxes[0].min;
  EXPECT_GE(low.minCoeff(), grown);
  EXPECT_LE(low.norm() + grown, 0.1);
  const Vec3 high = m.boxes[0].max - Vec3(14, 2, 2);
  EXPECT_GE(high.minCoeff(), grown);
  EXPECT_LE(high.norm() + grown, 0.1);
  EXPECT_TRUE(support::says(support::refusal_of([&] {
                              made("<uri>wedge.dae</uri><scale>1 1 -3</scale>", "", 0.1, "", blur);
                            }),
                            "known to 0.0208 m only: give a slack of at least 0.119 m"));
}

TEST(SdfMeshes, EachUseOfAMeshThatSimulatorsShowDifferentlyIsSkipped) {
  const XmlElement shape = parse_xml("<mesh><uri>turned.dae</uri></mesh>", "w");
  const std::string source = "w";
  const SdfFile turned{"turned.dae", support::collada("")};
  Skipped skipped;
  SdfOptions options;
  options.open_mesh = [&](const std::string&, const std::string&) { return &turned; };
  options.read_collada = [](const SdfFile&) -> Model {
    throw InputError("nobody", {.says = "asks"});
  };
  SdfMeshes meshes(options, skipped);
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(meshes.boxes_of({&shape, &source}, {}).empty());
  EXPECT_EQ(skipped.count(), 2u);
}

TEST(SdfMeshes, SkipWhatIsNotReadOrMayHoldMore) {
  const std::string uri = "<uri>crate.obj</uri>";
  for (const auto& [inside, kind] :
       {std::pair<std::string, std::string>{"<uri>crate.glb</uri>", "not OBJ, STL or COLLADA"},
        {"<uri>obj</uri>", "not OBJ, STL or COLLADA"},
        {"<uri>barrel.obj</uri>", "not found"},
        {"<uri>barrel.dae</uri>", "not found"},
        {"<uri>wedge.dae</uri>", "built without"},
        {"<uri>turned.dae</uri>", "in different ways (models/turned.dae:3: "},
        {uri + "<submesh><name>lid</name></submesh>", "part of a mesh"},
        {uri + "<tile>2 2</tile>", "unknown element"}}) {
    const Made m = made(inside);
    EXPECT_TRUE(m.boxes.empty()) << inside;
    EXPECT_TRUE(support::says(m.skipped.text(), kind));
  }
  EXPECT_EQ(made(uri, "", 0.1, kCrate + "l 1 2\n").skipped.text(),
            "1 x point or line (models/crate.obj: line 15: l)");
  const XmlElement convex = parse_xml("<mesh optimization='convex_hull'>" + uri + "</mesh>", "w");
  const std::string source = "w";
  Skipped skipped;
  const SdfOptions none;
  SdfMeshes meshes(none, skipped);
  EXPECT_TRUE(meshes.boxes_of({&convex, &source}, {}).empty());
  EXPECT_EQ(skipped.count(), 1u);
}

TEST(SdfMeshes, RefuseWhatIsMalformedOrCut) {
  EXPECT_TRUE(support::says(refusal(""), "expected <uri>"));
  EXPECT_TRUE(support::says(refusal("<uri>crate.obj</uri><scale>1 0 1</scale>"), "must not be 0"));
  EXPECT_NE(refusal("<uri>crate.obj</uri><scale>1 1</scale>"), "");
  EXPECT_NE(refusal("<uri>crate.obj</uri><scale>1e8 1e8 1e8</scale>"), "") << "beyond 1e8 m";
  EXPECT_TRUE(support::says(refusal("<uri>crate.obj</uri>", "", kCrate + "f 1 2 9\n"),
                            "models/crate.obj:15"));
  EXPECT_TRUE(support::says(refusal("<uri>crate.obj</uri>", "", "v 0 0 0\n"),
                            "expected triangles, found none"));
}

}  // namespace
}  // namespace geom
