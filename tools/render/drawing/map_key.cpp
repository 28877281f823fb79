#include "map_key.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "drawn.h"

namespace render {
namespace {

constexpr Colour kInk{30, 30, 30};
constexpr Colour kPlate{255, 255, 255};
constexpr double kPlateShare = 0.82;
constexpr int kSmallest = 240;         // pixels of the shorter side of a picture with a key
constexpr double kFinestCell = 7;      // pixels: finer lines are not seen
constexpr double kBarOfPicture = 0.2;  // at most, of a plan's width
constexpr double kBarOfEdge = 0.3;     // at most, of the map's edge in an overview
constexpr double kBesideMap = 0.02;    // of the map's longer side: from its edge to the bar

void draw_plate(Picture& picture, Spot corner, double width, double height) {
  draw_rectangle(picture, {corner, width, height}, kPlate, kPlateShare);
}

Spot spot(const View& view, const Vec3& point) {
  const Vec3 at = project(view, point);
  return {at.x(), at.y()};
}

double pixels_per_metre(const View& view, const Vec3& at) {
  return view.parallel ? view.fx : view.fx / std::max(project(view, at).z(), 1e-9);
}

// On the ground, in the middle of the map.
Vec3 middle(const MapKey& key) {
  Vec3 out = 0.5 * (key.ground.min + key.ground.max);
  out.z() = key.ground.min.z();
  return out;
}

void draw_bar(Picture& picture, std::array<Spot, 2> bar, Spot tick, int scale) {
  const auto stroke = [&](double width, Colour colour) {
    draw_line(picture, bar, width, colour);
    for (const Spot& end : bar) {
      const std::array<Spot, 2> line{
          {{end.x - tick.x, end.y - tick.y}, {end.x + tick.x, end.y + tick.y}}};
      draw_line(picture, line, width, colour);
    }
  };
  stroke(1.5 * scale + 3, kPlate);
  stroke(1.5 * scale, kInk);
}

// The words about the grid: its cells, and the fine ones where they are seen.
std::string grid_words(const View& view, const MapKey& key) {
  std::string words = "grid " + length_words(key.grid.cell);
  if (key.grid.fine * pixels_per_metre(view, middle(key)) >= kFinestCell) {
    words += ", fine " + length_words(key.grid.fine);
  }
  return words;
}

// Rows in the lower left corner, on one plate.
class Corner {
 public:
  Corner(Picture& picture, int scale, int rows, double width)
      : picture_(picture), scale_(scale), x_(14.0 * scale) {
    const double height = rows * kRow * scale + 6.0 * scale;
    y_ = picture.height - 8.0 * scale - height;
    draw_plate(picture, {8.0 * scale, y_}, width + 12.0 * scale, height);
    y_ += 6.0 * scale;
  }
  void words(std::string_view text, double indent = 0) {
    draw_text(picture_, {x_ + indent, y_}, text, scale_, kInk);
  }
  Spot spot(double dx) const { return {x_ + dx, y_ + 3.0 * scale_}; }
  void next() { y_ += kRow * scale_; }

  static constexpr double kRow = 13;  // pixels, times the scale

 private:
  Picture& picture_;
  int scale_;
  double x_;
  double y_;
};

// "start" and "goal" beside their discs.
void draw_ends_row(Picture& picture, Corner& corner, int scale) {
  const double second = 20.0 * scale + text_width("start", scale);
  draw_start(picture, corner.spot(4.0 * scale), 0.75 * scale);
  corner.words("start", 12.0 * scale);
  draw_goal(picture, corner.spot(second + 8.0 * scale), 0.75 * scale);
  corner.words("goal", second + 16.0 * scale);
}

double ends_width(int scale) {
  return 36.0 * scale + text_width("start", scale) + text_width("goal", scale);
}

void draw_corner(Picture& picture, const View& view, const MapKey& key, int scale) {
  const std::string grid = grid_words(view, key);
  const double bar = view.parallel ? round_length(kBarOfPicture * view.width / view.fx) : 0;
  const double bar_pixels = bar * view.fx;
  const std::string bar_words = length_words(bar);
  double width = text_width(grid, scale);
  if (key.ways) width = std::max(width, ends_width(scale));
  if (bar > 0) width = std::max(width, bar_pixels + 10.0 * scale + text_width(bar_words, scale));
  Corner corner(picture, scale, 1 + key.ways + (bar > 0), width);
  if (key.ways) {
    draw_ends_row(picture, corner, scale);
    corner.next();
  }
  corner.words(grid);
  corner.next();
  if (bar > 0) {
    draw_bar(picture, {corner.spot(0), corner.spot(bar_pixels)}, {0, 2.5 * scale}, scale);
    corner.words(bar_words, bar_pixels + 8.0 * scale);
  }
}

// An edge of the map on the ground, seen from outside.
struct Edge {
  Vec3 middle;
  Vec3 along;    // of length 1
  Vec3 outward;  // of length 1
  double length;
};

std::array<Edge, 4> edges_of(const geom::Aabb& ground) {
  const Vec3 centre(0.5 * (ground.min.x() + ground.max.x()),
                    0.5 * (ground.min.y() + ground.max.y()), ground.min.z());
  const Vec3 size = ground.max - ground.min;
  std::array<Edge, 4> out;
  for (int i = 0; i < 4; ++i) {
    const Vec3 outward = (i % 2 ? 1 : -1) * (i < 2 ? Vec3::UnitX() : Vec3::UnitY());
    const int across = i < 2 ? 0 : 1;
    out[static_cast<std::size_t>(i)] = {centre + 0.5 * size[across] * outward,
                                        i < 2 ? Vec3::UnitY() : Vec3::UnitX(), outward,
                                        size[1 - across]};
  }
  return out;
}

// The edge that looks longest, of the two that look nearest.
Edge bar_edge(const View& view, const geom::Aabb& ground) {
  auto edges = edges_of(ground);
  const auto lower = [&](const Edge& a, const Edge& b) {
    return spot(view, a.middle).y > spot(view, b.middle).y;
  };
  const auto seen = [&](const Edge& e) {
    return std::abs(spot(view, e.middle + 0.5 * e.length * e.along).x -
                    spot(view, e.middle - 0.5 * e.length * e.along).x);
  };
  std::stable_sort(edges.begin(), edges.end(), lower);
  return seen(edges[1]) > seen(edges[0]) ? edges[1] : edges[0];
}

void draw_ground_bar(Picture& picture, const View& view, const MapKey& key, int scale) {
  const Edge edge = bar_edge(view, key.ground);
  const double side = (key.ground.max - key.ground.min).head<2>().maxCoeff();
  if (!(edge.length > 0)) return;
  const double metres = round_length(kBarOfEdge * edge.length);
  const Vec3 at = edge.middle + kBesideMap * side * edge.outward;
  const Spot a = spot(view, at - 0.5 * metres * edge.along);
  const Spot b = spot(view, at + 0.5 * metres * edge.along);
  const double away = std::hypot(b.x - a.x, b.y - a.y);
  const Spot tick{-(b.y - a.y) / away * 2.5 * scale, (b.x - a.x) / away * 2.5 * scale};
  draw_bar(picture, {a, b}, tick, scale);
  const std::string words = length_words(metres);
  const double width = text_width(words, scale);
  // Beside the middle of the bar, on its outer side, inside the picture.
  const Spot out = spot(view, at + 0.05 * side * edge.outward);
  const Spot middle{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
  const double outside = std::max(1e-9, std::hypot(out.x - middle.x, out.y - middle.y));
  const double reach = 0.5 * width + 6.0 * scale;
  const Spot centre{middle.x + (out.x - middle.x) / outside * reach,
                    middle.y + (out.y - middle.y) / outside * 12.0 * scale};
  const Spot corner{
      std::clamp(centre.x - 0.5 * width, 4.0 * scale, picture.width - width - 4.0 * scale),
      std::clamp(centre.y - 3.5 * scale, 4.0 * scale, picture.height - 11.0 * scale)};
  draw_plate(picture, {corner.x - 3.0 * scale, corner.y - 3.0 * scale}, width + 6.0 * scale,
             13.0 * scale);
  draw_text(picture, corner, words, scale, kInk);
}

void draw_n(Picture& picture, Spot centre, int scale) {
  const double w = 2.4 * scale;
  const double h = 3.6 * scale;
  const std::array<Spot, 4> strokes{{{centre.x - w, centre.y + h},
                                     {centre.x - w, centre.y - h},
                                     {centre.x + w, centre.y + h},
                                     {centre.x + w, centre.y - h}}};
  draw_line(picture, strokes, 1.2 * scale, kInk);
}

// In the upper right corner: where north is in the middle of the map.
void draw_north(Picture& picture, const View& view, const MapKey& key, int scale) {
  const double step = 1e-3 * (key.ground.max - key.ground.min).norm() + 1e-6;
  const Spot from = spot(view, middle(key));
  const Spot to = spot(view, middle(key) + step * Vec3::UnitY());
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (!(length > 0)) return;
  const Spot north{(to.x - from.x) / length, (to.y - from.y) / length};
  const Spot right{-north.y, north.x};
  const double room = 24.0 * scale;
  const Spot centre{picture.width - 8.0 * scale - room, 8.0 * scale + room};
  const auto at = [&](double ahead, double aside) {
    return Spot{centre.x + (ahead * north.x + aside * right.x) * scale,
                centre.y + (ahead * north.y + aside * right.y) * scale};
  };
  draw_disc(picture, centre, room, {236, 236, 236});
  draw_disc(picture, centre, room - scale, kPlate);
  const std::array<Spot, 2> shaft{at(-16, 0), at(8, 0)};
  const std::array<Spot, 3> head{at(3, -4.5), at(9, 0), at(3, 4.5)};
  draw_line(picture, shaft, 1.6 * scale, kInk);
  draw_line(picture, head, 1.6 * scale, kInk);
  draw_n(picture, at(16.5, 0), scale);
}

}  // namespace

std::string length_words(double metres) {
  return metres >= 1000 ? fmt::format("{:g} km", metres / 1000) : fmt::format("{:g} m", metres);
}

int key_scale(const Picture& picture) {
  const int side = std::min(picture.width, picture.height);
  return side < kSmallest ? 0 : std::max(1, static_cast<int>(std::lround(side / 480.0)));
}

void draw_map_key(Picture& picture, const View& view, const MapKey& key) {
  const int scale = key_scale(picture);
  if (scale == 0) return;
  if (!view.parallel) draw_ground_bar(picture, view, key, scale);
  draw_corner(picture, view, key, scale);
  draw_north(picture, view, key, scale);
}

}  // namespace render
