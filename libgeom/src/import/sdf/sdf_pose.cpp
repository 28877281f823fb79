#include "sdf_pose.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "geom/base/rounding.h"
#include "shape/unit_vector.h"

namespace geom {
namespace {

constexpr double kTurnError = 4e-15;  // of a matrix of three turns, and of a product of two
constexpr double kMostRadians = 1000;
constexpr double kMostDegrees = 57000;

bool is_signed_permutation(const Eigen::Matrix3d& m) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (m(i, j) != 0 && std::abs(m(i, j)) != 1) return false;
    }
  }
  return true;
}

// Adds the term exactly where there is room.
void add(SdfPose& pose, int axis, double term) {
  ExactSum& sum = pose.shift[axis];
  if (sum.count() == ExactSum::kMost - 2) {  // keeps room for a half size
    ExactSum rounded;
    rounded.add(sum.down());
    pose.shift_error += 2 * ulp(sum.down());
    sum = rounded;
  }
  sum.add(term);
}

Eigen::Matrix3d of_angles(UnitVector roll, UnitVector pitch, UnitVector yaw) {
  Eigen::Matrix3d x = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d y = x;
  Eigen::Matrix3d z = x;
  x(1, 1) = x(2, 2) = roll.cosine;
  x(2, 1) = roll.sine;
  x(1, 2) = -roll.sine;
  y(0, 0) = y(2, 2) = pitch.cosine;
  y(0, 2) = pitch.sine;
  y(2, 0) = -pitch.sine;
  z(0, 0) = z(1, 1) = yaw.cosine;
  z(1, 0) = yaw.sine;
  z(0, 1) = -yaw.sine;
  return z * y * x;
}

Eigen::Matrix3d of_quaternion(const SdfNode& pose, const std::vector<double>& v) {
  const Eigen::Quaterniond q(v[6], v[3], v[4], v[5]);
  const double norm = q.norm();
  if (!(std::abs(norm - 1) < 0.01)) {
    pose.refuse({.says = "<pose> must have a quaternion of length 1",
                 .found = fmt::format("length {:.6g}", norm)});
  }
  const bool quarter = (q.coeffs().array() == 0).count() == 3;
  return quarter ? Eigen::Quaterniond(q.coeffs().cwiseSign()).toRotationMatrix()
                 : q.normalized().toRotationMatrix();
}

bool in_degrees(const SdfNode& pose) {
  const std::string word = pose.attribute("degrees");
  if (word.empty() || word == "false" || word == "0") return false;
  if (word == "true" || word == "1") return true;
  pose.refuse(
      {.key = "degrees", .expected = "true or false", .found = in_quotes(word.substr(0, 40))});
}

Eigen::Matrix3d of_euler(const SdfNode& pose, const std::vector<double>& v, bool degrees) {
  const double most = degrees ? kMostDegrees : kMostRadians;
  const auto vector = [&](double angle) {
    if (!(std::abs(angle) <= most)) {
      pose.refuse({.key = "angles of a <pose>",
                   .expected = fmt::format("within {}", most),
                   .found = fmt::to_string(angle)});
    }
    return degrees ? unit_vector_of_degrees(angle) : unit_vector(angle);
  };
  return of_angles(vector(v[3]), vector(v[4]), vector(v[5]));
}

void refuse_unknown_attributes(const SdfNode& pose) {
  for (const auto& [key, value] : pose.element->attributes) {
    if (key == "relative_to" || key == "frame" || key == "degrees" || key == "rotation_format" ||
        key.find(':') != std::string::npos) {
      continue;
    }
    pose.refuse({.expected = "an attribute of <pose> that SDF knows",
                 .found = in_quotes(key.substr(0, 40))});
  }
}

// How the pose says its rotation: a quaternion, or roll, pitch and yaw.
bool is_quaternion(const SdfNode& pose) {
  const std::string said = pose.attribute("rotation_format");
  if (said == "quat_xyzw") return true;
  if (said.empty() || said == "euler_rpy") return false;
  pose.refuse({.key = "rotation_format",
               .expected = "euler_rpy or quat_xyzw",
               .found = in_quotes(said.substr(0, 40))});
}

}  // namespace

Vec3 SdfPose::place() const { return {shift[0].down(), shift[1].down(), shift[2].down()}; }

SdfPose operator*(const SdfPose& outer, const SdfPose& inner) {
  SdfPose out = outer;
  out.turn = outer.turn * inner.turn;
  out.turn_error = outer.turn_error + inner.turn_error;
  out.shift_error = outer.shift_error + inner.shift_error;
  if (is_signed_permutation(outer.turn)) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        if (outer.turn(i, j) == 0) continue;
        for (const double term : inner.shift[j]) add(out, i, outer.turn(i, j) * term);
      }
    }
  } else {
    const Vec3 place = inner.place();
    const Vec3 moved = outer.turn * place;
    for (int i = 0; i < 3; ++i) add(out, i, moved[i]);
    out.shift_error += kTurnError * place.norm();
    if (!is_signed_permutation(inner.turn)) out.turn_error += kTurnError;
  }
  out.shift_error += outer.turn_error * inner.place().norm();
  return out;
}

SdfPose inverse(const SdfPose& pose) {
  SdfPose turned;
  turned.turn = pose.turn.transpose();
  turned.turn_error = pose.turn_error;
  SdfPose back;
  for (int i = 0; i < 3; ++i) {
    for (const double term : pose.shift[i]) back.shift[i].add(-term);
  }
  back.shift_error = pose.shift_error;
  return turned * back;
}

SdfPose parse_sdf_pose(const SdfNode& pose) {
  refuse_unknown_attributes(pose);
  SdfPose out;
  const bool quaternion = is_quaternion(pose);
  const bool degrees = in_degrees(pose);
  if (quaternion && degrees)
    pose.refuse({.says = "a quaternion has no degrees", .found = "degrees"});
  if (pose.text().empty()) return out;
  const std::vector<double> v = pose.numbers(quaternion ? 7 : 6);
  for (int i = 0; i < 3; ++i) out.shift[i].add(v[i]);
  out.turn = quaternion ? of_quaternion(pose, v) : of_euler(pose, v, degrees);
  if (!is_signed_permutation(out.turn)) out.turn_error = kTurnError;
  return out;
}

Aabb placed_box(const SdfPose& pose, const Vec3& half) {
  const Vec3 turned = pose.turn.cwiseAbs() * half;
  Aabb box;
  for (int i = 0; i < 3; ++i) {
    ExactSum low = pose.shift[i];
    ExactSum high = pose.shift[i];
    low.add(-turned[i]);
    high.add(turned[i]);
    box.min[i] = low.down();
    box.max[i] = high.up();
  }
  return box;
}

void require_known_place(const SdfPose& pose, double reach, double slack, const SdfNode& at) {
  const double error = pose.shift_error + (pose.turn_error + 1e-13) * reach;
  if (error <= 0.01 * slack) return;
  at.refuse({.says = fmt::format("the place of <{}> is known to {:.3g} m only", at.name(), error),
             .advice = "give more slack"});
}

Aabb shifted(const SdfPose& pose, const Aabb& turned, double reach) {
  const double error = pose.shift_error + (pose.turn_error + (pose.exact() ? 0 : 1e-13)) * reach;
  Aabb box;
  for (int i = 0; i < 3; ++i) {
    ExactSum low = pose.shift[i];
    ExactSum high = pose.shift[i];
    low.add(add_down(turned.min[i], -error));
    high.add(add_up(turned.max[i], error));
    box.min[i] = low.down();
    box.max[i] = high.up();
  }
  return box;
}

}  // namespace geom
