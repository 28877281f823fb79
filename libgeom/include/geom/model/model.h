#pragma once

// Models of triangles, and the readers of OBJ, STL and PLY.
//
// Example:
//   std::ifstream file("house.obj");
//   const geom::Model house = geom::read_obj(file, "house.obj");
//   for (const std::string& part : house.parts) std::cout << part << '\n';
//   assert(!house.mesh.triangles.empty());

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/skipped.h"
#include "geom/mesh/triangle_mesh.h"

namespace geom {

enum class UpAxis { y, z };  // of a right-handed frame

struct Model {
  TriangleMesh mesh;               // in the file's own axes and units
  std::vector<std::string> parts;  // the names of its parts: objects, nodes, features
  Skipped skipped;                 // obstacles, or possible ones, that are no triangles
  std::optional<UpAxis> up;        // where the file or its format says so,
  std::optional<double> unit;      // and so metres in a unit
  double blur = 0;                 // in units: how far vertices may be off, by rounding in reading
  std::size_t bent = 0;            // polygons that are not flat (model_polygons.h); their solids
  std::size_t solid_from = SIZE_MAX;  // are the parts from this one on
};

// The bytes of a file that another one names, by a path relative to that one. Throws
// InputError or std::system_error where it cannot.
using ModelFiles = std::function<std::string(const std::string& path)>;

// The triangles of a polygon: indices of its corners. Ears are cut off in the plane that its normal
// is nearest to, so that a polygon with notches is not filled up; where that finds none (it crosses
// itself, or has more than 1,000 corners), a fan, which holds whatever such a polygon encloses.
// At least three corners.
std::vector<std::array<std::uint32_t, 3>> polygon_triangles(std::span<const Vec3> corners);

// As y-up files mean it, in z-up axes: x, -z, y. Exact.
inline Vec3 z_up_of_y_up(const Vec3& v) { return {v.x(), -v.z(), v.y()}; }

// Wavefront OBJ: faces of vertices; a part for each object or group. Points, lines, free-form
// surfaces and words that it does not know are skipped and counted.
Model read_obj(std::istream& in, std::string_view source);

// STL, as text or binary; a part for each solid.
Model read_stl(std::istream& in, std::string_view source);

// PLY, as text or binary: polygons of the element "face", and "tristrips". Other elements that may
// join vertices are skipped and counted.
Model read_ply_model(std::istream& in, std::string_view source);

// All throw InputError(source, …) for a malformed or cut file, for a coordinate that is not finite
// or beyond kLargestCoordinate, and for an index that has no vertex.

}  // namespace geom
