#pragma once

// What a ray of light meets: the boxes of a map, thick lines, and the ground.
//
// Example:
//   const geom::picture::PictureScene seen(map, {});
//   const geom::picture::View view =
//       geom::picture::view_from({}, {.position = {1, 1, 1}});
//   const geom::picture::Block block = seen.cast(geom::picture::Rays(view), 0, 0);
//   const float metres = block[0].depth;
//
// Boxes are single-precision quads. For pictures only: it is never asked about collision.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "geom/map/box_map.h"
#include "geom/picture/view.h"

namespace geom::picture {

// Thick lines of one colour: a cylinder an edge, rounded at its ends.
struct Tubes {
  std::vector<Vec3> points;                                    // ENU
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;  // indices into points
  double radius = 1;                                           // metres
  std::uint32_t colour = 0;                                    // 0xRRGGBB
};

struct Hit {
  enum class Kind : std::uint8_t { sky, ground, box, tube };
  Kind kind = Kind::sky;
  std::uint8_t face = 0;     // of a box: axis, plus 3 on its upper side
  std::uint32_t object = 0;  // the row of the box in the map, or the tubes
  float depth = 0;           // metres along the view's forward axis; 0 for the sky
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // of a tube, of length 1
};

inline constexpr int kBlock = 4;  // rays go in blocks of 4 x 4 pixels
using Block = std::array<Hit, kBlock * kBlock>;

// Immutable once built; threads may cast at once. The ground is the plane at the lower bound of
// the map. Single precision decides which surface is first, relative to the middle of the map; the
// depth of a box or the ground is then computed in double. So a ray that passes an edge within a
// thousandth of a pixel may count to either side of it.
class PictureScene {
 public:
  // Boxes for which `unseen` is true, where it says something, meet no ray. Throws std::bad_alloc
  // where memory ran out, std::runtime_error where Embree could not build its tree.
  PictureScene(const BoxMap& map, std::span<const Tubes> tubes,
               const std::vector<bool>& unseen = {});
  ~PictureScene();
  PictureScene(const PictureScene&) = delete;
  PictureScene& operator=(const PictureScene&) = delete;

  // What the rays through the pixels (x, y) to (x + 3, y + 3) meet, row by row.
  Block cast(const Rays& rays, int x, int y) const;

  // The depths of cast() alone, which takes less time.
  std::array<float, kBlock * kBlock> depths(const Rays& rays, int x, int y) const;

  // Which share of 16 directions (each of length 1 or so) sees no surface from `from`.
  float unhidden(const Vec3& from, std::span<const Eigen::Vector3f, 16> directions) const;

  std::span<const Aabb> boxes() const { return boxes_; }  // ENU, in the order of the map
  double ground() const { return ground_; }
  const Vec3& middle() const { return middle_; }  // of the map's bounds
  const std::vector<std::uint32_t>& tube_colours() const { return tube_colours_; }

 private:
  struct Embree;
  Hit named(const Ray& ray, unsigned geometry, unsigned primitive, float depth) const;

  std::vector<Aabb> boxes_;
  std::vector<std::uint32_t> tube_colours_;
  double ground_ = 0;
  Vec3 middle_ = Vec3::Zero();
  std::unique_ptr<Embree> embree_;
};

}  // namespace geom::picture
