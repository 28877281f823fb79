#include "geom/model/model.h"

#include <gtest/gtest.h>

#include <limits>

#include "geom/archive/bytes.h"
#include "support/reading.h"

namespace geom {
namespace {

Model obj(const std::string& text) { return read_obj(support::Text(text), "a.obj"); }

Model stl(const std::string& text) { return read_stl(support::Text(text), "a.stl"); }

template <class Read>
void expect_refusal(const Read& read, const std::string& text, const std::string& message) {
  const std::string found = support::refusal_of([&] { read(text); });
  EXPECT_TRUE(support::says(found, message));
}

double area(const std::vector<Vec3>& corners,
            const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Vec3 u = corners[b] - corners[a];
    const Vec3 v = corners[c] - corners[a];
    sum += 0.5 * Vec3(u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(),
                      u.x() * v.y() - u.y() * v.x())
                     .norm();
  }
  return sum;
}

TEST(PolygonTriangles, DoNotFillANotch) {
  const std::vector<Vec3> notched = {{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {2, 1, 1}, {0, 4, 1}};
  EXPECT_DOUBLE_EQ(area(notched, polygon_triangles(notched)), 10);
  std::vector<Vec3> standing;  // the same, upright and the other way round
  for (const Vec3& p : notched) standing.insert(standing.begin(), {7, p.x(), p.y()});
  const auto triangles = polygon_triangles(standing);
  EXPECT_EQ(triangles.size(), 3u);
  EXPECT_DOUBLE_EQ(area(standing, triangles), 10);
}

TEST(PolygonTriangles, HoldAPolygonWithASlit) {
  const std::vector<Vec3> slit = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                                  {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  EXPECT_DOUBLE_EQ(area(slit, polygon_triangles(slit)), 12);
}

TEST(PolygonTriangles, AreAFanWhereThePolygonCrossesItselfOrIsAPoint) {
  const std::vector<Vec3> bow = {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}};
  EXPECT_EQ(polygon_triangles(bow).size(), 2u);
  const std::vector<Vec3> point(6, Vec3(1, 2, 3));
  EXPECT_EQ(polygon_triangles(point).size(), 4u);
}

TEST(ReadObj, MakesTrianglesOfFacesAndPartsOfObjects) {
  const Model model = obj(
      "# a comment\nmtllib a.mtl\no first thing\nv 0 0 0\nv 1 0 0 1\nv 1 1 0 0.5 0.5 0.5\nv 0 1 0\n"
      "vt 0 0\nvn 0 0 1\ng wall\nusemtl stone\ns off\nf 1/1/1 2//1 3/1 4\no other\nv 0 0 1\n"
      "f -1 \\\n -2 -3\n");
  ASSERT_EQ(model.mesh.triangles.size(), 3u);
  EXPECT_EQ(model.parts, (std::vector<std::string>{"first thing", "other"}));
  EXPECT_EQ(model.mesh.triangles[0].part, 0u);
  EXPECT_EQ(model.mesh.triangles[2].part, 1u);
  EXPECT_EQ(model.mesh.triangles[2].corners, (std::array<std::uint32_t, 3>{4, 3, 2}));
  EXPECT_TRUE(model.skipped.empty());
  EXPECT_FALSE(model.up || model.unit);
}

TEST(ReadObj, ObeysTheUnitOfAComment) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_FALSE(obj(triangle).unit);
  EXPECT_EQ(obj("# File units = inches\n" + triangle).unit, 0.0254);
  expect_refusal(obj, "# units: m\n# units: mm\n" + triangle,
                 "a.obj:2: expected the unit that a comment before names");
}

TEST(ReadObj, RefusesACarriageReturnAlone) {
  expect_refusal(obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\n# a wall\rf 1 2 3\n", "a.obj:4: expected lines");
}

TEST(ReadObj, CountsWhatItDoesNotBuild) {
  const Model model = obj("v 0 0 0\nv 1 0 0\nl 1 2\np 1\ncstype bezier\nsurf 0 1 0 1 1 2\n");
  EXPECT_EQ(model.skipped.count(), 4u);
  EXPECT_TRUE(model.mesh.triangles.empty());
}

TEST(ReadObj, RefusesWhatIsNoModel) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  expect_refusal(obj, "", "expected vertices");
  expect_refusal(obj, "v 0 0\n", "a.obj:1: expected \"v\" and three numbers, found 2");
  expect_refusal(obj, "v 0 nan 0\n", "a.obj:1");
  expect_refusal(obj, "v 0 1e9 0\n", "a.obj:1");
  expect_refusal(obj, "v 0 0x 0\n", "a.obj:1");
  expect_refusal(obj, three + "f 1 2\n",
                 "a.obj:4: expected a face of at least 3 vertices, found 2");
  expect_refusal(obj, three + "f 1 2 4\n", "found one that is not there yet");
  expect_refusal(obj, three + "f 1 2 0\n", "expected the number of a vertex");
  expect_refusal(obj, three + "f 1 2 -4\n", "expected the number of a vertex");
  expect_refusal(obj, three + "f 1 2 99999999999999999999\n", "expected the number of a vertex");
  expect_refusal(obj, three + "usemtl C:\\wood\\\nf 1 2 3\n", "expected a line of numbers");
  expect_refusal(obj, three + "f 1 2 3 \\\n", "found the end");
  expect_refusal(obj, three + "f 1/1x 2 3\n", "expected the number of a vertex");
  expect_refusal(obj, "v 0 0 0\nv 0 0 0 2\n", "a.obj:2: expected a weight of 1");
  expect_refusal(obj, "v 0 0 0 x\n", "a.obj:1: expected a weight of 1");
  expect_refusal(obj, "v 0 0 0 0.5 0.5\n", "found 5 numbers");
  expect_refusal(obj, "v 0 0 0 0.5 0.5 x\n", "expected numbers as the colour");
  expect_refusal(obj, "v 0 0 0 0 0 0 0 v 9 9 9\n", "found 11 numbers");
}

std::string binary_stl(const std::vector<float>& numbers) {
  std::string out(80, ' ');
  append_bytes(out, static_cast<std::uint32_t>(numbers.size() / 9));
  for (std::size_t i = 0; i < numbers.size(); i += 9) {
    out += std::string(12, '\0');
    for (std::size_t k = 0; k < 9; ++k) append_bytes(out, numbers[i + k]);
    out += std::string(2, '\0');
  }
  return out;
}

Model ply(const std::string& text) { return read_ply_model(support::Text(text), "a.ply"); }

std::string ply_text(const std::string& faces, int count) {
  return "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\nproperty "
         "double z\nproperty uchar red\nelement face " +
         std::to_string(count) +
         "\nproperty list uchar int vertex_indices\nproperty float quality\nend_header\n"
         "5400000.1 0 0 9\n4 0 0 9\n4 3 2 9\n0 3 2 9\n2 5 0 9\n" +
         faces;
}

TEST(ReadPlyModel, ReadsPolygonsInDoublePrecision) {
  const Model model = ply(ply_text("4 0 1 2 3 0.5\n3 3 2 4 0.5\n", 2));
  ASSERT_EQ(model.mesh.triangles.size(), 3u);
  EXPECT_EQ(model.mesh.vertices[0].x(), 5400000.1);
  EXPECT_EQ(model.mesh.triangles[2].corners, (std::array<std::uint32_t, 3>{3, 2, 4}));
  EXPECT_EQ(model.blur, 0);
}

TEST(ReadPlyModel, ReadsStripsAndSkipsOtherElementsOfVertices) {
  const auto with = [](const std::string& element, const std::string& row) {
    std::string text = ply_text("3 0 1 2 0.5\n" + row, 1);
    const std::string end = "end_header";
    return ply(text.insert(text.find(end), "element " + element +
                                               " 1\nproperty list uchar int "
                                               "vertex_indices\n"));
  };
  const Model strips = with("tristrips", "8 0 1 2 3 -1 2 3 4\n");
  ASSERT_EQ(strips.mesh.triangles.size(), 4u);
  EXPECT_EQ(strips.mesh.triangles[1].corners, (std::array<std::uint32_t, 3>{0, 1, 2}));
  EXPECT_EQ(strips.mesh.triangles[2].corners, (std::array<std::uint32_t, 3>{2, 1, 3}));
  EXPECT_EQ(strips.mesh.triangles[3].corners, (std::array<std::uint32_t, 3>{2, 3, 4}));
  EXPECT_EQ(with("polygon", "3 0 1 2\n").skipped.count(), 1u);
  EXPECT_NE(support::refusal_of([&] { with("tristrips", "3 0 1 9\n"); }), "");
}

TEST(ReadPlyModel, ReadsBinary) {
  std::string text =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float "
      "y\nproperty float z\nelement face 1\nproperty list uchar uint vertex_index\nelement edge "
      "1\nproperty int vertex1\nend_header\n";
  for (const float v : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 2.f}) append_bytes(text, v);
  append_bytes(text, std::uint8_t{3});
  for (const std::uint32_t i : {0u, 1u, 2u}) append_bytes(text, i);
  append_bytes(text, std::int32_t{0});
  const Model model = ply(text);
  ASSERT_EQ(model.mesh.triangles.size(), 1u);
  EXPECT_EQ(model.mesh.vertices[2], Vec3(0, 1, 2));
  EXPECT_EQ(model.skipped.count(), 1u) << "an edge";
  expect_refusal(ply, text.substr(0, text.size() - 1), "the file ends after 0");
  expect_refusal(ply, text + "x", "and it goes on");
}

TEST(ReadPlyModel, RefusesFacesThatAreCutOrLie) {
  expect_refusal(ply, ply_text("4 0 1 2 3 0.5\n", 2), "expected 2 of element \"face\"");
  expect_refusal(ply, ply_text("3 0 1 5 0\n", 1), "face 0: expected the numbers of 5 vertices");
  expect_refusal(ply, ply_text("3 0 1 -1 0\n", 1), "face 0: expected the numbers of 5 vertices");
  expect_refusal(ply, ply_text("3 0 1 1.5 0\n", 1), "face 0: expected the numbers of 5 vertices");
  expect_refusal(ply, ply_text("2 0 1 0\n", 1), "face 0: expected at least 3 vertices, found 2");
  expect_refusal(ply, "ply\nformat ascii 1.0\nend_header\n", "expected an element \"vertex\"");
  std::string text = ply_text("3 0 1 2 0\n", 1);
  text.replace(text.find("4 3 2 9"), 1, "nan");
  expect_refusal(ply, text, "vertex 2: expected coordinates");
}

TEST(ReadStl, ReadsBinaryEvenWhereItBeginsAsText) {
  std::string bytes = binary_stl({0, 0, 0, 1, 0, 0, 0, 1, 0.5f, 0, 0, 0, 1, 0, 0, 0, 1, 2});
  bytes.replace(0, 5, "solid");
  const Model model = stl(bytes);
  ASSERT_EQ(model.mesh.triangles.size(), 2u);
  EXPECT_EQ(model.mesh.vertices[2], Vec3(0, 1, 0.5));
  expect_refusal(stl, bytes.substr(0, bytes.size() - 1), "a.stl:1");
  bytes.replace(0, 5, "other");
  expect_refusal(stl, bytes + "x", "expected 184 bytes for the 2 triangles");
  bytes.replace(80, 4, "\xff\xff\xff\xff");
  expect_refusal(stl, bytes, "found 184");
  expect_refusal(stl, binary_stl({0, 0, 0, 1, 0, std::numeric_limits<float>::quiet_NaN(), 0, 1, 0}),
                 "triangle 0: expected coordinates");
}

TEST(ReadStl, ReadsTextSolidBySolid) {
  const std::string facet =
      "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\n"
      "endfacet\n";
  const Model model =
      stl("solid a\n" + facet + "endsolid a\nsolid b c\n" + facet + facet + "endsolid\n");
  EXPECT_EQ(model.mesh.triangles.size(), 3u);
  EXPECT_EQ(model.parts, (std::vector<std::string>{"a", "b c"}));
  EXPECT_EQ(model.mesh.triangles[2].part, 1u);
  EXPECT_FALSE(model.unit);
  EXPECT_EQ(stl("solid a UNITS=mm\n" + facet + "endsolid\n").unit, 1e-3);
  expect_refusal(stl, "solid a\nendsolid\nsolid b units=mm\nendsolid\n", "expected solids of one");
  expect_refusal(stl, "solid a\n" + facet, "expected endsolid");
  expect_refusal(stl, "facet normal 0 0 1\n", "expected solid");
  expect_refusal(stl, "solid a\nfacet\nouter loop\nvertex 0 0 0\nendloop\n", "expected vertex");
  expect_refusal(stl, "solid a\nfacet\nouter loop\nvertex 0 0 inf\n", "a.stl:4");
  expect_refusal(stl, "solid a\nfacet\nouter loop\nvertex 0 0\n", "a.stl:4");
  expect_refusal(stl, "", "expected a solid");
  const std::string three = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0";
  const auto one = [](const std::string& begin, const std::string& corners,
                      const std::string& end) {
    return "solid a\n" + begin + '\n' + corners + '\n' + end + "\nendsolid\n";
  };
  const std::string loop = "facet normal 0 0 1\nouter loop";
  const std::string end = "endloop\nendfacet";
  EXPECT_EQ(stl(one("facet normal nan nan nan\nouter loop", three, end)).mesh.triangles.size(), 1u);
  expect_refusal(stl, one(loop, three + " 99", end),
                 "a.stl:6: expected vertex and three numbers and nothing after it");
  expect_refusal(stl, one(loop, three, "endloop x\nendfacet"), "a.stl:7: expected endloop and");
  expect_refusal(stl, one(loop, three, "endloop\nendfacet facet"), "a.stl:8: expected endfacet");
  expect_refusal(stl, one("facet normal 0 0 1 outer loop", three, end), "a.stl:2: expected facet");
  expect_refusal(stl, one("facet vertex 0 0 1\nouter loop", three, end), "a.stl:2: expected facet");
  expect_refusal(stl, one("facet\nouter ring", three, end), "a.stl:3: expected outer loop");
  expect_refusal(stl, one("facet\nouter loop 1", three, end), "a.stl:3: expected outer loop");
}

}  // namespace
}  // namespace geom
