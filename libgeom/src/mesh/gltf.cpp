#include "geom/mesh/gltf.h"

#include <fmt/format.h>

#include <limits>
#include <numeric>
#include <ostream>
#include <tuple>
#include <utility>

#include "geom/archive/bytes.h"
#include "geom/base/error.h"
#include "geom/text/json_line.h"

namespace geom {
namespace {

constexpr std::size_t kMostBytes = 0xf0000000u;  // of the buffer: the file counts in 32 bits

// Numbers of a list, single precision in its own shortest text.
std::string list_of(const auto& numbers) { return fmt::format("[{}]", fmt::join(numbers, ",")); }

JsonLine object_of(const GltfMaterial& m) {
  const auto& [r, g, b] = m.colour;
  JsonLine surface;
  surface.add_json("baseColorFactor", fmt::format("[{:.3f},{:.3f},{:.3f},{}]", r, g, b, m.opacity));
  surface.add("metallicFactor", 0);
  JsonLine line;
  if (!m.name.empty()) line.add("name", m.name);
  line.add("pbrMetallicRoughness", surface);
  if (m.emissive) line.add_json("emissiveFactor", list_of(*m.emissive));
  if (m.opacity < 1) line.add("alphaMode", "BLEND").add("doubleSided", true);
  return line;
}

JsonLine object_of(const GltfPrimitive& p) {
  JsonLine line;
  line.add("attributes", JsonLine().add("POSITION", p.positions));
  line.add("indices", p.indices).add("material", p.material);
  if (p.mode != GltfMode::triangles) line.add("mode", static_cast<int>(p.mode));
  return line;
}

[[noreturn]] void refuse_size() {
  throw InputError(
      "glTF", {.says = "the mesh takes more than the 4 GB of a .glb", .advice = "crop the map"});
}

// The numbers below `count`.
std::vector<std::size_t> numbers_below(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

}  // namespace

Vec3 to_gltf(const Vec3& enu) { return {enu.x(), enu.z(), -enu.y()}; }

void Gltf::require_room(std::size_t bytes) const {
  if (bin_.size() + bytes > kMostBytes) refuse_size();
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

JsonLine Gltf::accessor(std::size_t array) const {
  const Array& a = arrays_[array];
  JsonLine line;
  line.add("bufferView", array).add("componentType", a.extent ? 5126 : 5125);
  line.add("count", a.count).add("type", a.extent ? "VEC3" : "SCALAR");
  if (!a.extent) return line;
  const auto& [low, high] = *a.extent;
  return line.add_json("min", list_of(low)).add_json("max", list_of(high));
}

JsonLine Gltf::view(std::size_t array) const {
  const Array& a = arrays_[array];
  JsonLine line;
  line.add("buffer", 0).add("byteOffset", a.begin);
  line.add("byteLength", (a.extent ? 12 : 4) * a.count);
  return line.add("target", a.extent ? 34962 : 34963);
}

std::string Gltf::json(std::string_view note) const {
  JsonLine asset;
  asset.add("version", "2.0").add("generator", "skyway");
  if (!note.empty()) asset.add("extras", JsonLine().add("note", note));
  JsonLine out;
  out.add("asset", asset).add("scene", 0);
  if (nodes_.empty()) return out.add("scenes", std::tuple(JsonLine())).object();
  const std::vector<std::size_t> nodes = numbers_below(nodes_.size());
  const std::vector<std::size_t> arrays = numbers_below(arrays_.size());
  out.add("scenes", std::tuple(JsonLine().add("nodes", nodes)));
  out.add("nodes", nodes, [&](std::size_t i) {
    return JsonLine()
        .add("mesh", i)
        .add("name", nodes_[i].name)
        .add_json("translation", list_of(to_gltf(origin_)));
  });
  const auto primitive = [](const GltfPrimitive& p) { return object_of(p); };
  out.add("meshes", nodes_, [&](const Node& node) {
    return JsonLine().add("name", node.name).add("primitives", node.primitives, primitive);
  });
  out.add("materials", materials_, [](const GltfMaterial& m) { return object_of(m); });
  out.add("accessors", arrays, [&](std::size_t i) { return accessor(i); });
  out.add("bufferViews", arrays, [&](std::size_t i) { return view(i); });
  out.add("buffers", std::tuple(JsonLine().add("byteLength", bin_.size())));
  return out.object();
}

// A chunk of JSON and, unless it is empty, one of bytes.
void Gltf::write(std::ostream& out, std::string_view note) const {
  std::string json = this->json(note);
  while (json.size() % 4) json += ' ';  // chunks are whole words; the buffer holds nothing else
  const std::size_t size = 20 + json.size() + (bin_.empty() ? 0 : 8 + bin_.size());
  if (size > std::numeric_limits<std::uint32_t>::max()) refuse_size();
  std::string head = "glTF";
  append_bytes(head, std::uint32_t{2});
  append_bytes(head, static_cast<std::uint32_t>(size));
  append_bytes(head, static_cast<std::uint32_t>(json.size()));
  out << head << "JSON" << json;
  if (bin_.empty()) return;
  std::string chunk;
  append_bytes(chunk, static_cast<std::uint32_t>(bin_.size()));
  out << chunk << std::string_view("BIN\0", 4) << bin_;
}

}  // namespace geom
