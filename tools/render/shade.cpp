#include "render/shade.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geom/label_colour.h"

namespace render {
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
const Rgb kGlass(78, 92, 110);

// Stripes of `width` at every multiple of `period`, as a pixel of width w sees them at x: the share
// that they cover of [x - w/2, x + w/2], so that fine lines fade instead of flickering. Positions
// are within 2^31 periods of 0.
struct Stripes {
  float period;
  float width;

  // How much they cover from 0 to x.
  float covered(float x) const {
    const float k = x * (1 / period);
    auto whole = static_cast<float>(static_cast<std::int32_t>(k));
    if (whole > k) whole -= 1;
    return whole * width + std::min(x - whole * period, width);
  }
  // `per_pixel` is 1 / w.
  float operator()(float x, float w, float per_pixel) const {
    if (w >= 2 * period) return width / period;
    return (covered(x + 0.5f * w) - covered(x - 0.5f * w)) * per_pixel;
  }
};

constexpr Stripes kStreetGrid{10, 0.2f};
constexpr Stripes kBlockGrid{100, 0.8f};
constexpr Stripes kWindowsAcross{4, 2.2f};
constexpr Stripes kStoreys{3.5f, 1.6f};

Rgb mixed(const Rgb& a, const Rgb& b, float share) { return a + (b - a) * share; }

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

struct Shader::Sight {
  Vec3 at;               // ENU
  Eigen::Vector3f ray;   // of length 1
  float pixel;           // metres across a pixel at the surface, facing it
};

Shader::Shader(const PictureScene& scene, std::vector<Colour> box_colour, const Light& light,
               bool flat)
    : scene_(scene), box_colour_(std::move(box_colour)), light_(light), flat_(flat) {
  grid_x_ = 100 * std::round(scene.middle().x() / 100);
  grid_y_ = 100 * std::round(scene.middle().y() / 100);
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

Rgb Shader::sky(const Eigen::Vector3f& direction) const {
  if (flat_) return {250, 250, 250};
  const float up = std::clamp(direction.z(), 0.0f, 1.0f);
  return mixed(kHorizon, kZenith, 1 - (1 - up) * (1 - up));
}

float Shader::lit(const Vec3& at, int face) const {
  if (direct_[face] == 0 || !light_.shadows) return ambient_[face] + direct_[face];
  Vec3 off = at;
  off[face % 3] += face < 3 ? -0.02 : 0.02;
  return ambient_[face] + direct_[face] * scene_.unhidden(off, sun_points_);
}

Rgb Shader::ground(const Sight& sight) const {
  const float wide = sight.pixel / std::max(0.02f, std::abs(sight.ray.z()));
  const float per_metre = 1 / wide;  // pixels
  const auto x = static_cast<float>(sight.at.x() - grid_x_);
  const auto y = static_cast<float>(sight.at.y() - grid_y_);
  // A grid whose lines nearly touch is only a pattern of the pixels.
  const float fine_share = 0.24f * std::clamp(1.5f - wide, 0.0f, 1.0f);
  const float fine = std::max(kStreetGrid(x + 0.1f, wide, per_metre), kStreetGrid(y + 0.1f, wide, per_metre));
  const float coarse = std::max(kBlockGrid(x + 0.4f, wide, per_metre), kBlockGrid(y + 0.4f, wide, per_metre));
  const Rgb soil = (flat_ ? kPaper : kSoil) * (1 - fine_share * fine) * (1 - 0.25f * coarse);
  return soil * (0.94f * lit(sight.at, kUp));
}

Rgb Shader::box(const Sight& sight, const Hit& hit) const {
  const int axis = hit.face % 3;
  const geom::Aabb& box = scene_.boxes()[hit.object];
  Rgb base = rgb_of(box_colour_[hit.object]);
  if (!flat_) base *= variation(hit.object);
  if (axis < 2 && !flat_) {
    const float wide = sight.pixel / std::max(0.05f, std::abs(sight.ray[axis]));
    const float per_metre = 1 / wide;  // pixels
    const int along = 1 - axis;
    const auto u = static_cast<float>(sight.at[along] - box.min[along]);
    const auto v = static_cast<float>(sight.at.z() - box.min.z());
    const float window = kWindowsAcross(u - 1, wide, per_metre) * kStoreys(v - 1, wide, per_metre);
    base = mixed(base, kGlass, 0.45f * window);
  }
  return base * lit(sight.at, hit.face);
}

Rgb Shader::tube(const Hit& hit) const {
  const std::uint32_t c = scene_.tube_colours()[hit.object];
  const Rgb base(static_cast<float>(c >> 16 & 255), static_cast<float>(c >> 8 & 255),
                 static_cast<float>(c & 255));
  return base * (0.75f + 0.3f * std::max(0.0f, hit.normal.dot(sun_)));
}

Colour Shader::colour(const Rays& rays, double u, double v, const Hit& hit) const {
  const Ray ray = rays.through(u, v);
  const Eigen::Vector3f direction = ray.direction.cast<float>();
  const float squared = direction.squaredNorm();
  const float shorten = 1 / std::sqrt(squared);
  Sight sight;
  sight.ray = direction * shorten;
  Rgb out;
  if (hit.kind == Hit::Kind::sky) {
    out = sky(sight.ray);
  } else if (hit.kind == Hit::Kind::tube) {
    out = tube(hit);
  } else {
    const float far = hit.depth * squared * shorten;
    sight.at = ray.origin + static_cast<double>(hit.depth) * ray.direction;
    sight.pixel = (rays.parallel() ? 1.0f : far) * static_cast<float>(rays.pixel());
    out = hit.kind == Hit::Kind::ground ? ground(sight) : box(sight, hit);
    if (light_.haze > 0) out = mixed(out, kHorizon, far / (far + light_.haze));
  }
  return {byte(out[0]), byte(out[1]), byte(out[2])};
}

std::vector<Colour> box_colours(const geom::BoxMap& map) {
  const bool labelled = map.labels().size() > 1;
  const double floor = map.spec().bounds.min.z();
  double top = floor + 1;
  for (const geom::Aabb& box : map.boxes()) top = std::max(top, box.max.z());
  std::vector<Colour> out;
  out.reserve(map.size());
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (labelled) {
      const auto c = geom::label_colour(map.label()[i]);
      out.push_back({c[0], c[1], c[2]});
      continue;
    }
    // From warm stone to cool steel with the height of the top.
    const auto share = static_cast<float>(std::sqrt((map.boxes()[i].max.z() - floor) / (top - floor)));
    const Rgb c = mixed(Rgb(222, 206, 182), Rgb(126, 152, 186), std::clamp(share, 0.0f, 1.0f));
    out.push_back({byte(c[0]), byte(c[1]), byte(c[2])});
  }
  return out;
}

}  // namespace render
