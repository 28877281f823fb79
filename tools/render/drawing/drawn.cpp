#include "drawn.h"

#include <cmath>

namespace render {
namespace {

// Okabe and Ito: vermilion, bluish green, reddish purple, blue, orange.
constexpr Colour kWays[] = {
    {213, 94, 0}, {0, 158, 115}, {204, 121, 167}, {0, 114, 178}, {230, 159, 0}};
constexpr Colour kTrees[] = {{86, 140, 196}, {150, 110, 180}};
constexpr Colour kWhite{255, 255, 255};
constexpr Colour kVehicle{24, 24, 24};
constexpr double kStep = 0.05;  // seconds between the points of a way

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

}  // namespace

std::vector<Line> lines_of(const cli::Contents& contents, std::span<const Motion> motions,
                           geom::Axes axes) {
  std::vector<Line> out;
  for (const auto& [record, source, n] : contents.trees) {
    const plan::SearchTree& tree = record.tree;
    for (std::size_t i = 0; i < tree.points.size(); ++i) {
      if (tree.parent[i] == i) continue;
      out.push_back(
          {{geom::to_enu(axes, tree.points[tree.parent[i]]), geom::to_enu(axes, tree.points[i])},
           kTrees[tree.tree[i]],
           1.2,
           false});
    }
  }
  std::size_t next = 0;
  for (const auto& [path, source, n] : contents.paths) {
    Line line{{}, kWays[next++ % std::size(kWays)], 3, true};
    for (const Vec3& p : path.points) line.points.push_back(geom::to_enu(axes, p));
    out.push_back(std::move(line));
  }
  for (const Motion& motion : motions) {
    out.push_back({motion.way(kStep), kWays[next++ % std::size(kWays)], 3, true});
  }
  return out;
}

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

void draw_start(Picture& picture, Spot at, double scale) {
  draw_disc(picture, at, 6.5 * scale, kVehicle);
  draw_disc(picture, at, 4.5 * scale, kWhite);
}

void draw_goal(Picture& picture, Spot at, double scale) {
  draw_disc(picture, at, 6.5 * scale, kWhite);
  draw_disc(picture, at, 4.5 * scale, kVehicle);
}

void draw_ends(Picture& picture, const View& view, std::span<const Line> lines, double scale) {
  for (const Line& line : lines) {
    if (!line.way || line.points.empty()) continue;
    const Vec3 start = project(view, line.points.front());
    const Vec3 goal = project(view, line.points.back());
    if (view.parallel || start.z() > 0) draw_start(picture, {start.x(), start.y()}, scale);
    if (view.parallel || goal.z() > 0) draw_goal(picture, {goal.x(), goal.y()}, scale);
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

}  // namespace render
