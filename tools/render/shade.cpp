#include "render/shade.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geom/label_colour.h"

namespace render {
namespace {

using Rgb = Eigen::Vector3f;  // 0 to 255

constexpr float kHaze = 2500;  // metres at which half of a surface's colour is the horizon's
constexpr float kAmbient = 0.56f;
constexpr float kSun = 0.50f;
constexpr float kSunSpread = 0.013f;  // radians

const Rgb kHorizon(214, 226, 238);
const Rgb kZenith(96, 150, 214);
const Rgb kSoil(196, 194, 186);
const Rgb kGlass(78, 92, 110);

// How much of [x - w/2, x + w/2] the stripes [k period, k period + width] cover, 0 to 1: a box
// filter over the pixel, so that fine lines fade instead of flickering.
float stripes(float x, float w, float period, float width) {
  const auto covered = [&](float at) {
    const float k = std::floor(at / period);
    return k * width + std::min(at - k * period, width);
  };
  return (covered(x + 0.5f * w) - covered(x - 0.5f * w)) / w;
}

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
  const double level = std::cos(light.elevation);
  sun_ = Vec3(level * std::sin(light.azimuth), level * std::cos(light.azimuth),
              std::sin(light.elevation))
             .cast<float>();
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

float Shader::lit(const Vec3& at, const Eigen::Vector3f& normal) const {
  const float facing = std::max(0.0f, normal.dot(sun_));
  if (facing == 0 || !light_.shadows) return kAmbient + 0.08f * normal.z() + kSun * facing;
  const Vec3 off = at + 0.02 * normal.cast<double>();
  return kAmbient + 0.08f * normal.z() + kSun * facing * scene_.unhidden(off, sun_points_);
}

Rgb Shader::ground(const Sight& sight) const {
  const float wide = sight.pixel / std::max(0.02f, std::abs(sight.ray.z()));
  const auto x = static_cast<float>(sight.at.x());
  const auto y = static_cast<float>(sight.at.y());
  const float fine = std::max(stripes(x + 0.1f, wide, 10, 0.2f), stripes(y + 0.1f, wide, 10, 0.2f));
  const float coarse = std::max(stripes(x + 0.4f, wide, 100, 0.8f), stripes(y + 0.4f, wide, 100, 0.8f));
  const Rgb soil = kSoil * (1 - 0.22f * fine) * (1 - 0.25f * coarse);
  return soil * (0.94f * lit(sight.at, Eigen::Vector3f::UnitZ()));
}

Rgb Shader::box(const Sight& sight, const Hit& hit) const {
  const int axis = hit.face % 3;
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  normal[axis] = hit.face < 3 ? -1.0f : 1.0f;
  const geom::Aabb& box = scene_.boxes()[hit.object];
  Rgb base = rgb_of(box_colour_[hit.object]);
  if (!flat_) base *= variation(hit.object);
  if (axis < 2 && !flat_) {
    const float wide = sight.pixel / std::max(0.05f, std::abs(sight.ray[axis]));
    const int along = 1 - axis;
    const auto u = static_cast<float>(sight.at[along] - box.min[along]);
    const auto v = static_cast<float>(sight.at.z() - box.min.z());
    const float window = stripes(u - 1.0f, wide, 4.0f, 2.2f) * stripes(v - 1.0f, wide, 3.5f, 1.6f);
    base = mixed(base, kGlass, 0.45f * window);
  }
  return base * lit(sight.at, normal);
}

Colour Shader::colour(const View& view, double u, double v, const Hit& hit) const {
  const Ray ray = ray_through(view, u, v);
  Sight sight;
  const Eigen::Vector3f direction = ray.direction.cast<float>();
  const float length = direction.norm();
  sight.ray = direction / length;
  Rgb out;
  if (hit.kind == Hit::Kind::sky) {
    out = sky(sight.ray);
  } else {
    sight.at = ray.origin + static_cast<double>(hit.depth) * ray.direction;
    sight.pixel = (view.parallel ? 1.0f : hit.depth * length) / static_cast<float>(view.fx);
    if (hit.kind == Hit::Kind::ground) {
      out = ground(sight);
    } else if (hit.kind == Hit::Kind::box) {
      out = box(sight, hit);
    } else {
      const std::uint32_t c = scene_.tube_colours()[hit.object];
      const Colour base{static_cast<std::uint8_t>(c >> 16), static_cast<std::uint8_t>(c >> 8),
                        static_cast<std::uint8_t>(c)};
      out = rgb_of(base) * (0.75f + 0.3f * std::max(0.0f, hit.normal.dot(sun_)));
    }
    if (!flat_ && hit.kind != Hit::Kind::tube) {
      const float far = hit.depth * length;
      out = mixed(out, kHorizon, far / (far + kHaze));
    }
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
