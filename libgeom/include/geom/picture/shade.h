#pragma once

// The colour of what a ray met.
//
// Example:
//   const geom::picture::PictureScene seen(map, {});
//   geom::picture::Light light;
//   light.shadows = true;
//   const geom::picture::Shader shader(seen, geom::picture::look_of(map), light, false);
//
// Sun and sky light, storeys and windows that show motion, a grid on the ground, and haze.

#include <array>
#include <vector>

#include "geom/picture/look.h"
#include "geom/picture/picture.h"
#include "geom/picture/picture_scene.h"

namespace geom::picture {

struct Light {
  double azimuth = 3.9;    // radians from north clockwise: where the sun stands
  double elevation = 0.8;  // radians above the horizon
  float haze = 2500;       // metres at which half of a colour is the horizon's; 0: clear air
  bool shadows = false;    // of a sun of 16 points, 1.5 degrees across, so that edges are soft
};

class Shader {
 public:
  // `look` is that of the scene's map. `scene` must outlive this. `flat` leaves out storeys and
  // windows and greys the ground beyond the map, for maps.
  Shader(const PictureScene& scene, const Look& look, const Light& light, bool flat);

  // The colours of the pixels (x, y) to (x + 3, y + 3), whose rays met `block`. Threads may call
  // at once.
  std::array<Colour, kBlock * kBlock> colours(const Rays& rays, int x, int y,
                                              const Block& block) const;

 private:
  struct Lanes;  // what is known of the rays of a block
  void gather(const Rays& rays, int x, int y, const Block& block, Lanes& lanes) const;
  void gather_ground(const Ray& ray, int i, Lanes& lanes) const;
  void gather_box(const Ray& ray, const Hit& hit, int i, Lanes& lanes) const;
  void gather_tube(const Hit& hit, int i, Lanes& lanes) const;
  float lit(const Vec3& at, int face) const;

  const PictureScene& scene_;
  std::vector<Eigen::Vector3f> box_colour_;
  std::vector<bool> windows_;
  Aabb ground_;
  GridLines grid_;
  Light light_;
  bool flat_;
  double grid_x_;  // where the grid on the ground starts: near the middle, for single precision
  double grid_y_;
  Eigen::Vector3f sun_;
  std::array<Eigen::Vector3f, 16> sun_points_;
  std::array<float, 6> ambient_;  // light of the sky on each face of a box, and of the sun
  std::array<float, 6> direct_;
};

}  // namespace geom::picture
