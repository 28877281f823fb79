#include "geom/mesh/gltf.h"

#include <fmt/format.h>

#include <limits>
#include <ostream>
#include <utility>

#include "geom/archive/bytes.h"
#include "geom/base/error.h"
#include "geom/text/json_line.h"

namespace geom {
namespace {

constexpr std::size_t kMostBytes = 0xf0000000u;  // of the buffer: the file counts in 32 bits

template <class List, class F>
std::string joined(const List& list, const F& json_of) {
  std::string out;
  for (const auto& item : list) {
    if (!out.empty()) out += ',';
    out += json_of(item);
  }
  return out;
}

std::string json_of(const GltfMaterial& m) {
  const std::string named = m.name.empty() ? "" : "\"name\":" + json_text(m.name) + ',';
  const std::string emissive =
      m.emissive ? fmt::format(R"(,"emissiveFactor":[{}])", fmt::join(*m.emissive, ",")) : "";
  return fmt::format(
      R"({{{}"pbrMetallicRoughness":{{"baseColorFactor":[{:.3f},{:.3f},{:.3f},{}],"metallicFactor":0}}{}{}}})",
      named, m.colour[0], m.colour[1], m.colour[2], m.opacity, emissive,
      m.opacity < 1 ? R"(,"alphaMode":"BLEND","doubleSided":true)" : "");
}

std::string json_of(const GltfPrimitive& p) {
  std::string out = fmt::format(R"({{"attributes":{{"POSITION":{}}})", p.positions);
  if (p.indices) out += fmt::format(R"(,"indices":{})", *p.indices);
  out += fmt::format(R"(,"material":{})", p.material);
  if (p.mode != GltfMode::triangles) {
    out += fmt::format(R"(,"mode":{})", static_cast<int>(p.mode));
  }
  return out + '}';
}

}  // namespace

Vec3 to_gltf(const Vec3& enu) { return {enu.x(), enu.z(), -enu.y()}; }

void Gltf::require_room(std::size_t bytes) const {
  if (bin_.size() + bytes <= kMostBytes) return;
  throw InputError("glTF", "the mesh takes more than the 4 GB of a .glb: crop the map");
}

std::size_t Gltf::add_positions(std::size_t count, const std::function<Vec3(std::size_t)>& enu) {
  require_room(12 * count);
  Eigen::Vector3f low = Eigen::Vector3f::Constant(std::numeric_limits<float>::max());
  Eigen::Vector3f high = -low;
  const std::size_t begin = bin_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3f p = to_gltf(enu(i) - origin_).cast<float>();
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    for (int axis = 0; axis < 3; ++axis) append_bytes(bin_, p[axis]);
  }
  arrays_.push_back({begin, count, {{low, high}}});
  return arrays_.size() - 1;
}

std::size_t Gltf::add_indices(std::size_t count,
                              const std::function<std::size_t(std::size_t)>& at) {
  require_room(4 * count);
  const std::size_t begin = bin_.size();
  for (std::size_t i = 0; i < count; ++i) append_bytes(bin_, static_cast<std::uint32_t>(at(i)));
  arrays_.push_back({begin, count, std::nullopt});
  return arrays_.size() - 1;
}

std::size_t Gltf::add_material(GltfMaterial material) {
  materials_.push_back(std::move(material));
  return materials_.size() - 1;
}

void Gltf::add_node(std::string name, std::vector<GltfPrimitive> primitives) {
  nodes_.push_back({std::move(name), std::move(primitives)});
}

std::string Gltf::json_of(std::size_t array) const {
  const Array& a = arrays_[array];
  if (!a.extent) {
    return fmt::format(R"({{"bufferView":{},"componentType":5125,"count":{},"type":"SCALAR"}})",
                       array, a.count);
  }
  const auto& [low, high] = *a.extent;
  return fmt::format(
      R"({{"bufferView":{},"componentType":5126,"count":{},"type":"VEC3","min":[{},{},{}],"max":[{},{},{}]}})",
      array, a.count, low.x(), low.y(), low.z(), high.x(), high.y(), high.z());
}

std::string Gltf::json(std::string_view note) const {
  std::string out = R"({"asset":{"version":"2.0","generator":"skyway")";
  if (!note.empty()) out += R"(,"extras":{"note":)" + json_text(note) + '}';
  out += R"(},"scene":0,"scenes":[)";
  if (nodes_.empty()) return out + "{}]}";
  const Vec3 at = to_gltf(origin_);
  std::string shown, nodes, accessors, views;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const char* const comma = i ? "," : "";
    shown += fmt::format("{}{}", comma, i);
    nodes += fmt::format(R"({}{{"mesh":{},"name":{},"translation":[{},{},{}]}})", comma, i,
                         json_text(nodes_[i].name), at.x(), at.y(), at.z());
  }
  for (std::size_t i = 0; i < arrays_.size(); ++i) {
    const char* const comma = i ? "," : "";
    accessors += comma + json_of(i);
    views += fmt::format(R"({}{{"buffer":0,"byteOffset":{},"byteLength":{},"target":{}}})", comma,
                         arrays_[i].begin, (arrays_[i].extent ? 12 : 4) * arrays_[i].count,
                         arrays_[i].extent ? 34962 : 34963);
  }
  const auto mesh = [](const Node& node) {
    return fmt::format(R"({{"name":{},"primitives":[{}]}})", json_text(node.name),
                       joined(node.primitives, [](const auto& p) { return geom::json_of(p); }));
  };
  const auto material = [](const GltfMaterial& m) { return geom::json_of(m); };
  return out +
         fmt::format(
             R"({{"nodes":[{}]}}],"nodes":[{}],"meshes":[{}],"materials":[{}],"accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})",
             shown, nodes, joined(nodes_, mesh), joined(materials_, material), accessors, views,
             bin_.size());
}

// A chunk of JSON and, unless it is empty, one of bytes.
void Gltf::write(std::ostream& out, std::string_view note) const {
  std::string json = this->json(note);
  while (json.size() % 4) json += ' ';  // chunks are whole words; the buffer holds nothing else
  std::string head = "glTF";
  append_bytes(head, std::uint32_t{2});
  append_bytes(head,
               static_cast<std::uint32_t>(20 + json.size() + (bin_.empty() ? 0 : 8 + bin_.size())));
  append_bytes(head, static_cast<std::uint32_t>(json.size()));
  out << head << "JSON" << json;
  if (bin_.empty()) return;
  std::string chunk;
  append_bytes(chunk, static_cast<std::uint32_t>(bin_.size()));
  out << chunk << std::string_view("BIN\0", 4) << bin_;
}

}  // namespace geom
