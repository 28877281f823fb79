#include "sdf_meshes.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/base/error.h"
#include "geom/base/text_stream.h"
#include "geom/mesh/triangle_cover.h"
#include "sdf_collada.h"
#include "sdf_loader.h"

namespace geom {
namespace {

constexpr double kOfBlur = 2.7321;  // of the slack: beside the triangles, and over a corner

std::string ending_of(std::string_view uri) {
  std::string ending(uri.substr(std::min(uri.rfind('.'), uri.size())));
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending;
}

Vec3 scale_of(const SdfNode& mesh) {
  const auto given = mesh.find("scale");
  if (!given) return Vec3::Ones();
  const std::vector<double> v = given->numbers(3);
  if (std::count(v.begin(), v.end(), 0.0) > 0)
    given->refuse({.says = "<scale> must not be 0", .found = "0"});
  return {v[0], v[1], v[2]};
}

// How simulators may show a COLLADA file in different ways; empty where they agree, and of others.
std::string collada_difference(const SdfFile& file, const std::string& ending) {
  if (ending != ".dae") return {};
  const XmlElement root = parse_xml(file.text, file.name);
  try {
    require_simulators_agree({&root, &file.name});
  } catch (const InputError& problem) {
    return problem.what();
  }
  return {};
}

}  // namespace

bool SdfMeshes::skips(const SdfNode& mesh) {
  const auto skip = [&](const char* kind, const SdfNode& at) {
    skipped_.add(kind, sdf_place(at, at.name()));
    return true;
  };
  if (!mesh.attribute("optimization").empty()) return skip("convex shape of a mesh", mesh);
  for (const XmlElement& child : mesh.element->children) {
    if (child.prefix.empty() && (child.name == "uri" || child.name == "scale")) continue;
    return skip(child.name == "submesh" ? "part of a mesh" : "unknown element", mesh.of(child));
  }
  return false;
}

SdfMeshes::MeshFile SdfMeshes::read(const SdfFile& file, const std::string& ending) const {
  MeshFile out{file.name, {}, collada_difference(file, ending)};
  if (!out.unlike.empty() || (ending == ".dae" && !options_.read_collada)) return out;
  TextInput in(file.text);
  out.model = ending == ".dae"   ? options_.read_collada(file)
              : ending == ".obj" ? read_obj(in, file.name)
                                 : read_stl(in, file.name);
  if (out.model.mesh.triangles.empty() && out.model.skipped.empty()) {
    throw InputError(file.name, {.expected = "triangles", .found = "none"});
  }
  return out;
}

const SdfMeshes::MeshFile* SdfMeshes::find(const SdfNode& uri) {
  const std::string name(uri.text());
  const std::string ending = ending_of(name);
  const auto skip = [&](const char* kind, const std::string& which) {
    skipped_.add(kind, which);
    return nullptr;
  };
  if (ending != ".obj" && ending != ".stl" && ending != ".dae") {
    return skip("mesh that is not OBJ, STL or COLLADA", sdf_place(uri, name));
  }
  const SdfFile* file = options_.open_mesh ? options_.open_mesh(name, *uri.source) : nullptr;
  if (!file) return skip("mesh that is not found", sdf_place(uri, name));
  auto known = files_.find(file->name);
  if (known == files_.end()) known = files_.emplace(file->name, read(*file, ending)).first;
  const MeshFile& mesh = known->second;
  if (!mesh.unlike.empty()) return skip("mesh that simulators show in different ways", mesh.unlike);
  if (ending == ".dae" && !options_.read_collada) {
    return skip("COLLADA mesh, which this program was built without", sdf_place(uri, name));
  }
  return &mesh;
}

std::vector<Aabb> SdfMeshes::boxes_of(const SdfNode& mesh, const SdfPose& pose) {
  if (skips(mesh)) return {};
  const Vec3 scale = scale_of(mesh);
  const MeshFile* file = find(mesh.child("uri"));
  if (!file) return {};
  skipped_.add_of(file->name, file->model.skipped);
  return covered(*file, scale, pose, mesh);
}

std::vector<Aabb> SdfMeshes::covered(const MeshFile& file, const Vec3& scale, const SdfPose& pose,
                                     const SdfNode& mesh) const {
  TriangleMesh turned = file.model.mesh;
  double reach = 0;
  for (Vec3& v : turned.vertices) {
    v = v.cwiseProduct(scale);
    reach = std::max(reach, v.norm());
    v = pose.turn * v;
  }
  SdfPose placed = pose;
  if (scale != Vec3::Ones()) placed.shift_error += 1e-15 * reach;  // a product's rounding, and more
  require_known_place(placed, reach, options_.slack, mesh);
  // A vertex may be off by so much; a box that grows by it reaches sqrt(3) as far over a corner.
  const double blur = 1.7321 * file.model.blur * scale.cwiseAbs().maxCoeff();
  TriangleCoverOptions options;
  options.slack = 0.98 * options_.slack - kOfBlur * blur;
  if (!(options.slack > options_.slack / 2)) {
    mesh.refuse(
        {.says = fmt::format("the triangles of {} are known to {:.3g} m only", file.name, blur),
         .advice = fmt::format("give a slack of at least {:.3g} m", 1.01 * kOfBlur * blur / 0.48)});
  }
  options.fill = SolidFill::inside;
  std::vector<Aabb> out;
  try {
    out = cover_triangles(turned, options).boxes;
  } catch (const InputError& problem) {
    mesh.refuse(problem.as_item());
  }
  placed.shift_error += blur;
  for (Aabb& box : out) box = shifted(placed, box, reach);
  return out;
}

}  // namespace geom
