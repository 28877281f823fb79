#pragma once

// A camera on a vehicle: a pinhole without distortion, and where it sits.
//
// Example:
//   geom::picture::Camera camera;
//   camera.pitch = 0.3;  // looks down
//   const geom::picture::Pose pose{.position = {1, 1, 1}};
//   const geom::picture::View view = geom::picture::view_from(camera, pose);
//   assert(view.eye == pose.position);

#include "geom/picture/view.h"
#include "geom/text/json_fields.h"

namespace geom::picture {

// A vehicle in ENU: `attitude` turns body axes (x forward, y left, z up) into ENU.
struct Pose {
  Vec3 position = Vec3::Zero();
  Eigen::Matrix3d attitude = Eigen::Matrix3d::Identity();
};

struct Camera {
  int width = 640;
  int height = 480;
  double fx = 380;  // pixels: 80 degrees across
  double fy = 380;
  double cx = 319.5;  // pixels; the centre of the first pixel is at 0
  double cy = 239.5;
  Vec3 position = Vec3::Zero();  // metres from the vehicle's reference point, in body axes
  double roll = 0;               // radians, about the body's x, then
  double pitch = 0;              // about y (positive looks down) and
  double yaw = 0;                // about z (positive looks left), all from looking along x
};

// {"width":…,"height":…,"fx":…,"fy":…,"cx":…,"cy":…,"position":[x,y,z],"roll_deg":…,"pitch_deg":…,
// "yaw_deg":…}; width, height and fx are needed, fy is fx, and cx and cy are the middle, where
// absent. Throws InputError where a value cannot be.
Camera parse_camera(const JsonFields& fields);

// What the camera sees of the world while the vehicle is there.
View view_from(const Camera& camera, const Pose& pose);

}  // namespace geom::picture
