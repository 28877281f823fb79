#include "sdf_shapes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geom/base/error.h"
#include "geom/shape/cover.h"
#include "sdf_loader.h"
#include "shape/convex_parts.h"
#include "shape/ring_stack.h"

namespace geom {
namespace {

constexpr double kOfRound = 0.2;  // of the slack: what a polygon may reach outside its circle
constexpr double kLevel = 1e-14;  // tilt that rounding alone may give a plane

double reach_of(const RingStack& solid) {
  double reach = 0;
  for (const Vec3& c : solid.corners) reach = std::max(reach, c.norm());
  return reach;
}

// Of a round body: all of the slack but what its polygon takes is left for the boxes.
struct Round {
  double radius;
  double length;
};

Round round_of(const SdfNode& shape) {
  return {shape.child("radius").number_above_zero(), shape.child("length").not_negative(1)[0]};
}

bool upright(const SdfPose& pose) {
  return std::abs(pose.turn(2, 2)) == 1 && pose.turn(0, 2) == 0 && pose.turn(1, 2) == 0 &&
         pose.turn(2, 0) == 0 && pose.turn(2, 1) == 0;
}

}  // namespace

void SdfShapes::skip(const SdfNode& node, const std::string& kind) const {
  skipped_.add(kind, sdf_place(node, node.name()));
}

std::vector<Aabb> SdfShapes::turned(const RingStack& solid, const SdfPose& pose,
                                    const SdfNode& at) const {
  const double reach = reach_of(solid);
  require_known_place(pose, reach, slack_, at);
  RingStack around = solid;
  for (Vec3& c : around.corners) c = pose.turn * c;
  std::vector<Aabb> out;
  try {
    for (const Aabb& b : cover(around, 0.98 * slack_)) out.push_back(shifted(pose, b, reach));
  } catch (const InputError& problem) {
    at.refuse(problem.as_item());
  }
  return out;
}

SdfBoxes SdfShapes::box(const SdfNode& shape, const SdfPose& pose) const {
  const SdfNode size = shape.child("size");
  const std::vector<double> v = size.not_negative(3);
  const Vec3 full(v[0], v[1], v[2]);
  if (full.isZero(0)) size.refuse({.says = "a box must have some extent", .found = "three zeros"});
  if (pose.exact()) return {{placed_box(pose, 0.5 * full)}, {}};
  return {turned(box_stack(full), pose, shape), {}};
}

SdfBoxes SdfShapes::plane(const SdfNode& shape, const SdfPose& pose) const {
  Vec3 normal = Vec3::UnitZ();
  if (const auto given = shape.find("normal")) {
    const std::vector<double> v = given->numbers(3);
    normal = Vec3(v[0], v[1], v[2]);
    if (!(normal.norm() > 0))
      given->refuse({.says = "<normal> must have some length", .found = "three zeros"});
    normal.normalize();
  }
  const Vec3 up = pose.turn * normal;
  SdfBoxes out;
  const bool level = up.z() > 0 && std::hypot(up.x(), up.y()) <= kLevel;
  if (level) out.plane = pose.shift[2].up() + pose.shift_error;
  if (const auto given = shape.find("size")) {
    const std::vector<double> v = given->not_negative(2);
    SdfPose facing;
    if (normal.z() != 1) {
      facing.turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), normal).toRotationMatrix();
      facing.turn_error = 1e-14;
    }
    const SdfPose placed = pose * facing;
    const Vec3 full(v[0], v[1], 0);
    out.boxes = placed.exact() ? std::vector{placed_box(placed, 0.5 * full)}
                               : turned(box_stack(full), placed, shape);
  }
  return out;
}

std::optional<SdfShapes::Extrusion> SdfShapes::extrusion(const std::vector<SdfNode>& shapes) const {
  Extrusion out;
  std::vector<double> heights;
  for (const SdfNode& shape : shapes) {
    const auto height = shape.find("height");
    heights.push_back(height ? height->number_above_zero() : 1);
    std::vector<Vec2> ring;
    for (const SdfNode& point : shape.all("point")) {
      const std::vector<double> v = point.numbers(2);
      ring.push_back({v[0], v[1]});
    }
    if (ring.size() < 3) {
      shape.refuse(
          {.says = "<polyline> must have at least 3 points", .found = fmt::to_string(ring.size())});
    }
    // The first ring is the outline, and the parity of all counts: so is the simulator's.
    std::vector<Vec2>& to =
        out.polygon.outer.empty() ? out.polygon.outer : out.polygon.holes.emplace_back();
    to = std::move(ring);
  }
  const auto [least, most] = std::minmax_element(heights.begin(), heights.end());
  if (*least != *most) {
    skip(shapes[0], "polylines of different heights");
    return std::nullopt;
  }
  out.height = *most;
  return out;
}

std::vector<Aabb> SdfShapes::upright_boxes(Extrusion solid, const SdfPose& pose) const {
  const double up = pose.turn(2, 2) * solid.height;
  double reach = solid.height;
  const auto turn = [&](std::vector<Vec2>& ring) {
    for (Vec2& p : ring) {
      p = (pose.turn * Vec3(p.x(), p.y(), 0)).head<2>();
      reach = std::max(reach, p.norm());
    }
  };
  turn(solid.polygon.outer);
  for (std::vector<Vec2>& hole : solid.polygon.holes) turn(hole);
  std::vector<Aabb> out;
  for (const Rectangle& r : cover(solid.polygon, 0.98 * slack_)) {
    const Aabb local{{r.min.x(), r.min.y(), std::min(0.0, up)},
                     {r.max.x(), r.max.y(), std::max(0.0, up)}};
    out.push_back(shifted(pose, local, reach));
  }
  return out;
}

SdfBoxes SdfShapes::polylines(const std::vector<SdfNode>& shapes, const SdfPose& pose) const {
  const std::optional<Extrusion> solid = extrusion(shapes);
  if (!solid) return {};
  SdfBoxes out;
  try {
    if (upright(pose)) return {upright_boxes(*solid, pose), {}};
    for (const std::vector<Vec2>& ring : convex_parts(solid->polygon)) {
      RingStack part;
      part.sides = ring.size();
      for (const double z : {0.0, solid->height}) {
        for (const Vec2& p : ring) part.corners.push_back({p.x(), p.y(), z});
      }
      const std::vector<Aabb> boxes = turned(part, pose, shapes[0]);
      out.boxes.insert(out.boxes.end(), boxes.begin(), boxes.end());
    }
  } catch (const InputError& problem) {
    if (problem.source() == *shapes[0].source) throw;
    shapes[0].refuse(problem.as_item());
  }
  return out;
}

SdfBoxes SdfShapes::shape(const SdfNode& shape, const SdfPose& pose) const {
  const std::string& kind = shape.name();
  const double error = kOfRound * slack_;
  const SdfShapes rest((1 - kOfRound) * slack_, meshes_, skipped_);
  const auto round = [&](const RingStack& solid) {
    return SdfBoxes{rest.turned(solid, pose, shape), {}};
  };
  try {
    if (kind == "box") return box(shape, pose);
    if (kind == "plane") return plane(shape, pose);
    if (kind == "mesh") return {meshes_.boxes_of(shape, pose), {}};
    if (kind == "cylinder") {
      const Round r = round_of(shape);
      return round(cylinder_stack(r.radius, r.length, error));
    }
    if (kind == "cone") {
      const Round r = round_of(shape);
      return round(cone_stack(r.radius, r.length, error));
    }
    if (kind == "capsule") {
      const Round r = round_of(shape);
      return round(capsule_stack(r.radius, r.length, error));
    }
    if (kind == "sphere") {
      const double radius = shape.child("radius").number_above_zero();
      SdfPose unturned = pose;  // however it is turned
      unturned.turn.setIdentity();
      return {rest.turned(ellipsoid_stack(Vec3::Constant(radius), error), unturned, shape), {}};
    }
    if (kind == "ellipsoid") {
      const std::vector<double> v = shape.child("radii").not_negative(3);
      return round(ellipsoid_stack({v[0], v[1], v[2]}, error));
    }
  } catch (const InputError& problem) {
    if (problem.source() == *shape.source) throw;
    shape.refuse(problem.as_item());
  }
  skip(shape, kind == "heightmap" || kind == "image" ? kind : "unknown geometry");
  return {};
}

SdfBoxes SdfShapes::boxes_of(const SdfNode& geometry, const SdfPose& pose) const {
  std::vector<SdfNode> outlines;
  std::optional<SdfNode> other;
  for (const XmlElement& child : geometry.element->children) {
    const SdfNode node = geometry.of(child);
    if (!child.prefix.empty()) {
      skip(node, "unknown geometry");
      return {};
    }
    const bool outline = child.name == "polyline";
    if (other || (!outline && !outlines.empty())) {
      node.refuse({.expected = "one shape in <geometry>",
                   .found = fmt::format("another: <{}>", child.name.substr(0, 40))});
    }
    if (outline) {
      outlines.push_back(node);
    } else {
      other = node;
    }
  }
  if (!outlines.empty()) return polylines(outlines, pose);
  if (!other) geometry.refuse({.expected = "a shape in <geometry>", .found = "none"});
  if (other->name() == "empty") return {};
  return shape(*other, pose);
}

}  // namespace geom
