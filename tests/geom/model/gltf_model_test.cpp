#include "geom/model/gltf_model.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/glb_file.h"
#include "support/reading.h"
#include "support/triangle_shapes.h"

namespace geom {
namespace {

using support::GltfFile;
using support::json;

const Aabb kBox{{0, 0, 0}, {1, 2, 3}};

std::string no_file(const std::string& path) { throw InputError(path, {.says = "not there"}); }

GltfModel read(const std::string& bytes, const ModelFiles& files = no_file) {
  return read_gltf(bytes, "a.glb", files);
}
GltfModel read(const GltfFile& file) { return read(file.bytes()); }

void expect_refusal(const std::string& bytes, const std::string& message) {
  const std::string found = support::refusal_of([&] { read(bytes); });
  EXPECT_TRUE(support::says(found, message));
}
void expect_refusal(const GltfFile& file, const std::string& message) {
  expect_refusal(file.bytes(), message);
}

TEST(ReadGltf, GivesTrianglesAsNodesPlaceThem) {
  GltfFile file(support::cuboid(kBox));
  file.text["nodes"] = json::parse(R"([
    {"name": "house", "mesh": 0, "translation": [10, 0, 0], "children": [1]},
    {"mesh": 0, "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476], "scale": [1, 1, 2],
     "translation": [0, 100, 0]}])");
  const GltfModel model = read(file);
  EXPECT_EQ(model.mesh.triangles.size(), 24u);
  EXPECT_EQ(model.parts, (std::vector<std::string>{"house", "node 1"}));
  EXPECT_EQ(model.up, UpAxis::y);
  EXPECT_EQ(model.unit, 1);
  EXPECT_EQ(model.mesh.vertices[7], Vec3(11, 2, 3));
  EXPECT_TRUE(model.mesh.vertices[15].isApprox(Vec3(10 - 2, 100 + 1, 6), 1e-12));
  EXPECT_EQ(model.mesh.triangles[12].part, 1u);
}

TEST(ReadGltf, TakesTheMatrixColumnByColumn) {
  GltfFile file(support::cuboid(kBox));
  file.text["nodes"][0]["matrix"] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1};
  EXPECT_EQ(read(file).mesh.vertices[7], Vec3(5 - 2, 6 + 1, 7 + 3));
}

TEST(ReadGltf, RefusesAMatrixBesideAPlace) {
  GltfFile file(support::cuboid(kBox));
  file.text["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1};
  file.text["nodes"][0]["translation"] = {100, 0, 0};
  expect_refusal(file, "expected a matrix, or translation, rotation and scale, found both");
}

TEST(ReadGltf, ReadsStripsFansAndWhatHasNoIndices) {
  GltfFile file(TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}}, {}});
  json& primitive = file.text["meshes"][0]["primitives"][0];
  primitive.erase("indices");
  primitive["mode"] = 5;
  const auto strip = read(file).mesh.triangles;
  ASSERT_EQ(strip.size(), 3u);
  EXPECT_EQ(strip[1].corners, (std::array<std::uint32_t, 3>{1, 3, 2}));
  primitive["mode"] = 6;
  EXPECT_EQ(read(file).mesh.triangles[2].corners, (std::array<std::uint32_t, 3>{0, 3, 4}));
  primitive["mode"] = 4;
  expect_refusal(file, "expected three indices for each triangle, found 5");
}

TEST(ReadGltf, ReadsQuantisedPositions) {
  GltfFile file(support::cuboid(kBox));
  file.binary.clear();
  for (const int v : {0, 127, -127, 127, 0, 0, 64, 64, -128}) {
    file.binary += static_cast<char>(v);
  }
  file.text["extensionsRequired"] = {"KHR_mesh_quantization"};
  file.text["meshes"][0]["primitives"][0].erase("indices");
  file.text["accessors"] = json::parse(
      R"([{"bufferView": 0, "componentType": 5120, "type": "VEC3", "count": 3, "normalized": true}])");
  file.text["bufferViews"] = json::parse(R"([{"buffer": 0, "byteLength": 9}])");
  file.text["buffers"][0]["byteLength"] = 9;
  const GltfModel model = read(file);
  EXPECT_EQ(model.mesh.vertices[0], Vec3(0, 1, -1));
  EXPECT_EQ(model.mesh.vertices[2].z(), -1) << "-128 is -1 as well";
}

TEST(ReadGltf, ReadsBuffersFromFilesAndDataUris) {
  GltfFile file(support::cuboid(kBox));
  file.text["buffers"][0]["uri"] = "data/a%20b.bin";
  const auto folder = [&](const std::string& path) {
    EXPECT_EQ(path, "data/a b.bin");
    return file.binary;
  };
  EXPECT_EQ(read(file.text.dump(), folder).mesh.triangles.size(), 12u);
  const auto cut = [&](const std::string&) { return file.binary.substr(1); };
  EXPECT_TRUE(support::says(support::refusal_of([&] { read(file.text.dump(), cut); }),
                            "expected 240 bytes"));
  EXPECT_TRUE(support::says(support::refusal_of([&] { read(file.text.dump()); }), "not there"));
  for (const char* uri : {"../a.bin", "/a.bin", "http://host/a.bin", "c:\\a.bin", ""}) {
    file.text["buffers"][0]["uri"] = uri;
    EXPECT_NE(support::refusal_of([&] { read(file.text.dump(), cut); }), "") << uri;
  }
  file.text["buffers"][0] = {{"byteLength", 12},
                             {"uri",
                              "data:application/octet-stream;base64,"
                              "AAAAAAAAgD8AAABA"}};
  file.text["bufferViews"][0]["byteLength"] = 12;
  file.text["accessors"][0]["count"] = 1;
  file.text["meshes"][0]["primitives"][0].erase("indices");
  EXPECT_TRUE(support::says(support::refusal_of([&] { read(file.text.dump()); }), "found 1"))
      << "one vertex is no triangle, but it was read";
}

TEST(ReadGltf, CountsPointsLinesAndMeshesThatAreNotShown) {
  GltfFile file(support::cuboid(kBox));
  json& primitives = file.text["meshes"][0]["primitives"];
  primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 1}});
  primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 0}});
  file.text["meshes"].push_back({{"name", "hidden"}, {"primitives", json::array()}});
  const GltfModel model = read(file);
  EXPECT_EQ(model.mesh.triangles.size(), 12u);
  EXPECT_EQ(model.skipped.count(), 3u);
  EXPECT_TRUE(support::says(model.skipped.text(), "hidden"));
}

TEST(ReadGltf, CountsShapesOfPhysicsThatHaveNoMesh) {
  for (const char* name : {"KHR_implicit_shapes", "OMI_physics_shape", "OMI_collider"}) {
    GltfFile told(support::cuboid(kBox));
    told.text["extensionsUsed"] = {name};
    GltfFile drawn(support::cuboid(kBox));
    drawn.text["extensions"][name] = {{"shapes", json::array({{{"type", "box"}}})}};
    for (const GltfFile& file : {told, drawn}) {
      EXPECT_TRUE(support::says(read(file).skipped.text(), name));
    }
  }
}

TEST(ReadGltf, CountsNodesThatAnotherSceneShows) {
  GltfFile file(support::cuboid(kBox));
  file.text["nodes"].push_back({{"name", "far"}, {"mesh", 0}, {"translation", {100, 0, 0}}});
  file.text["scenes"].push_back({{"nodes", {1}}});
  const GltfModel model = read(file);
  EXPECT_EQ(model.mesh.triangles.size(), 12u);
  EXPECT_EQ(model.skipped.count(), 1u);
  EXPECT_TRUE(support::says(model.skipped.text(), "far"));
}

TEST(ReadGltf, TellsTheFeatureOfEachTriangle) {
  GltfFile file(support::cuboid(kBox));
  const std::size_t at = file.binary.size();
  for (int i = 0; i < 8; ++i) append_bytes(file.binary, 7.0f);
  file.text["buffers"][0]["byteLength"] = file.binary.size();
  file.text["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", at}, {"byteLength", 32}});
  file.text["accessors"].push_back(
      {{"bufferView", 2}, {"componentType", 5126}, {"type", "SCALAR"}, {"count", 8}});
  EXPECT_EQ(read(file).feature, std::vector<std::int64_t>(12, -1));
  file.text["meshes"][0]["primitives"][0]["attributes"]["_BATCHID"] = 2;
  EXPECT_EQ(read(file).feature, std::vector<std::int64_t>(12, 7));
}

// The cuboid with nothing but the word "cuboid" in its view, and a decoder that knows it.
struct PackedFile : GltfFile {
  DracoMesh mesh;

  PackedFile() : GltfFile(support::cuboid(kBox)) {
    const GltfModel plain = read(*this);
    mesh.vertices = 8;
    for (const MeshTriangle& t : plain.mesh.triangles) {
      mesh.corners.insert(mesh.corners.end(), t.corners.begin(), t.corners.end());
    }
    DracoMesh::Attribute& positions = mesh.attributes[5];
    positions = {5126, 3, {}};
    for (const Vec3& v : plain.mesh.vertices) {
      positions.values.insert(positions.values.end(), v.begin(), v.end());
    }
    binary = "cuboid";
    text["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    text["buffers"][0]["byteLength"] = 6;
    text["bufferViews"] = json::parse(R"([{"buffer": 0, "byteLength": 6}])");
    for (json& accessor : text["accessors"]) accessor.erase("bufferView");
    extension() = {{"bufferView", 0}, {"attributes", {{"POSITION", 5}}}};
  }

  json& primitive() { return text["meshes"][0]["primitives"][0]; }
  json& extension() { return primitive()["extensions"]["KHR_draco_mesh_compression"]; }

  GltfModel unpacked() const {
    return read_gltf(bytes(), "a.glb", no_file, {},
                     [&](std::string_view packed, const std::string& source) {
                       EXPECT_EQ(source, "a.glb");
                       if (packed != "cuboid") throw InputError(source, {.says = "not packed"});
                       return mesh;
                     });
  }
  void expect_refusal(const std::string& message) const {
    const std::string found = support::refusal_of([&] { unpacked(); });
    EXPECT_TRUE(support::says(found, message));
  }
};

TEST(ReadGltf, ReadsWhatADecoderUnpacks) {
  const GltfModel plain = read(GltfFile(support::cuboid(kBox)));
  PackedFile file;
  EXPECT_EQ(file.unpacked().mesh.vertices, plain.mesh.vertices);
  for (std::size_t t = 0; t < 12; ++t) {
    EXPECT_EQ(file.unpacked().mesh.triangles[t].corners, plain.mesh.triangles[t].corners);
  }
  file.primitive()["mode"] = 5;
  EXPECT_EQ(file.unpacked().mesh.triangles.size(), 12u) << "of a strip, triangles as well";
  file.primitive()["attributes"]["_BATCHID"] = 2;
  file.text["accessors"].push_back({{"componentType", 5126}, {"type", "SCALAR"}, {"count", 8}});
  file.extension()["attributes"]["_BATCHID"] = 6;
  file.mesh.attributes[6] = {5121, 1, std::vector<double>(8, 7)};
  EXPECT_EQ(file.unpacked().feature, std::vector<std::int64_t>(12, 7));
}

TEST(ReadGltf, ReadsWhatIsThereUnpackedTooWithAndWithoutADecoder) {
  GltfFile file(support::cuboid(kBox));
  file.text["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", 0}, {"attributes", {{"POSITION", 5}}}};
  const DracoDecoder none = [](std::string_view, const std::string& source) -> DracoMesh {
    throw InputError(source, {.says = "nothing to unpack"});
  };
  EXPECT_EQ(read(file).mesh.triangles.size(), 12u);
  EXPECT_EQ(read_gltf(file.bytes(), "a.glb", no_file, {}, none).mesh.triangles.size(), 12u);
}

TEST(ReadGltf, RefusesWhatDracoHasOtherwiseThanTheFileSays) {
  const PackedFile good;
  expect_refusal(good.bytes(), "it requires the extension KHR_draco_mesh_compression");
  PackedFile file = good;
  file.text.erase("extensionsRequired");
  expect_refusal(file.bytes(), "its numbers are compressed, or missing");
  file = good;
  file.text["accessors"][0]["count"] = 9;
  file.expect_refusal("expected 9 rows of 3, found 8 rows of 3 in what Draco compressed");
  file = good;
  file.text["accessors"][1]["count"] = 39;
  file.expect_refusal("expected 39 indices, found 36 in what Draco compressed");
  file = good;
  file.mesh.corners[7] = 8;
  file.expect_refusal("expected indices below 8, the number of its vertices, found 8");
  file = good;
  file.mesh.attributes[5].values[4] = std::numeric_limits<double>::quiet_NaN();
  file.expect_refusal("expected numbers, found nan");
  file = good;
  file.mesh.attributes[5].columns = 4;
  file.expect_refusal("rows of 4 in what Draco compressed");
  file = good;
  file.text["accessors"][0]["normalized"] = true;
  file.text["accessors"][0]["componentType"] = 5120;
  file.expect_refusal("it is normalised, and expected component type 5120, found 5126");
  file = good;
  file.extension()["attributes"]["POSITION"] = 4;
  file.expect_refusal("expected its POSITION in what Draco compressed, found none");
  file = good;
  file.primitive()["mode"] = 6;
  file.expect_refusal("expected no fan");
  file = good;
  file.binary = "cubo";
  file.expect_refusal("not packed");
  file = good;
  file.extension() = 1;
  file.expect_refusal("expected an object, found 1");
}

TEST(ReadGltf, RefusesWhatMovesOrMultipliesAMesh) {
  const GltfFile good(support::cuboid(kBox));
  GltfFile file = good;
  file.text["animations"] = json::array({{{"channels", json::array()}}});
  expect_refusal(file, "it has animations");
  file = good;
  file.text["nodes"][0]["skin"] = 0;
  expect_refusal(file, "a skin moves its mesh");
  file = good;
  file.text["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"] = json::object();
  expect_refusal(file, "EXT_mesh_gpu_instancing");
  file = good;
  file.text["meshes"][0]["primitives"][0]["targets"] = json::array();
  expect_refusal(file, "morph targets");
  for (const char* extension : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "X"}) {
    file = good;
    file.text["extensionsRequired"] = {extension};
    expect_refusal(file, std::string("it requires the extension ") + extension);
  }
  file = good;
  file.text["extensions"]["CESIUM_RTC"]["center"] = {1, 2, 3};
  expect_refusal(file, "CESIUM_RTC");
}

TEST(ReadGltf, RefusesNodesWithinThemselves) {
  GltfFile file(support::cuboid(kBox));
  file.text["nodes"] = json::parse(R"([{"mesh": 0, "children": [1]}, {"children": [0]}])");
  expect_refusal(file, "node 0: it is within itself");
  file.text["nodes"] = json::parse(R"([{"mesh": 0, "children": [1, 1]}, {}])");
  expect_refusal(file, "in two nodes");
  file.text["nodes"] = json::parse(R"([{"mesh": 0, "children": [5]}])");
  expect_refusal(file, "there is no node 5, but 1 of them");
}

TEST(ReadGltf, RefusesNumbersThatLie) {
  const GltfFile good(support::cuboid(kBox));
  const auto refused = [&](const char* list, std::size_t i, const char* key, const json& value,
                           const char* message) {
    GltfFile file = good;
    file.text[list][i][key] = value;
    expect_refusal(file, message);
  };
  refused("accessors", 0, "count", 9, "expected 9 values within the 96 bytes of its view");
  refused("accessors", 0, "count", 18446744073709551615u, "values within the 96 bytes");
  refused("accessors", 0, "byteOffset", 97, "values within the 96 bytes");
  refused("accessors", 0, "count", -1, "expected a whole number as \"count\", found -1");
  refused("accessors", 0, "type", "VEC2", "expected type VEC3");
  refused("accessors", 0, "componentType", 5124, "expected a component type of glTF");
  refused("accessors", 0, "sparse", json::object(), "sparse");
  refused("accessors", 1, "count", 35, "expected three indices for each triangle, found 35");
  refused("bufferViews", 0, "byteLength", 1000, "within the 240 bytes of its buffer");
  refused("bufferViews", 0, "byteOffset", 18446744073709551615u, "of its buffer");
  refused("bufferViews", 0, "byteStride", 4, "expected a stride from 12 to 255, found 4");
  refused("buffers", 0, "byteLength", 1e6, "expected a whole number");
  refused("buffers", 0, "byteLength", 1000000, "expected 1000000 bytes, as it says, found 240");
  refused("nodes", 0, "mesh", 1, "there is no mesh 1, but 1 of them");
  refused("nodes", 0, "scale", {1, 2}, "expected 3 numbers as \"scale\"");
  refused("nodes", 0, "rotation", {0, 0, 0, 2}, "expected a rotation of length 1, found 2");
  refused("nodes", 0, "matrix", std::vector<int>(16, 1), "expected a matrix whose last row");
}

TEST(ReadGltf, RefusesIndicesBeyondVerticesAndWhatIsNoNumber) {
  TriangleMesh mesh = support::cuboid(kBox);
  mesh.triangles[3].corners[2] = 8;
  expect_refusal(GltfFile(mesh), "expected indices below 8, the number of its vertices, found 8");
  mesh = support::cuboid(kBox);
  mesh.vertices[1].y() = std::numeric_limits<double>::quiet_NaN();
  expect_refusal(GltfFile(mesh), "expected numbers, found nan as value 1");
}

TEST(ReadGltf, RefusesContainersThatAreCutOrLie) {
  const std::string bytes = GltfFile(support::cuboid(kBox)).bytes();
  for (std::size_t n = 4; n < bytes.size(); n += 7) {
    EXPECT_NE(support::refusal_of([&] { read(bytes.substr(0, n)); }), "") << n;
  }
  expect_refusal(bytes + std::string(8, '\0'), "as it says");
  std::string other = bytes;
  other[4] = 1;
  expect_refusal(other, "expected a .glb of version 2, found version 1");
  other = bytes;
  other[15] = 1;
  expect_refusal(other, "a chunk of the .glb says");
  GltfFile file(support::cuboid(kBox));
  file.text["asset"]["version"] = "1.0";
  expect_refusal(file, "expected glTF version 2");
  expect_refusal("{}", "asset");
  expect_refusal("[]", "expected an object");
}

TEST(ReadGltf, RefusesFilesForLaterReaders) {
  GltfFile file(support::cuboid(kBox));
  file.text["asset"] = {{"version", "2.1"}, {"minVersion", "2.0"}};
  EXPECT_EQ(read(file).mesh.triangles.size(), 12u);
  file.text["asset"]["minVersion"] = "2.1";
  expect_refusal(file, "found minVersion \"2.1\"");
}

}  // namespace
}  // namespace geom
