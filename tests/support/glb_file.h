#pragma once

// glTF files and tiles for tests, byte by byte.

#include <nlohmann/json.hpp>
#include <string>

#include "geom/archive/bytes.h"
#include "geom/mesh/triangle_mesh.h"

namespace support {

using nlohmann::json;

inline std::string padded(std::string bytes, char with) {
  bytes.resize((bytes.size() + 7) / 8 * 8, with);
  return bytes;
}

inline std::string glb(const json& text, const std::string& binary) {
  const std::string first = padded(text.dump(), ' ');
  const std::string second = padded(binary, '\0');
  std::string out = "glTF";
  geom::append_bytes(out, std::uint32_t{2});
  geom::append_bytes(out, static_cast<std::uint32_t>(12 + 8 + first.size() + 8 + second.size()));
  geom::append_bytes(out, static_cast<std::uint32_t>(first.size()));
  out += "JSON" + first;
  geom::append_bytes(out, static_cast<std::uint32_t>(second.size()));
  out += std::string("BIN\0", 4) + second;
  return out;
}

// One node, mesh and primitive of the triangles; positions as floats, then indices as 32 bits.
struct GltfFile {
  json text;
  std::string binary;

  explicit GltfFile(const geom::TriangleMesh& mesh) {
    for (const geom::Vec3& v : mesh.vertices) {
      for (int i = 0; i < 3; ++i) geom::append_bytes(binary, static_cast<float>(v[i]));
    }
    const std::size_t positions = binary.size();
    for (const geom::MeshTriangle& t : mesh.triangles) {
      for (const std::uint32_t i : t.corners) geom::append_bytes(binary, i);
    }
    text = json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
      "nodes": [{"name": "house", "mesh": 0}],
      "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3"},
                    {"bufferView": 1, "componentType": 5125, "type": "SCALAR"}],
      "bufferViews": [{"buffer": 0}, {"buffer": 0}], "buffers": [{}]})");
    text["accessors"][0]["count"] = mesh.vertices.size();
    text["accessors"][1]["count"] = 3 * mesh.triangles.size();
    text["bufferViews"][0]["byteLength"] = positions;
    text["bufferViews"][1]["byteOffset"] = positions;
    text["bufferViews"][1]["byteLength"] = binary.size() - positions;
    text["buffers"][0]["byteLength"] = binary.size();
  }

  std::string bytes() const { return glb(text, binary); }
};

inline std::string b3dm(const std::string& gltf, const json& features, const json& batch) {
  const std::string first = padded(features.dump(), ' ');
  const std::string second = batch.is_null() ? "" : padded(batch.dump(), ' ');
  std::string out = "b3dm";
  geom::append_bytes(out, std::uint32_t{1});
  geom::append_bytes(out,
                     static_cast<std::uint32_t>(28 + first.size() + second.size() + gltf.size()));
  geom::append_bytes(out, static_cast<std::uint32_t>(first.size()));
  geom::append_bytes(out, std::uint32_t{0});
  geom::append_bytes(out, static_cast<std::uint32_t>(second.size()));
  geom::append_bytes(out, std::uint32_t{0});
  return out + first + second + gltf;
}

}  // namespace support
