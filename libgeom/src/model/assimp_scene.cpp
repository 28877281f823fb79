#include "geom/model/assimp_scene.h"

#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <set>

#include "collada_links.h"
#include "geom/base/error.h"
#include "geom/base/loaded_library.h"
#include "geom/model/model_format.h"
#include "geom/model/model_polygons.h"
#include "geom/text/excerpt.h"
#include "try_in_child.h"

namespace geom {
namespace {

using Transform = Eigen::Matrix4d;

constexpr double kUnit = 0x1p-23;  // of single precision
constexpr std::size_t kMostVertices = 100000000;

Transform transform_of(const aiMatrix4x4& m) {
  Transform out;
  out << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3,
      m.d4;
  return out;
}

class Scene {
 public:
  Scene(const aiScene& scene, const std::string& source) : scene_(scene), source_(source) {}

  Model model() {
    check();
    model_.up = UpAxis::z;
    visit(*scene_.mRootNode, Transform::Identity(), Transform::Identity(), 0);
    polygons_.finish(model_);
    return std::move(model_);
  }

  // Of all meshes that a node shows, each once; after model().
  std::size_t polygons() const {
    std::size_t sum = 0;
    for (const unsigned i : shown_) {
      const aiMesh& mesh = *scene_.mMeshes[i];
      sum += static_cast<std::size_t>(
          std::count_if(mesh.mFaces, mesh.mFaces + mesh.mNumFaces,
                        [](const aiFace& face) { return face.mNumIndices >= 3; }));
    }
    return sum;
  }

 private:
  [[noreturn]] void refuse(Fault fault) const { throw InputError(source_, std::move(fault)); }

  void check() const {
    if (scene_.mNumAnimations > 0) {
      refuse({.says = "it has animations, and obstacles stand still",
              .advice = "write one state of it"});
    }
    for (unsigned i = 0; i < scene_.mNumMeshes; ++i) {
      const aiMesh& mesh = *scene_.mMeshes[i];
      if (mesh.HasBones() || mesh.mNumAnimMeshes > 0) {
        refuse({.says = fmt::format("mesh \"{}\" is moved by bones or morphs",
                                    excerpt(mesh.mName.C_Str())),
                .advice = "write one state of it"});
      }
    }
  }

  // `size`: of all numbers that a place is made of, which its rounding follows.
  void visit(const aiNode& node, const Transform& above, const Transform& size_above, int depth) {
    if (depth > 500) refuse({.expected = "nodes that are less than 500 deep"});
    const Transform local = transform_of(node.mTransformation);
    const Transform place = above * local;
    const Transform size = size_above * local.cwiseAbs();
    const std::size_t before = model_.mesh.triangles.size();
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      shown_.insert(node.mMeshes[i]);
      add_mesh(*scene_.mMeshes[node.mMeshes[i]], place, size, depth);
    }
    if (model_.mesh.triangles.size() > before) model_.parts.emplace_back(node.mName.C_Str());
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      visit(*node.mChildren[i], place, size, depth + 1);
    }
  }

  void add_mesh(const aiMesh& mesh, const Transform& place, const Transform& size, int depth) {
    const std::size_t first = model_.mesh.vertices.size();
    if (first + mesh.mNumVertices > kMostVertices) refuse({.says = "more than 1e8 vertices"});
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D& v = mesh.mVertices[i];
      const Eigen::Vector4d p(v.x, v.y, v.z, 1);
      const Eigen::Vector4d placed = place * p;
      model_.mesh.vertices.push_back(z_up_of_y_up(placed.head<3>()));
      const double off = 16 * (depth + 2) * kUnit * (size * p.cwiseAbs()).head<3>().maxCoeff();
      model_.blur = std::max(model_.blur, off);
    }
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      add_face(mesh.mFaces[i], mesh.mNumVertices, first);
    }
  }

  void add_face(const aiFace& face, unsigned vertices, std::size_t first) {
    if (face.mNumIndices < 3) {
      model_.skipped.add("point or line", fmt::format("of {} vertices", face.mNumIndices));
      return;
    }
    std::vector<std::uint32_t> index;
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
      if (face.mIndices[k] >= vertices) refuse({.says = "a face names a vertex that is not there"});
      index.push_back(static_cast<std::uint32_t>(first) + face.mIndices[k]);
    }
    polygons_.add(model_, index, static_cast<std::uint32_t>(model_.parts.size()));
  }

  const aiScene& scene_;
  const std::string& source_;
  Model model_;
  ModelPolygons polygons_;
  std::set<unsigned> shown_;  // meshes
};

// The sum of the counts that COLLADA's elements of polygons name, each once.
std::size_t polygons_of_collada(std::string_view text) {
  std::size_t sum = 0;
  for (const std::string_view element : {"<triangles", "<polylist", "<polygons"}) {
    for (std::size_t at = 0; (at = text.find(element, at)) != std::string_view::npos;) {
      at += element.size();
      const std::string_view tag = text.substr(at, text.find('>', at) - at);
      const std::size_t count = tag.find("count=");
      if (count == std::string_view::npos || count + 7 >= tag.size()) continue;
      sum += std::strtoull(std::string(tag.substr(count + 7, 20)).c_str(), nullptr, 10);
    }
  }
  return sum;
}

// A master scale, which assimp divides by and other programs pass over.
void require_no_scale(std::string_view chunk, const std::string& source) {
  float scale = 0;
  if (chunk.size() >= sizeof scale) std::memcpy(&scale, chunk.data(), sizeof scale);
  if (scale == 1) return;
  throw InputError(source, {.expected = "a 3DS file whose master scale is 1",
                            .found = fmt::to_string(scale),
                            .advice = "programs differ in what it means"});
}

// Calls f(id, content) for each chunk of a 3DS file, and for those within others.
template <class F>
void for_each_chunk(std::string_view bytes, const std::string& source, const F& f, int depth = 0) {
  const auto word = [&](std::size_t at, std::size_t size) {
    std::uint32_t out = 0;
    std::memcpy(&out, bytes.data() + at, size);
    return out;
  };
  for (std::size_t at = 0; at + 6 <= bytes.size();) {
    const std::uint32_t id = word(at, 2);
    const std::size_t length = word(at + 2, 4);
    if (length < 6 || length > bytes.size() - at) {
      throw InputError(
          source, {.says = fmt::format("a chunk of the 3DS file says {} bytes, where {} are left",
                                       length, bytes.size() - at)});
    }
    std::string_view inner = bytes.substr(at + 6, length - 6);
    if (id == 0x4000) inner = inner.substr(std::min(inner.find('\0'), inner.size() - 1) + 1);
    f(id, inner);
    const bool nested = id == 0x4D4D || id == 0x3D3D || id == 0x4000 || id == 0x4100;
    if (nested && depth < 10) for_each_chunk(inner, source, f, depth + 1);
    at += length;
  }
}

// What a 3DS file holds, to compare with what assimp makes of it.
struct Told3ds {
  std::size_t faces = 0;
  std::vector<Vec3> vertices;
};

Told3ds told_by_3ds(std::string_view bytes, const std::string& source) {
  Told3ds out;
  for_each_chunk(bytes, source, [&](std::uint32_t id, std::string_view inner) {
    if (id == 0x0100) require_no_scale(inner, source);
    std::uint16_t count = 0;
    if (inner.size() >= sizeof count) std::memcpy(&count, inner.data(), sizeof count);
    if (id == 0x4120) out.faces += count;
    for (std::size_t i = 0; id == 0x4110 && i < count && 2 + 12 * (i + 1) <= inner.size(); ++i) {
      Eigen::Vector3f v;
      std::memcpy(v.data(), inner.data() + 2 + 12 * i, 12);
      out.vertices.push_back(v.cast<double>());
    }
  });
  return out;
}

// Keyframes may place a mesh elsewhere than its vertices are: some programs follow them, others
// pass over them. Looks for each vertex that assimp places in cells around those of the file.
void require_unmoved(const Model& model, const Told3ds& told, const std::string& source) {
  const double off = std::max(model.blur, 1e-9);
  using Cell = std::array<double, 3>;
  const auto cell_of = [&](const Vec3& v) {
    const Vec3 cell = (v / (4 * off)).array().floor();
    return Cell{cell.x(), cell.y(), cell.z()};
  };
  std::set<Cell> known;
  for (const Vec3& v : told.vertices) known.insert(cell_of(v));
  for (const Vec3& v : model.mesh.vertices) {
    bool there = false;
    for (int k = 0; k < 8 && !there; ++k) {
      const Vec3 side(k & 1 ? off : -off, k & 2 ? off : -off, k & 4 ? off : -off);
      there = known.contains(cell_of(v + side));
    }
    if (there) continue;
    throw InputError(
        source,
        {.expected = "meshes that stand where their vertices are",
         .found = fmt::format("one that its keyframes move, to [{}, {}, {}]", v.x(), v.y(), v.z()),
         .advice = "programs differ in what they show: apply the transforms, or write glTF"});
  }
}

// Loaded when it is needed: it takes longer to load than most imports, and few sources name a mesh
// that it reads.
struct Assimp {
  decltype(aiImportFileFromMemory)* import_file;
  decltype(aiReleaseImport)* release;
  decltype(aiGetErrorString)* error;
};

Assimp load_assimp() {
  const LoadedLibrary library(SKYWAY_ASSIMP_SONAME, "libassimp5");
  return {.import_file = SKYWAY_FUNCTION(library, aiImportFileFromMemory),
          .release = SKYWAY_FUNCTION(library, aiReleaseImport),
          .error = SKYWAY_FUNCTION(library, aiGetErrorString)};
}

// `told`: polygons that the file counts. `hint`: the ending by which assimp knows the format.
Model read_scene(const std::string& bytes, const std::string& source, const ModelFormat& format,
                 std::size_t told, const char* hint) {
  static const Assimp assimp = load_assimp();
  const auto read_file = [&] {
    return std::unique_ptr<const aiScene, decltype(assimp.release)>(
        assimp.import_file(bytes.data(), static_cast<unsigned>(bytes.size()), 0, hint),
        assimp.release);
  };
  try_in_child([&] { read_file(); }, "assimp", source);
  const auto scene = read_file();
  if (!scene || !scene->mRootNode) {
    throw InputError(
        source, {.expected = fmt::format("a file of format {}, which assimp could not read: {}",
                                         format.format->word, excerpt(assimp.error(), 120))});
  }
  Scene read(*scene, source);
  Model model = read.model();
  if (const std::size_t built = read.polygons(); built < told) {
    model.skipped.add("polygons that assimp did not give",
                      fmt::format("{} of {}", told - built, told));
  }
  return model;
}

}  // namespace

Model read_collada(const std::string& bytes, const std::string& source) {
  const std::size_t told = polygons_of_collada(bytes);
  Skipped skipped;
  check_collada_links(bytes, source, skipped);
  Model model = read_scene(bytes, source, kColladaModel, told, "dae");
  model.skipped.add(skipped);
  if (bytes.find("<ph>") != std::string::npos) model.skipped.add("polygon with holes", "<ph>");
  model.unit = 1;
  return model;
}

Model read_3ds(const std::string& bytes, const std::string& source) {
  const Told3ds told = told_by_3ds(bytes, source);
  Model model = read_scene(bytes, source, k3dsModel, told.faces, "3ds");
  require_unmoved(model, told, source);
  return model;
}

}  // namespace geom
