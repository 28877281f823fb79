#include "sdf_meshes.h"

#include <algorithm>
#include <sstream>

#include "geom/base/error.h"
#include "geom/mesh/triangle_cover.h"
#include "sdf_loader.h"

namespace geom {
namespace {

std::string ending_of(std::string_view uri) {
  std::string ending(uri.substr(std::min(uri.rfind('.'), uri.size())));
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending;
}

Vec3 scale_of(const SdfNode& mesh) {
  const auto given = mesh.find("scale");
  if (!given) return Vec3::Ones();
  const std::vector<double> v = given->numbers(3);
  if (std::count(v.begin(), v.end(), 0.0) > 0) given->refuse("<scale> must not be 0, found 0");
  return {v[0], v[1], v[2]};
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

const SdfMeshes::MeshFile* SdfMeshes::find(const SdfNode& uri) {
  const std::string name(uri.text());
  const std::string ending = ending_of(name);
  if (ending != ".obj" && ending != ".stl") {
    skipped_.add("mesh that is neither OBJ nor STL", sdf_place(uri, name));
    return nullptr;
  }
  const SdfFile* file = options_.open_mesh ? options_.open_mesh(name, *uri.source) : nullptr;
  if (!file) {
    skipped_.add("mesh that is not found", sdf_place(uri, name));
    return nullptr;
  }
  const auto known = files_.find(file->name);
  if (known != files_.end()) return &known->second;
  std::istringstream in(file->text);
  Model model = ending == ".obj" ? read_obj(in, file->name) : read_stl(in, file->name);
  if (model.mesh.triangles.empty() && model.skipped.empty()) {
    throw InputError(file->name, "expected triangles, found none");
  }
  return &(files_[file->name] = {file->name, std::move(model)});
}

std::vector<Aabb> SdfMeshes::boxes_of(const SdfNode& mesh, const SdfPose& pose) {
  if (skips(mesh)) return {};
  const Vec3 scale = scale_of(mesh);
  const MeshFile* file = find(mesh.child("uri"));
  if (!file) return {};
  skipped_.add_of(file->name, file->model.skipped);
  TriangleMesh turned = file->model.mesh;
  double reach = 0;
  for (Vec3& v : turned.vertices) {
    v = v.cwiseProduct(scale);
    reach = std::max(reach, v.norm());
    v = pose.turn * v;
  }
  SdfPose placed = pose;
  if (scale != Vec3::Ones()) placed.shift_error += 1e-15 * reach;  // a product's rounding, and more
  require_known_place(placed, reach, options_.slack, mesh);
  TriangleCoverOptions options;
  options.slack = 0.98 * options_.slack;
  options.fill = SolidFill::inside;
  std::vector<Aabb> out;
  try {
    out = cover_triangles(turned, options).boxes;
  } catch (const InputError& problem) {
    mesh.refuse(problem.what());
  }
  for (Aabb& box : out) box = shifted(placed, box, reach);
  return out;
}

}  // namespace geom
