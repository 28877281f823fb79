#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>

#include "geom/model/model.h"
#include "geom/model/model_polygons.h"
#include "geom/shape/aabb.h"
#include "geom/shape/convex_outline.h"

namespace geom {
namespace {

constexpr std::size_t kMostCorners = 1000;
constexpr double kFlat = 1e-6;    // of its size: so far a polygon may be from flat
constexpr double kCrooked = 0.1;  // so bent that no one sees whether it has a notch

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// Newell's: twice the area in each plane, so the longest axis tells where it is seen best.
Vec3 newell_normal(std::span<const Vec3> corners) {
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 a = corners[i] - corners[0];
    const Vec3 b = corners[(i + 1) % corners.size()] - corners[0];
    normal += Vec3(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
                   a.x() * b.y() - a.y() * b.x());
  }
  return normal;
}

void add_fan(const std::vector<std::uint32_t>& left, Triangles& out) {
  for (std::size_t i = 1; i + 1 < left.size(); ++i) out.push_back({left[0], left[i], left[i + 1]});
}

// The polygon seen along one axis, counterclockwise.
class Flat {
 public:
  explicit Flat(std::span<const Vec3> corners) : corners_(corners) {
    const Vec3 normal = newell_normal(corners);
    Eigen::Index axis = 2;
    normal.cwiseAbs().maxCoeff(&axis);
    x_ = (axis + 1) % 3;
    y_ = (axis + 2) % 3;
    axis_ = axis;
    along_ = normal[axis] != 0 ? Vec3(normal / normal[axis]) : Vec3(Vec3::Unit(axis));
    if (normal[axis] < 0) std::swap(x_, y_);
  }

  Vec3 axis() const { return Vec3::Unit(axis_); }

  // How far a corner lies along the axis from the plane through the first one.
  double height(std::size_t i) const { return along_.dot(corners_[i] - corners_[0]); }

  bool convex() const {
    const auto n = static_cast<std::uint32_t>(corners_.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      if (turn(i, (i + 1) % n, (i + 2) % n) < 0) return false;
    }
    return true;
  }

  // Its convex hull, seen so.
  Triangles hull() const {
    std::vector<Vec2> seen;
    for (const Vec3& p : corners_) seen.emplace_back(p[x_], p[y_]);
    std::vector<std::uint32_t> around;
    for (const Vec2& p : convex_outline(seen)) {
      around.push_back(
          static_cast<std::uint32_t>(std::find(seen.begin(), seen.end(), p) - seen.begin()));
    }
    Triangles out;
    if (around.size() >= 3) add_fan(around, out);
    return out;
  }

  double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Vec3& p = corners_[a];
    const Vec3 u = corners_[b] - p;
    const Vec3 v = corners_[c] - p;
    return u[x_] * v[y_] - u[y_] * v[x_];
  }

  bool holds(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t p) const {
    for (const std::uint32_t i : {a, b, c}) {
      if (corners_[p] == corners_[i]) return false;  // a corner met twice, as at a slit
    }
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
  }

 private:
  std::span<const Vec3> corners_;
  Eigen::Index axis_ = 2;
  Eigen::Index x_ = 0;
  Eigen::Index y_ = 1;
  Vec3 along_ = Vec3::UnitZ();  // the normal, 1 along the axis
};

bool is_ear(const Flat& flat, const std::vector<std::uint32_t>& left, std::size_t i) {
  const std::size_t n = left.size();
  const std::uint32_t a = left[(i + n - 1) % n];
  const std::uint32_t b = left[i];
  const std::uint32_t c = left[(i + 1) % n];
  if (!(flat.turn(a, b, c) >= 0)) return false;
  return std::none_of(left.begin(), left.end(), [&](std::uint32_t p) {
    return p != a && p != b && p != c && flat.holds(a, b, c, p);
  });
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> polygon_triangles(std::span<const Vec3> corners) {
  std::vector<std::uint32_t> left(corners.size());
  std::iota(left.begin(), left.end(), 0u);
  Triangles out;
  const Flat flat(corners);
  while (left.size() > 3 && left.size() <= kMostCorners) {
    std::size_t ear = 0;
    while (ear < left.size() && !is_ear(flat, left, ear)) ++ear;
    if (ear == left.size()) break;
    const std::size_t n = left.size();
    out.push_back({left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  add_fan(left, out);
  return out;
}

void ModelPolygons::add(Model& model, std::span<const std::uint32_t> corners, std::uint32_t part) {
  std::vector<Vec3> places;
  for (const std::uint32_t i : corners) places.push_back(model.mesh.vertices[i]);
  const auto triangles = polygon_triangles(places);
  for (const auto& [a, b, c] : triangles) {
    model.mesh.triangles.push_back({{corners[a], corners[b], corners[c]}, part});
  }
  if (places.size() < 4) return;
  const Aabb around = *bounds(std::span<const Vec3>(places));
  const double size = (around.max - around.min).norm();
  const Flat flat(places);
  double low = 0;
  double high = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    low = std::min(low, flat.height(i));
    high = std::max(high, flat.height(i));
  }
  if (high - low <= kFlat * size) return;
  if (places.size() == 4) {
    if (!flat.convex() && high - low <= kCrooked * size) return;  // there is one way to cut it
    ++bent_;
    return add_tetrahedron(places, part);
  }
  ++bent_;
  const double more =
      1e-9 * size + 1e-14 * around.max.cwiseAbs().cwiseMax(around.min.cwiseAbs()).maxCoeff();
  const bool crooked = high - low > kCrooked * size;
  for (const auto& triangle : crooked && !flat.convex() ? flat.hull() : triangles) {
    std::array<Vec3, 3> bottom;
    std::array<Vec3, 3> top;
    for (std::size_t k = 0; k < 3; ++k) {
      const double own = flat.height(triangle[k]);
      bottom[k] = places[triangle[k]] + (low - more - own) * flat.axis();
      top[k] = places[triangle[k]] + (high + more - own) * flat.axis();
    }
    add_prism(bottom, top, part);
  }
}

void ModelPolygons::add_tetrahedron(std::span<const Vec3> corners, std::uint32_t part) {
  const auto first = static_cast<std::uint32_t>(solids_.vertices.size());
  solids_.vertices.insert(solids_.vertices.end(), corners.begin(), corners.end());
  const Vec3 a = corners[1] - corners[0];
  const Vec3 b = corners[2] - corners[0];
  const Vec3 c = corners[3] - corners[0];
  const bool outward = a.cross(b).dot(c) > 0;
  for (const auto& [i, j, k] :
       {std::array<std::uint32_t, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
    solids_.triangles.push_back(
        {{first + i, first + (outward ? j : k), first + (outward ? k : j)}, part});
  }
}

void ModelPolygons::add_prism(const std::array<Vec3, 3>& low, const std::array<Vec3, 3>& high,
                              std::uint32_t part) {
  const auto first = static_cast<std::uint32_t>(solids_.vertices.size());
  solids_.vertices.insert(solids_.vertices.end(), low.begin(), low.end());
  solids_.vertices.insert(solids_.vertices.end(), high.begin(), high.end());
  const bool outward = (low[1] - low[0]).cross(low[2] - low[0]).dot(high[0] - low[0]) > 0;
  const auto add = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    solids_.triangles.push_back(
        {{first + i, first + (outward ? j : k), first + (outward ? k : j)}, part});
  };
  add(0, 2, 1);
  add(3, 4, 5);
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::uint32_t j = (i + 1) % 3;
    add(i, j, j + 3);
    add(i, j + 3, i + 3);
  }
}

void ModelPolygons::finish(Model& model) {
  model.bent = bent_;
  if (solids_.triangles.empty()) return;
  model.solid_from = model.parts.size();
  const auto first = static_cast<std::uint32_t>(model.mesh.vertices.size());
  std::map<std::uint32_t, std::uint32_t> part_of;
  for (MeshTriangle t : solids_.triangles) {
    const auto [at, added] =
        part_of.try_emplace(t.part, static_cast<std::uint32_t>(model.parts.size()));
    if (added) model.parts.push_back(std::string(model.parts[t.part]));
    t.part = at->second;
    for (std::uint32_t& corner : t.corners) corner += first;
    model.mesh.triangles.push_back(t);
  }
  model.mesh.vertices.insert(model.mesh.vertices.end(), solids_.vertices.begin(),
                             solids_.vertices.end());
  solids_ = {};
}

TriangleCover cover_model(const Model& model, const TriangleCoverOptions& options,
                          const Execution& run) {
  const auto is_solid = [&](const MeshTriangle& t) { return t.part >= model.solid_from; };
  const auto& all = model.mesh.triangles;
  const auto solids = std::find_if(all.begin(), all.end(), is_solid);
  if (options.fill == SolidFill::inside || solids == all.end()) {
    return cover_triangles(model.mesh, options, run);
  }
  TriangleCover out = cover_triangles({model.mesh.vertices, {all.begin(), solids}}, options, run);
  TriangleCoverOptions filled = options;
  filled.fill = SolidFill::inside;
  const TriangleCover more =
      cover_triangles({model.mesh.vertices, {solids, all.end()}}, filled, run);
  out.boxes.insert(out.boxes.end(), more.boxes.begin(), more.boxes.end());
  out.part.insert(out.part.end(), more.part.begin(), more.part.end());
  return out;
}

}  // namespace geom
