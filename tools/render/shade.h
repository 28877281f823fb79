#pragma once

// The colour of what a ray met: sun and sky light, storeys and windows that show motion, a grid on
// the ground, and haze.

#include <array>
#include <vector>

#include "render/embree_picture.h"
#include "render/picture.h"

namespace render {

struct Light {
  double azimuth = 3.9;    // radians from north clockwise: where the sun stands
  double elevation = 0.8;  // radians above the horizon
  float haze = 2500;       // metres at which half of a colour is the horizon's; 0: clear air
  bool shadows = false;    // of a sun of 16 points, 1.5 degrees across, so that edges are soft
};

class Shader {
 public:
  // `box_colour` has one colour a box. `scene` must outlive this. `flat` leaves out haze, storeys
  // and windows, for maps.
  Shader(const PictureScene& scene, std::vector<Colour> box_colour, const Light& light, bool flat);

  // The colour of pixel (u, v). Threads may call at once.
  Colour colour(const Rays& rays, double u, double v, const Hit& hit) const;

 private:
  struct Sight;  // what is known of one ray
  Eigen::Vector3f sky(const Eigen::Vector3f& direction) const;
  Eigen::Vector3f ground(const Sight& sight) const;
  Eigen::Vector3f box(const Sight& sight, const Hit& hit) const;
  Eigen::Vector3f tube(const Hit& hit) const;
  float lit(const Vec3& at, int face) const;

  const PictureScene& scene_;
  std::vector<Colour> box_colour_;
  Light light_;
  bool flat_;
  double grid_x_;  // where the grid on the ground starts: near the middle, for single precision
  double grid_y_;
  Eigen::Vector3f sun_;
  std::array<Eigen::Vector3f, 16> sun_points_;
  std::array<float, 6> ambient_;  // light of the sky on each face of a box, and of the sun
  std::array<float, 6> direct_;
};

// A colour a box: by label where the map has labels, else by the height of its top.
std::vector<Colour> box_colours(const geom::BoxMap& map);

}  // namespace render
