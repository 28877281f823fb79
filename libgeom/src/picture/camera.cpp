#include "geom/picture/camera.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

namespace geom::picture {
namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kMostPixels = 16384;

double required(const JsonFields& fields, const char* key) {
  const auto value = fields.number(key);
  if (!value) fields.refuse({.expected = fmt::format("the key \"{}\"", key), .found = "none"});
  return *value;
}

int pixels(const JsonFields& fields, const char* key) {
  const double value = required(fields, key);
  if (value != std::floor(value) || value < 1 || value > kMostPixels) {
    fields.refuse({.key = std::string(key),
                   .expected = fmt::format("a whole number from 1 to {}", kMostPixels),
                   .found = fmt::to_string(value)});
  }
  return static_cast<int>(value);
}

double focal(const JsonFields& fields, const char* key, double value) {
  if (!(value > 0))
    fields.refuse(
        {.key = std::string(key), .expected = "> 0 pixels", .found = fmt::to_string(value)});
  return value;
}

double angle(const JsonFields& fields, const char* key) {
  const double degrees = fields.number(key).value_or(0);
  if (std::abs(degrees) > 360) {
    fields.refuse({.key = std::string(key),
                   .expected = "within -360 to 360 degrees",
                   .found = fmt::to_string(degrees)});
  }
  return degrees * kDegree;
}

Eigen::Matrix3d turned(double angle, const Vec3& axis) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

}  // namespace

Camera parse_camera(const JsonFields& fields) {
  Camera camera;
  camera.width = pixels(fields, "width");
  camera.height = pixels(fields, "height");
  camera.fx = focal(fields, "fx", required(fields, "fx"));
  camera.fy = focal(fields, "fy", fields.number("fy").value_or(camera.fx));
  camera.cx = fields.number("cx").value_or(0.5 * (camera.width - 1));
  camera.cy = fields.number("cy").value_or(0.5 * (camera.height - 1));
  if (fields.has("position")) camera.position = fields.point("position");
  camera.roll = angle(fields, "roll_deg");
  camera.pitch = angle(fields, "pitch_deg");
  camera.yaw = angle(fields, "yaw_deg");
  return camera;
}

View view_from(const Camera& camera, const Pose& pose) {
  View view;
  view.width = camera.width;
  view.height = camera.height;
  view.fx = camera.fx;
  view.fy = camera.fy;
  view.cx = camera.cx;
  view.cy = camera.cy;
  view.eye = pose.position + pose.attitude * camera.position;
  const Eigen::Matrix3d looks = pose.attitude * turned(camera.yaw, Vec3::UnitZ()) *
                                turned(camera.pitch, Vec3::UnitY()) *
                                turned(camera.roll, Vec3::UnitX());
  view.axes << -looks.col(1), -looks.col(2), looks.col(0);
  return view;
}

}  // namespace geom::picture
