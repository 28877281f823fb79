#include "traj/export/gltf_line.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <istream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <ostream>

#include "geom/error.h"
#include "geom/io/bytes.h"
#include "geom/io/glb.h"
#include "geom/io/parse_json.h"

namespace traj {
namespace {

using Json = nlohmann::ordered_json;
using geom::Vec3;

Vec3 from_gltf(const Vec3& v) { return {v.x(), -v.z(), v.y()}; }

constexpr int kArrayBuffer = 34962;
constexpr int kFloat = 5126;
constexpr int kLineStrip = 3;

// The chunks of a .glb.
struct Chunks {
  Json json;
  std::string_view bin;
};

Chunks chunks_of(std::string_view bytes, std::string_view source) {
  const auto word = [&](std::size_t at) {
    std::uint32_t value = 0;
    if (at + 4 > bytes.size()) throw std::out_of_range("the file ends early");
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
  };
  if (!bytes.starts_with("glTF") || word(4) != 2) throw std::out_of_range("this is no glTF 2");
  const std::size_t json_size = word(12);
  const std::size_t bin_at = 20 + json_size;
  const std::size_t bin_size = word(bin_at);
  if (bin_at + 8 + bin_size > bytes.size()) throw std::out_of_range("the file ends early");
  return {geom::parse_ordered_json(bytes.substr(20, json_size), source),
          bytes.substr(bin_at + 8, bin_size)};
}

geom::Polyline points_of(const Chunks& chunks) {
  const Json& part = chunks.json.at("meshes").at(0).at("primitives").at(0);
  const std::size_t index = part.at("attributes").at("POSITION");
  const Json& accessor = chunks.json.at("accessors").at(index);
  const Json& at = chunks.json.at("nodes").at(0).at("translation");
  const Vec3 origin(at.at(0), at.at(1), at.at(2));
  const std::size_t count = accessor.at("count");
  if (accessor.at("componentType") != kFloat || count > chunks.bin.size() / 12) {
    throw std::out_of_range("expected three floats a point");
  }
  geom::Polyline points;
  for (std::size_t i = 0; i < count; ++i) {
    float v[3];
    std::memcpy(v, chunks.bin.data() + 12 * i, 12);
    points.push_back(from_gltf(origin + Vec3(v[0], v[1], v[2])));
    if (!(points.back().cwiseAbs().maxCoeff() <= geom::kLargestCoordinate)) {
      throw std::out_of_range("expected coordinates within 1e8 m");
    }
  }
  return points;
}

}  // namespace

void write_gltf_line(std::ostream& out, std::span<const geom::Vec3> enu, std::string_view name,
                     std::string_view note) {
  const Vec3 origin = geom::to_gltf(enu.front());
  Eigen::Vector3f low = Eigen::Vector3f::Zero();
  Eigen::Vector3f high = low;
  std::string bin;
  for (const Vec3& p : enu) {
    const Eigen::Vector3f v = (geom::to_gltf(p) - origin).cast<float>();
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
    for (int axis = 0; axis < 3; ++axis) geom::append_bytes(bin, v[axis]);
  }
  Json json;
  json["asset"] = {{"version", "2.0"}, {"generator", "skyway"}};
  if (!note.empty()) json["asset"]["extras"] = {{"note", std::string(note)}};
  json["scene"] = 0;
  json["scenes"] = {{{"nodes", {0}}}};
  json["nodes"] = {{{"mesh", 0},
                    {"name", std::string(name)},
                    {"translation", {origin.x(), origin.y(), origin.z()}}}};
  json["meshes"] = {
      {{"primitives",
        {{{"attributes", {{"POSITION", 0}}}, {"mode", kLineStrip}, {"material", 0}}}}}};
  json["materials"] = {
      {{"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 0, 1}}, {"metallicFactor", 0}}},
       {"emissiveFactor", {1.0, 0.4, 0.0}}}};
  json["accessors"] = {{{"bufferView", 0},
                        {"componentType", kFloat},
                        {"count", enu.size()},
                        {"type", "VEC3"},
                        {"min", {low.x(), low.y(), low.z()}},
                        {"max", {high.x(), high.y(), high.z()}}}};
  json["bufferViews"] = {
      {{"buffer", 0}, {"byteOffset", 0}, {"byteLength", bin.size()}, {"target", kArrayBuffer}}};
  json["buffers"] = {{{"byteLength", bin.size()}}};
  geom::write_glb_container(out, json.dump(-1, ' ', false, Json::error_handler_t::replace), bin);
}

geom::Polyline read_gltf_line(std::istream& in, std::string_view source) {
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  geom::Polyline points;
  try {
    points = points_of(chunks_of(bytes, source));
  } catch (const Json::exception&) {
    throw geom::InputError(source, "expected a glTF line, found other keys or values");
  } catch (const std::out_of_range& error) {
    throw geom::InputError(source, fmt::format("expected a glTF line: {}", error.what()));
  }
  if (points.empty()) throw geom::InputError(source, "expected a glTF line of points, found none");
  return points;
}

}  // namespace traj
