#include "geom/mesh/gltf.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

namespace geom {
namespace {

struct Glb {
  nlohmann::json json;
  std::string bin;
};

Glb read(const std::string& bytes) {
  const auto word = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
  };
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(word(4), 2u);
  EXPECT_EQ(word(8), bytes.size());
  EXPECT_EQ(word(12) % 4, 0u);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  Glb out{nlohmann::json::parse(bytes.substr(20, word(12))), {}};
  const std::size_t at = 20 + word(12);
  if (at == bytes.size()) return out;
  EXPECT_EQ(bytes.substr(at + 4, 4), std::string("BIN\0", 4));
  out.bin = bytes.substr(at + 8);
  EXPECT_EQ(out.bin.size(), word(at));
  return out;
}

std::string bytes_of(const Gltf& gltf, std::string_view note = {}) {
  std::ostringstream out;
  gltf.write(out, note);
  return out.str();
}

TEST(Gltf, KeepsPositionsAboutTheOriginWithTheirExtent) {
  const Vec3 points[] = {{500000, 4000000, 10}, {500001, 4000003, 12}};
  Gltf gltf(points[0]);
  GltfPrimitive line{GltfMode::line_strip, 0, {}, 0};
  line.positions = gltf.add_positions(2, [&](std::size_t i) { return points[i]; });
  line.material = gltf.add_material({{}, {0, 0, 0}, 1, Rgb{1, 0.4, 0}});
  gltf.add_node("line", {line});
  const auto [json, bin] = read(bytes_of(gltf, "a \"note\""));
  EXPECT_EQ(json["asset"]["extras"]["note"], "a \"note\"");
  EXPECT_EQ(json["nodes"][0]["translation"], nlohmann::json({500000.0, 10.0, -4000000.0}));
  float second[3];
  std::memcpy(second, bin.data() + 12, sizeof second);
  EXPECT_EQ(second[0], 1);
  EXPECT_EQ(second[1], 2);
  EXPECT_EQ(second[2], -3);
  EXPECT_EQ(json["accessors"][0]["min"], nlohmann::json({0, 0, -3}));
  EXPECT_EQ(json["accessors"][0]["max"], nlohmann::json({1, 2, 0}));
  const auto& primitive = json["meshes"][0]["primitives"][0];
  EXPECT_EQ(primitive["mode"], 3);
  EXPECT_FALSE(primitive.contains("indices"));
  EXPECT_EQ(json["materials"][0]["emissiveFactor"], nlohmann::json({1.0, 0.4, 0.0}));
}

TEST(Gltf, SharesPositionsBetweenPrimitives) {
  Gltf gltf(Vec3::Zero());
  const std::size_t positions =
      gltf.add_positions(3, [](std::size_t i) { return Vec3(static_cast<double>(i), 0, 0); });
  std::vector<GltfPrimitive> lines;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t indices = gltf.add_indices(2, [&](std::size_t i) { return i + k; });
    lines.push_back({GltfMode::lines, positions, indices, gltf.add_material({})});
  }
  gltf.add_node("tree", lines);
  const auto [json, bin] = read(bytes_of(gltf));
  EXPECT_EQ(bin.size(), 3u * 12 + 2 * 2 * 4);
  EXPECT_EQ(json["buffers"][0]["byteLength"], bin.size());
  ASSERT_EQ(json["meshes"][0]["primitives"].size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& primitive = json["meshes"][0]["primitives"][k];
    EXPECT_EQ(primitive["attributes"]["POSITION"], positions);
    const auto& accessor = json["accessors"][primitive["indices"].get<std::size_t>()];
    const auto& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    EXPECT_EQ(view["target"], 34963);
    std::uint32_t ends[2];
    std::memcpy(ends, bin.data() + view["byteOffset"].get<std::size_t>(), sizeof ends);
    EXPECT_EQ(ends[0], k);
    EXPECT_EQ(ends[1], k + 1);
  }
}

TEST(ToGltf, IsEastUpSouth) { EXPECT_EQ(to_gltf({1, 2, 3}), Vec3(1, 3, -2)); }

TEST(Gltf, OfNothingIsAnEmptyScene) {
  const auto [json, bin] = read(bytes_of(Gltf(Vec3::Zero())));
  EXPECT_EQ(json["scenes"], nlohmann::json::parse("[{}]"));
  EXPECT_TRUE(bin.empty());
}

}  // namespace
}  // namespace geom
