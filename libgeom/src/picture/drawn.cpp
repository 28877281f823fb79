#include "drawn.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geom/text/excerpt.h"
#include "map_key.h"

namespace geom::picture {
namespace {

constexpr Colour kWhite{255, 255, 255};
constexpr Colour kVehicle{24, 24, 24};
constexpr Colour kZone{163, 71, 0};
constexpr double kFaint = 0.35;
constexpr std::ptrdiff_t kNamed = 16;  // ways whose ids are written
constexpr std::size_t kLongest = 20;   // letters of an id

std::uint32_t packed(Colour c) {
  return (std::uint32_t{c.r} << 16) | (std::uint32_t{c.g} << 8) | c.b;
}

std::vector<Spot> spots(const View& view, std::span<const Vec3> points) {
  std::vector<Spot> out;
  for (const Vec3& p : points) {
    const Vec3 at = project(view, p);
    out.push_back({at.x(), at.y()});
  }
  return out;
}

// Whether a box stands before a point that was projected to `at`.
bool hidden(const PictureScene& scene, const View& view, const Vec3& at) {
  if (!(at.x() >= 0 && at.y() >= 0 && at.x() < view.width && at.y() < view.height)) return false;
  const Hit hit = scene.cast(Rays(view), static_cast<int>(at.x()), static_cast<int>(at.y()))[0];
  return hit.kind == Hit::Kind::box && hit.depth < at.z() * (1 - 1e-3) - 0.05;
}

// Names beside one another: none is written over another, and one that stands there already is not
// written again.
class Names {
 public:
  Names(Picture& picture, int scale) : picture_(picture), scale_(scale) {}

  void draw(Spot at, const std::string& id) {
    const std::string words = excerpt(id, kLongest);
    const double width = text_width(words, scale_);
    const double right = picture_.width - width - 6.0 * scale_;
    Name name{
        {std::min(at.x + 11.0 * scale_, right), std::max(at.y - 13.0 * scale_, 4.0)}, width, words};
    const double row = 13.0 * scale_;
    const double step = name.corner.y < row * static_cast<double>(kNamed) ? row : -row;
    while (const Name* other = below(name)) {
      if (other->words == words) return;
      name.corner.y = other->corner.y + step;
    }
    draw_rectangle(picture_,
                   {{name.corner.x - 3.0 * scale_, name.corner.y - 2.0 * scale_},
                    width + 6.0 * scale_,
                    12.0 * scale_},
                   {kWhite, 0.75});
    draw_text(picture_, name.corner, words, {scale_, kVehicle});
    names_.push_back(std::move(name));
  }

 private:
  struct Name {
    Spot corner;
    double width;
    std::string words;
  };

  const Name* below(const Name& name) const {
    for (const Name& other : names_) {
      if (std::abs(other.corner.y - name.corner.y) < 12.0 * scale_ &&
          other.corner.x < name.corner.x + name.width + 6.0 * scale_ &&
          name.corner.x < other.corner.x + other.width + 6.0 * scale_) {
        return &other;
      }
    }
    return nullptr;
  }

  Picture& picture_;
  int scale_;
  std::vector<Name> names_;
};

}  // namespace

std::vector<Tubes> tubes_of(std::span<const Line> lines, double metres) {
  std::vector<Tubes> out;
  for (const Line& line : lines) {
    const std::uint32_t colour = packed(line.colour);
    const double radius = 0.5 * line.width * metres;
    if (out.empty() || out.back().colour != colour || out.back().radius != radius) {
      out.push_back({{}, {}, radius, colour});
    }
    Tubes& tubes = out.back();
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const auto at = static_cast<std::uint32_t>(tubes.points.size());
      tubes.points.push_back(line.points[i]);
      if (i > 0) tubes.edges.push_back({at - 1, at});
    }
  }
  return out;
}

void draw_lines(Picture& picture, const View& view, std::span<const Line> lines) {
  for (const Line& line : lines) {
    const auto path = spots(view, line.points);
    if (line.width >= 2) draw_line(picture, path, line.width + 3, kWhite);
    draw_line(picture, path, line.width, line.colour);
  }
}

void draw_faintly(Picture& picture, const View& view, std::span<const Line> lines) {
  for (const Line& line : lines) {
    if (line.way) draw_line(picture, spots(view, line.points), line.width, {line.colour, kFaint});
  }
}

void draw_start(Picture& picture, Spot at, double scale, double share) {
  draw_ring(picture, {at, 6.5 * scale, 4.5 * scale}, {kWhite, share});
  draw_ring(picture, {at, 6.5 * scale, 2 * scale}, {kVehicle, share});
}

void draw_goal(Picture& picture, Spot at, double scale, double share) {
  draw_disc(picture, at, 4.5 * scale, {kWhite, share});
  draw_disc(picture, at, 3.2 * scale, {kVehicle, share});
}

void draw_ends(Picture& picture, const View& view, const PictureScene& scene,
               std::span<const Line> lines) {
  const int scale = std::max(1, key_scale(picture));
  const auto each = [&](const auto& end_of, const auto& draw) {
    for (const Line& line : lines) {
      if (!line.way || line.points.empty()) continue;
      const Vec3 at = project(view, end_of(line.points));
      if (!view.parallel && at.z() <= 0) continue;
      draw(line, Spot{at.x(), at.y()}, hidden(scene, view, at) ? kFaint : 1);
    }
  };
  const auto start = [](const auto& points) { return points.front(); };
  const auto goal = [](const auto& points) { return points.back(); };
  each(start, [&](const Line&, Spot at, double share) { draw_start(picture, at, scale, share); });
  each(goal, [&](const Line&, Spot at, double share) { draw_goal(picture, at, scale, share); });
  const auto ways = std::count_if(lines.begin(), lines.end(), [](const Line& l) { return l.way; });
  if (ways > kNamed) return;
  Names names(picture, scale);
  each(start, [&](const Line& line, Spot at, double) { names.draw(at, line.id); });
}

void draw_zones(Picture& picture, const View& view, std::span<const Aabb> zones) {
  for (const Aabb& zone : zones) {
    const auto corner = [&](int i) {
      const Vec3 at =
          project(view, {(i & 1 ? zone.max : zone.min).x(), (i & 2 ? zone.max : zone.min).y(),
                         (i & 4 ? zone.max : zone.min).z()});
      return Spot{at.x(), at.y()};
    };
    for (int i = 0; i < 8; ++i) {
      for (const int bit : {1, 2, 4}) {
        if (i & bit) continue;
        const std::array<Spot, 2> edge{corner(i), corner(i | bit)};
        draw_line(picture, edge, 1.4, {kZone, 0.7});
      }
    }
  }
}

void draw_vehicle(Picture& picture, const View& view, const Pose& pose) {
  const Vec3 at = project(view, pose.position);
  if (!view.parallel && at.z() <= 0) return;
  const Vec3 ahead = pose.attitude.col(0);
  const Vec3 tip = project(view, pose.position + ahead);
  const double dx = tip.x() - at.x();
  const double dy = tip.y() - at.y();
  const double length = std::max(std::hypot(dx, dy), 1e-9);
  const Spot nose{at.x() + 15 * dx / length, at.y() + 15 * dy / length};
  const Spot centre{at.x(), at.y()};
  const std::vector<Spot> needle{centre, nose};
  draw_line(picture, needle, 7, kWhite);
  draw_disc(picture, centre, 9, kWhite);
  draw_line(picture, needle, 3.5, kVehicle);
  draw_disc(picture, centre, 6.5, kVehicle);
}

}  // namespace geom::picture
