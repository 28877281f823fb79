#include "map_key.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "drawn.h"

namespace geom::picture {
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
  draw_rectangle(picture, {corner, width, height}, {kPlate, kPlateShare});
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

constexpr double kRow = 14;   // pixels, times the scale
constexpr double kBand = 44;  // the band of the key, times the scale

// Words and marks side by side in the band below the map.
class Row {
 public:
  Row(Picture& picture, int scale, int row)
      : picture_(picture),
        scale_(scale),
        x_(12.0 * scale),
        y_(picture.height - (kBand - 9 - row * kRow) * scale) {}
  void words(std::string_view text) {
    draw_text(picture_, {x_, y_}, text, {scale_, kInk});
    skip(text_width(text, scale_) / scale_);
  }
  void skip(double width) { x_ += width * scale_; }
  Spot spot(double dx = 0) const { return {x_ + dx, y_ + 4.0 * scale_}; }

 private:
  Picture& picture_;
  int scale_;
  double x_;
  double y_;
};

// "start" and "goal" beside their marks.
void add_ends(Picture& picture, Row& row, int scale) {
  row.skip(6);
  draw_start(picture, row.spot(), 0.75 * scale);
  row.skip(11);
  row.words("start");
  row.skip(14);
  draw_goal(picture, row.spot(), scale);
  row.skip(9);
  row.words("goal");
  row.skip(14);
}

void draw_band(Picture& picture, const View& view, const MapKey& key, int scale) {
  draw_rectangle(
      picture,
      {{0, picture.height - kBand * scale}, static_cast<double>(picture.width), kBand * scale},
      kPlate);
  Row row(picture, scale, 0);
  if (view.parallel) {
    const double bar = round_length(kBarOfPicture * view.width / view.fx);
    draw_bar(picture, {row.spot(), row.spot(bar * view.fx)}, {0, 2.5 * scale}, scale);
    row.skip(bar * view.fx / scale + 8);
    row.words(length_words(bar));
    row.skip(14);
  }
  if (key.ways) add_ends(picture, row, scale);
  Row below(picture, scale, view.parallel || key.ways ? 1 : 0);
  below.words(grid_words(view, key));
}

// An edge of the map on the ground, seen from outside.
struct Edge {
  Vec3 middle;
  Vec3 along;    // of length 1
  Vec3 outward;  // of length 1
  double length;
};

std::array<Edge, 4> edges_of(const Aabb& ground) {
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
Edge bar_edge(const View& view, const Aabb& ground) {
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
             14.0 * scale);
  draw_text(picture, corner, words, {scale, kInk});
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

// At the right of the band: where north is in the middle of the map.
void draw_north(Picture& picture, const View& view, const MapKey& key, int scale) {
  const double step = 1e-3 * (key.ground.max - key.ground.min).norm() + 1e-6;
  const Spot from = spot(view, middle(key));
  const Spot to = spot(view, middle(key) + step * Vec3::UnitY());
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (!(length > 0)) return;
  const Spot north{(to.x - from.x) / length, (to.y - from.y) / length};
  const Spot right{-north.y, north.x};
  const double room = 19.0 * scale;
  const Spot centre{picture.width - 10.0 * scale - room, picture.height - 0.5 * kBand * scale};
  const auto at = [&](double ahead, double aside) {
    return Spot{centre.x + (ahead * north.x + aside * right.x) * scale,
                centre.y + (ahead * north.y + aside * right.y) * scale};
  };
  draw_ring(picture, {centre, room - 0.5 * scale, 1.0 * scale}, Colour{200, 200, 200});
  const std::array<Spot, 2> shaft{at(-13, 0), at(6, 0)};
  const std::array<Spot, 3> head{at(1.5, -4), at(7, 0), at(1.5, 4)};
  draw_line(picture, shaft, 1.6 * scale, kInk);
  draw_line(picture, head, 1.6 * scale, kInk);
  draw_n(picture, at(12.5, 0), scale);
}

}  // namespace

std::string length_words(double metres) {
  return metres >= 1000 ? fmt::format("{:g} km", metres / 1000) : fmt::format("{:g} m", metres);
}

namespace {

int scale_of(int side) {
  return side < kSmallest ? 0 : std::max(1, static_cast<int>(std::lround(side / 480.0)));
}

}  // namespace

int key_scale(const Picture& picture) { return scale_of(std::min(picture.width, picture.height)); }

int key_band(int width, int height) {
  return static_cast<int>(kBand) * scale_of(std::min(width, height));
}

void draw_map_key(Picture& picture, const View& view, const MapKey& key) {
  const int scale = key_scale(picture);
  if (scale == 0) return;
  draw_band(picture, view, key, scale);
  if (!view.parallel) draw_ground_bar(picture, view, key, scale);
  draw_north(picture, view, key, scale);
}

}  // namespace geom::picture
