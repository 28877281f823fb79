#include "geom/picture/shade.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace geom::picture {
namespace {

using Rgb = Eigen::Vector3f;  // 0 to 255

constexpr int kUp = 5;  // the face of a box
constexpr float kAmbient = 0.52f;
constexpr float kSun = 0.54f;
constexpr float kSunSpread = 0.013f;  // radians

const Rgb kHorizon(214, 226, 238);
const Rgb kZenith(96, 150, 214);
const Rgb kSoil(196, 194, 186);
const Rgb kPaper(238, 238, 234);
const Rgb kBeyond(222, 224, 224);  // the paper beyond the map
const Rgb kClear(250, 250, 250);
const Rgb kGlass(78, 92, 110);

constexpr int kRays = kBlock * kBlock;
using Row = Eigen::Array<float, kRays, 1>;  // a value a ray, worked on side by side

// Stripes of `width` at every multiple of `period`, as a pixel of width w sees them at x: the share
// that they cover of [x - w/2, x + w/2], so that fine lines fade instead of flickering.
struct Stripes {
  float period;
  float width;

  // How much they cover from 0 to x.
  Row covered(const Row& x) const {
    const Row whole = (x * (1 / period)).floor();
    return whole * width + (x - whole * period).min(width);
  }
  // `w` and `per_metre`, 1 / w.
  Row operator()(const Row& x, const Row& w, const Row& per_metre) const {
    const Row half = 0.5f * w.min(1000 * period);
    return (covered(x + half) - covered(x - half)) * per_metre.max(0.001f / period);
  }
};

// Of a grid, as shares of a cell: how wide its lines are.
constexpr float kFineLine = 0.02f;
constexpr float kBoldLine = 0.008f;
constexpr Stripes kWindowsAcross{4, 2.2f};
constexpr Stripes kStoreys{3.5f, 1.6f};

std::uint8_t byte(float value) {
  return static_cast<std::uint8_t>(std::clamp(value + 0.5f, 0.0f, 255.0f));
}

Rgb rgb_of(Colour c) { return {float(c.r), float(c.g), float(c.b)}; }

// A little brighter or darker from box to box, so that neighbours can be told apart.
float variation(std::uint32_t i) {
  const std::uint32_t mixed_bits = (i + 1) * 2654435761u;
  return 0.93f + 0.14f * static_cast<float>(mixed_bits >> 24) / 255.0f;
}

}  // namespace

// Of rays that meet a wall or the ground, u and v are coordinates on that surface, from where its
// pattern starts: u = u0 + depth du.
struct Shader::Lanes {
  Row dx, dy, dz;  // direction
  Row depth = Row::Zero();
  Row slope = Row::Ones();  // |direction . normal|, of the direction as it stands
  Row u0 = Row::Zero(), du = Row::Zero();
  Row v0 = Row::Zero(), dv = Row::Zero();
  Row light = Row::Ones();
  Row red = Row::Zero(), green = Row::Zero(), blue = Row::Zero();
  Row sky = Row::Zero(), ground = Row::Zero(), wall = Row::Zero();  // 1 where it is that
  Row hazy = Row::Zero();
  bool any_sky = false, any_ground = false, any_wall = false;

  void paint(int i, const Rgb& c) {
    red[i] = c[0];
    green[i] = c[1];
    blue[i] = c[2];
  }
  void mix(const Rgb& with, const Row& share) {
    red += (with[0] - red) * share;
    green += (with[1] - green) * share;
    blue += (with[2] - blue) * share;
  }
  void scale(const Row& by) {
    red *= by;
    green *= by;
    blue *= by;
  }
  void draw_grid(const GridLines& grid, const Row& at_u, const Row& at_v, const Row& wide,
                 const Row& per_metre) {
    const auto fine = static_cast<float>(grid.fine);
    const auto cell = static_cast<float>(grid.cell);
    const auto lines = [&](const Stripes& s) {
      const float half = 0.5f * s.width;
      return Row(s(at_u + half, wide, per_metre).max(s(at_v + half, wide, per_metre)));
    };
    // A grid whose lines nearly touch is only a pattern of the pixels.
    const Row share = 0.24f * ground * (1.5f - wide * (10 / fine)).max(0.0f).min(1.0f);
    scale(1 - share * lines({fine, kFineLine * fine}));
    scale(1 - 0.25f * ground * lines({cell, kBoldLine * cell}));
  }
};

Shader::Shader(const PictureScene& scene, const Look& look, const Light& light, bool flat)
    : scene_(scene),
      windows_(look.windows),
      ground_(look.ground),
      grid_(look.grid),
      light_(light),
      flat_(flat) {
  box_colour_.reserve(look.colour.size());
  for (const Colour& c : look.colour) {
    const auto i = static_cast<std::uint32_t>(box_colour_.size());
    box_colour_.push_back(rgb_of(c) * (flat ? 1 : variation(i)));
  }
  grid_x_ = grid_.cell * std::round(scene.middle().x() / grid_.cell);
  grid_y_ = grid_.cell * std::round(scene.middle().y() / grid_.cell);
  const double level = std::cos(light.elevation);
  sun_ = Vec3(level * std::sin(light.azimuth), level * std::cos(light.azimuth),
              std::sin(light.elevation))
             .cast<float>();
  for (int face = 0; face < 6; ++face) {
    const float sign = face < 3 ? -1.0f : 1.0f;
    ambient_[face] = kAmbient + (face % 3 == 2 ? 0.08f * sign : 0);
    direct_[face] = kSun * std::max(0.0f, sign * sun_[face % 3]);
  }
  const Eigen::Vector3f side = sun_.unitOrthogonal();
  const Eigen::Vector3f other = sun_.cross(side);
  for (int i = 0; i < 16; ++i) {  // Vogel's spiral fills the disc evenly
    const float r = kSunSpread * std::sqrt((static_cast<float>(i) + 0.5f) / 16);
    const float turn = 2.3999632f * static_cast<float>(i);
    sun_points_[i] = sun_ + r * (std::cos(turn) * side + std::sin(turn) * other);
  }
}

float Shader::lit(const Vec3& at, int face) const {
  if (direct_[face] == 0 || !light_.shadows) return ambient_[face] + direct_[face];
  Vec3 off = at;
  off[face % 3] += face < 3 ? -0.02 : 0.02;
  return ambient_[face] + direct_[face] * scene_.unhidden(off, sun_points_);
}

void Shader::gather_ground(const Ray& ray, int i, Lanes& lanes) const {
  lanes.ground[i] = 1;
  lanes.hazy[i] = 1;
  lanes.any_ground = true;
  lanes.slope[i] = std::abs(lanes.dz[i]);
  lanes.u0[i] = static_cast<float>(ray.origin.x() - grid_x_);
  lanes.v0[i] = static_cast<float>(ray.origin.y() - grid_y_);
  lanes.du[i] = lanes.dx[i];
  lanes.dv[i] = lanes.dy[i];
  const Vec3 at = ray.origin + double{lanes.depth[i]} * ray.direction;
  lanes.light[i] = 0.94f * lit(at, kUp);
  const bool inside = at.x() >= ground_.min.x() && at.x() <= ground_.max.x() &&
                      at.y() >= ground_.min.y() && at.y() <= ground_.max.y();
  lanes.paint(i, !flat_ ? kSoil : inside ? kPaper : kBeyond);
}

void Shader::gather_box(const Ray& ray, const Hit& hit, int i, Lanes& lanes) const {
  const int axis = hit.face % 3;
  lanes.hazy[i] = 1;
  lanes.light[i] = lit(ray.origin + double{hit.depth} * ray.direction, hit.face);
  lanes.paint(i, box_colour_[hit.object]);
  if (axis == 2 || flat_ || !windows_[hit.object]) return;
  const Aabb& box = scene_.boxes()[hit.object];
  const int along = 1 - axis;
  lanes.wall[i] = 1;
  lanes.any_wall = true;
  lanes.slope[i] = std::abs(axis == 0 ? lanes.dx[i] : lanes.dy[i]);
  lanes.u0[i] = static_cast<float>(ray.origin[along] - box.min[along]);
  lanes.v0[i] = static_cast<float>(ray.origin.z() - box.min.z());
  lanes.du[i] = along == 0 ? lanes.dx[i] : lanes.dy[i];
  lanes.dv[i] = lanes.dz[i];
}

void Shader::gather_tube(const Hit& hit, int i, Lanes& lanes) const {
  const std::uint32_t c = scene_.tube_colours()[hit.object];
  lanes.paint(i, {static_cast<float>(c >> 16 & 255), static_cast<float>(c >> 8 & 255),
                  static_cast<float>(c & 255)});
  lanes.light[i] = 0.75f + 0.3f * std::max(0.0f, hit.normal.dot(sun_));
}

void Shader::gather(const Rays& rays, int x, int y, const Block& block, Lanes& lanes) const {
  for (int i = 0; i < kRays; ++i) {
    const Ray ray = rays.through(x + i % kBlock, y + i / kBlock);
    const Hit& hit = block[static_cast<std::size_t>(i)];
    lanes.dx[i] = static_cast<float>(ray.direction.x());
    lanes.dy[i] = static_cast<float>(ray.direction.y());
    lanes.dz[i] = static_cast<float>(ray.direction.z());
    lanes.depth[i] = hit.depth;
    if (hit.kind == Hit::Kind::box) {
      gather_box(ray, hit, i, lanes);
    } else if (hit.kind == Hit::Kind::ground) {
      gather_ground(ray, i, lanes);
    } else if (hit.kind == Hit::Kind::tube) {
      gather_tube(hit, i, lanes);
    } else {
      lanes.sky[i] = 1;
      lanes.any_sky = true;
      lanes.paint(i, flat_ ? kClear : kHorizon);
    }
  }
}

std::array<Colour, kRays> Shader::colours(const Rays& rays, int x, int y,
                                          const Block& block) const {
  Lanes lanes;
  gather(rays, x, y, block, lanes);
  const Row squared = lanes.dx.square() + lanes.dy.square() + lanes.dz.square();
  const Row length = squared.sqrt();
  const Row far = lanes.depth * length;
  if (lanes.any_wall || lanes.any_ground) {
    const auto pixel = static_cast<float>(rays.pixel());
    const Row slope = (lanes.slope / length).max(0.03f);
    const Row wide = pixel * (rays.parallel() ? Row(Row::Ones()) : far.max(1e-6f)) / slope;
    const Row per_metre = 1 / wide;
    const Row u = lanes.u0 + lanes.depth * lanes.du;
    const Row v = lanes.v0 + lanes.depth * lanes.dv;
    if (lanes.any_wall) {
      const Row window = kWindowsAcross(u - 1, wide, per_metre) * kStoreys(v - 1, wide, per_metre);
      lanes.mix(kGlass, 0.45f * lanes.wall * window);
    }
    if (lanes.any_ground) {
      lanes.draw_grid(grid_, u, v, wide, per_metre);
    }
  }
  lanes.scale(lanes.light);
  if (lanes.any_sky && !flat_) {
    const Row down = 1 - (lanes.dz / length).max(0.0f);
    lanes.mix(kZenith, lanes.sky * (1 - down.square()));
  }
  if (light_.haze > 0) lanes.mix(kHorizon, lanes.hazy * far / (far + light_.haze));
  std::array<Colour, kRays> out;
  for (int i = 0; i < kRays; ++i) {
    out[static_cast<std::size_t>(i)] = {byte(lanes.red[i]), byte(lanes.green[i]),
                                        byte(lanes.blue[i])};
  }
  return out;
}

}  // namespace geom::picture
