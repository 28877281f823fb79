#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "geom/model/gltf_model.h"
#include "geom/model/model_format.h"
#include "geom/text/beginning.h"
#include "geom/text/excerpt.h"
#include "geom/text/parse_json.h"
#include "gltf_data.h"

namespace geom {
namespace {

using Transform = Eigen::Matrix4d;

constexpr std::size_t kDeepest = 1000;             // nodes in nodes
constexpr std::size_t kMostPlaced = 100000000;     // vertices, wherever nodes place them
constexpr std::size_t kMostTriangles = 300000000;  // no cover takes more

constexpr const char* kDraco = "KHR_draco_mesh_compression";

// Extensions that draw boxes, spheres and the like without a mesh, for physics and for tools.
constexpr const char* kShapes[] = {"KHR_implicit_shapes", "KHR_collision_shapes",
                                   "OMI_physics_shape", "OMI_collider"};

// Extensions that a file may require and that change no place of anything.
bool is_harmless(const std::string& extension) {
  static const std::set<std::string> kHarmless = {
      "KHR_mesh_quantization", "KHR_texture_transform",  "KHR_texture_basisu",
      "EXT_texture_webp",      "EXT_texture_avif",       "KHR_lights_punctual",
      "EXT_mesh_features",     "EXT_structural_metadata"};
  return extension.starts_with("KHR_materials_") || kHarmless.contains(extension);
}

Transform local_transform(const JsonMembers& node) {
  Transform out = Transform::Identity();
  if (const auto m = node.numbers("matrix", 16)) {
    for (Eigen::Index i = 0; i < 16; ++i) out(i % 4, i / 4) = (*m)[static_cast<std::size_t>(i)];
    if (out.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
      node.refuse({.expected = "a matrix whose last row is 0, 0, 0, 1"});
    }
    if (node.has("translation") || node.has("rotation") || node.has("scale")) {
      node.refuse({.expected = "a matrix, or translation, rotation and scale", .found = "both"});
    }
    return out;
  }
  if (const auto s = node.numbers("scale", 3)) {
    out.diagonal().head<3>() = Vec3((*s)[0], (*s)[1], (*s)[2]);
  }
  if (const auto q = node.numbers("rotation", 4)) {
    const Eigen::Quaterniond turn((*q)[3], (*q)[0], (*q)[1], (*q)[2]);
    if (!(std::abs(turn.norm() - 1) < 1e-2)) {
      node.refuse({.expected = "a rotation of length 1", .found = fmt::to_string(turn.norm())});
    }
    const Eigen::Matrix3d turned =
        turn.normalized().toRotationMatrix() * Eigen::Matrix3d(out.topLeftCorner<3, 3>());
    out.topLeftCorner<3, 3>() = turned;
  }
  if (const auto t = node.numbers("translation", 3)) {
    out.topRightCorner<3, 1>() = Vec3((*t)[0], (*t)[1], (*t)[2]);
  }
  return out;
}

class GltfReader {
 public:
  GltfReader(std::string_view bytes, std::string_view source, const ModelFiles& files,
             std::string_view path, const DracoDecoder& draco)
      : data_(bytes, std::string(source), files, path), draco_(draco) {
    model_.up = UpAxis::y;
    model_.unit = 1;
  }

  GltfModel read() {
    check_extensions();
    check_animations();
    visit_scene();
    count_unseen();
    count_shapes_without_mesh();
    return std::move(model_);
  }

 private:
  void check_extensions() const {
    if (data_.root().members("extensions").contains("CESIUM_RTC")) {
      data_.root().refuse({.says = "CESIUM_RTC moves the whole model, which glTF 2.0 does not say",
                           .advice = "not read"});
    }
    for (const nlohmann::json& name : data_.root().list("extensionsRequired")) {
      if (name.is_string() && is_harmless(name.get<std::string>())) continue;
      if (name == kDraco && draco_) continue;
      data_.root().refuse(
          {.says = fmt::format("it requires the extension {}, which is not read",
                               excerpt(name.is_string() ? name.get<std::string>() : "?", 60)),
           .advice =
               "write the file without it, for example with `gltf-transform copy in.glb out.glb`"});
    }
  }

  void check_animations() const {
    if (data_.root().list("animations").empty()) return;
    data_.root().refuse({.says = "it has animations, and obstacles stand still",
                         .advice = "write one state of it"});
  }

  void visit_scene() {
    const JsonMembers& root = data_.root();
    const std::size_t scenes = root.list("scenes").size();
    const Transform place = Transform::Identity();
    if (scenes == 0) {  // a library of nodes: all that are in no other
      std::set<std::uint64_t> inner;
      for (std::size_t i = 0; i < root.list("nodes").size(); ++i) {
        for (const auto& child : root.at("nodes", i, "node").list("children")) {
          if (child.is_number_unsigned()) inner.insert(child.get<std::uint64_t>());
        }
      }
      for (std::size_t i = 0; i < root.list("nodes").size(); ++i) {
        if (!inner.contains(i)) visit(i, place, 0);
      }
      return;
    }
    const JsonMembers scene = root.at("scenes", root.whole("scene", 0), "scene");
    for (const nlohmann::json& node : scene.list("nodes")) visit(number(scene, node), place, 0);
  }

  std::uint64_t number(const JsonMembers& of, const nlohmann::json& value) const {
    if (!value.is_number_unsigned()) of.refuse({.expected = "the numbers of nodes"});
    return value.get<std::uint64_t>();
  }

  void visit(std::uint64_t i, const Transform& above, std::size_t depth) {
    const JsonMembers node = data_.root().at("nodes", i, "node");
    if (!seen_.insert(i).second || depth > kDeepest) {
      node.refuse({.says = "it is within itself, in two nodes, or more than 1,000 deep"});
    }
    if (node.has("skin"))
      node.refuse({.says = "a skin moves its mesh", .advice = "write one state of it"});
    if (node.members("extensions").contains("EXT_mesh_gpu_instancing")) {
      node.refuse({.says = "EXT_mesh_gpu_instancing multiplies its mesh, which is not read"});
    }
    const Transform place = above * local_transform(node);
    if (const auto mesh = node.find_whole("mesh")) add_mesh(node, i, *mesh, place);
    for (const nlohmann::json& child : node.list("children")) {
      visit(number(node, child), place, depth + 1);
    }
  }

  void add_mesh(const JsonMembers& node, std::uint64_t i, std::uint64_t number,
                const Transform& place) {
    const JsonMembers mesh = data_.root().at("meshes", number, "mesh");
    shown_.insert(number);
    std::string name = node.find_text("name").value_or("");
    if (name.empty()) name = mesh.find_text("name").value_or("");
    if (name.empty()) name = fmt::format("node {}", i);
    const std::size_t before = model_.mesh.triangles.size();
    for (std::size_t k = 0; k < mesh.list("primitives").size(); ++k) {
      add_primitive(mesh.at("primitives", k, fmt::format("mesh {}, primitive", number)), place);
    }
    if (model_.mesh.triangles.size() > before) model_.parts.push_back(std::move(name));
  }

  void add_primitive(const JsonMembers& primitive, const Transform& place) {
    const std::uint64_t mode = primitive.whole("mode", 4);
    if (mode < 4) {
      model_.skipped.add("points or lines", fmt::format("mode {}", mode));
      return;
    }
    if (mode > 6) primitive.refuse({.expected = "a mode of glTF", .found = fmt::to_string(mode)});
    if (primitive.has("targets")) {
      primitive.refuse(
          {.says = "morph targets move its vertices", .advice = "write one state of it"});
    }
    const JsonMembers attributes(primitive.members("attributes"), data_.source(), "attributes");
    const auto positions = attributes.find_whole("POSITION");
    if (!positions) primitive.refuse({.says = "it has no positions"});
    const bool packed =
        draco_ && !data_.has_rows(*positions) && primitive.members("extensions").contains(kDraco);
    const Drawn drawn = packed ? unpacked(primitive, attributes, *positions, mode)
                               : plain(primitive, attributes, *positions);
    for (const std::uint64_t v : drawn.order) {
      if (v < drawn.vertices.count()) continue;
      primitive.refuse({.expected = fmt::format("indices below {}, the number of its vertices",
                                                drawn.vertices.count()),
                        .found = fmt::to_string(v)});
    }
    if (feature_name(attributes) && drawn.features.size() < drawn.vertices.count()) {
      attributes.refuse({.expected = "a feature for each vertex"});
    }
    add_triangles(primitive, packed ? 4 : mode, drawn.order,
                  add_vertices(primitive, drawn.vertices, place), drawn.features);
  }

  struct Drawn {
    GltfData::Numbers vertices;
    std::vector<std::uint64_t> order;  // of vertices, as the mode makes triangles of them
    std::vector<double> features;      // of each vertex; empty where the file names none
  };

  Drawn plain(const JsonMembers& primitive, const JsonMembers& attributes,
              std::uint64_t positions) {
    Drawn out;
    out.vertices = data_.numbers(positions, "VEC3");
    if (const auto indices = primitive.find_whole("indices")) {
      for (const double v : data_.numbers(*indices, "SCALAR").values) {
        if (v < 0 || v != std::floor(v)) primitive.refuse({.expected = "whole numbers as indices"});
        out.order.push_back(static_cast<std::uint64_t>(v));
      }
    } else {
      for (std::size_t k = 0; k < out.vertices.count(); ++k) out.order.push_back(k);
    }
    if (const auto name = feature_name(attributes)) {
      out.features = data_.numbers(attributes.whole(name), "SCALAR").values;
    }
    return out;
  }

  // Draco gives triangles, also of what was a strip.
  Drawn unpacked(const JsonMembers& primitive, const JsonMembers& attributes,
                 std::uint64_t positions, std::uint64_t mode) {
    if (mode == 6)
      primitive.refuse({.expected = "no fan in what Draco compressed", .found = "one"});
    const JsonMembers packed(primitive.members("extensions").at(kDraco), data_.source(), kDraco);
    const JsonMembers numbers(packed.members("attributes"), data_.source(), kDraco);
    const DracoMesh mesh = draco_(data_.view(packed.whole("bufferView")), data_.source());
    const auto rows = [&](const char* name, std::uint64_t accessor, const char* type) {
      const auto found = mesh.attributes.find(numbers.whole(name));
      if (found == mesh.attributes.end()) {
        numbers.refuse(
            {.expected = fmt::format("its {} in what Draco compressed", name), .found = "none"});
      }
      return data_.numbers(accessor, type, found->second);
    };
    Drawn out{rows("POSITION", positions, "VEC3"), mesh.corners, {}};
    const auto indices = primitive.find_whole("indices");
    if (mode == 4 && indices) {
      const JsonMembers a = data_.root().at("accessors", *indices, "accessor");
      if (a.whole("count") != out.order.size()) {
        a.refuse({.expected = fmt::format("{} indices", a.whole("count")),
                  .found = fmt::format("{} in what Draco compressed", out.order.size())});
      }
    }
    if (const char* name = feature_name(attributes)) {
      const std::uint64_t accessor = attributes.whole(name);
      out.features = numbers.has(name) ? rows(name, accessor, "SCALAR").values
                                       : data_.numbers(accessor, "SCALAR").values;
    }
    return out;
  }

  // The attribute that names the feature of each vertex; null where there is none.
  static const char* feature_name(const JsonMembers& attributes) {
    for (const char* name : {"_BATCHID", "_FEATURE_ID_0"}) {
      if (attributes.has(name)) return name;
    }
    return nullptr;
  }

  std::uint32_t add_vertices(const JsonMembers& primitive, const GltfData::Numbers& vertices,
                             const Transform& place) {
    std::vector<Vec3>& out = model_.mesh.vertices;
    const std::size_t first = out.size();
    if (first + vertices.count() > kMostPlaced) {
      primitive.refuse({.says = fmt::format("more than {} vertices, each where its nodes place it",
                                            kMostPlaced)});
    }
    for (std::size_t k = 0; k < vertices.count(); ++k) {
      const Vec3 p(vertices.values[3 * k], vertices.values[3 * k + 1], vertices.values[3 * k + 2]);
      out.push_back(place.topLeftCorner<3, 3>() * p + place.topRightCorner<3, 1>());
    }
    return static_cast<std::uint32_t>(first);
  }

  void add_triangles(const JsonMembers& primitive, std::uint64_t mode,
                     const std::vector<std::uint64_t>& order, std::uint32_t first,
                     const std::vector<double>& features) {
    const std::size_t more = mode == 4 ? order.size() / 3 : order.size();
    if (model_.mesh.triangles.size() + more > kMostTriangles) {
      primitive.refuse({.says = fmt::format("more than {} triangles, each where its nodes place it",
                                            kMostTriangles)});
    }
    const auto part = static_cast<std::uint32_t>(model_.parts.size());
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      const auto at = [&](std::size_t k) { return first + static_cast<std::uint32_t>(order[k]); };
      model_.mesh.triangles.push_back({{at(a), at(b), at(c)}, part});
      const double feature = features.empty() ? -1 : features[order[a]];
      model_.feature.push_back(feature >= 0 && feature < 1e15 ? std::llround(feature) : -1);
    };
    const std::size_t n = order.size();
    if (mode == 4) {
      if (n % 3 != 0) {
        primitive.refuse(
            {.expected = "three indices for each triangle", .found = fmt::to_string(n)});
      }
      for (std::size_t k = 0; k < n; k += 3) add(k, k + 1, k + 2);
    }
    if (n < 3) return;
    for (std::size_t k = 0; mode == 5 && k + 2 < n; ++k) add(k, k + 1 + k % 2, k + 2 - k % 2);
    for (std::size_t k = 1; mode == 6 && k + 1 < n; ++k) add(0, k, k + 1);
  }

  // A body of physics may have no mesh.
  void count_shapes_without_mesh() {
    const auto found = data_.root().members("extensions");
    const auto& used = data_.root().list("extensionsUsed");
    for (const char* name : kShapes) {
      const bool listed = std::find(used.begin(), used.end(), name) != used.end();
      if (listed || found.contains(name)) model_.skipped.add("shapes without a mesh", name);
    }
  }

  // What is in the file, and in no node of the scene: a mesh may be shown, and stand elsewhere too.
  void count_unseen() {
    for (std::size_t i = 0; i < data_.root().list("nodes").size(); ++i) {
      const JsonMembers node = data_.root().at("nodes", i, "node");
      const auto mesh = node.find_whole("mesh");
      if (!mesh || seen_.contains(i)) continue;
      shown_.insert(*mesh);
      model_.skipped.add("node that the scene does not show",
                         node.find_text("name").value_or(fmt::format("{}", i)));
    }
    const std::size_t meshes = data_.root().list("meshes").size();
    for (std::size_t i = 0; i < meshes; ++i) {
      if (shown_.contains(i)) continue;
      const auto name = data_.root().at("meshes", i, "mesh").find_text("name");
      model_.skipped.add("mesh that the scene does not show", name.value_or(fmt::format("{}", i)));
    }
  }

  GltfData data_;
  const DracoDecoder& draco_;
  GltfModel model_;
  std::set<std::uint64_t> seen_;   // nodes
  std::set<std::uint64_t> shown_;  // meshes
};

}  // namespace

GltfModel read_gltf(std::string_view bytes, std::string_view source, const ModelFiles& files,
                    std::string_view path, const DracoDecoder& draco) {
  return GltfReader(bytes, source, files, path, draco).read();
}

namespace {

LoadedModel load_gltf(const ModelFile& file) {
  return {read_gltf(file.bytes, file.path, file.files, {}, file.decoders.draco)};
}

// JSON that is no tileset.
bool may_be_gltf(std::string_view bytes, const std::string& path) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != bytes.npos && bytes[first] == '{' && !parse_json(bytes, path).contains("root");
}

constexpr std::string_view kReaders[] = {"skyway-mesh"};
constexpr std::string_view kReadersOfGlb[] = {"skyway-check", "skyway-import-trajectory",
                                              "skyway-mesh"};
constexpr Format kGltf{
    .what = "a glTF model", .begins = json_with<R"("bufferViews":)">, .readers = kReaders};
constexpr const Format* kKinds[] = {&kGltf};

}  // namespace

constinit const Format kGlbFile{.word = "gltf",
                                .what = "a binary glTF",
                                .begins = begins_with<"glTF">,
                                .readers = kReadersOfGlb};

constinit const ModelFormat kGltfModel{
    .format = &kGlbFile, .kinds = kKinds, .may_be = may_be_gltf, .read = load_gltf};

}  // namespace geom
