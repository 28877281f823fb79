#pragma once

// Paths, trees and ways of vehicles as they are drawn on maps and in overviews.

#include <span>
#include <vector>

#include "canvas.h"
#include "cli/content/contents.h"
#include "render/camera/motion.h"
#include "render/scene/embree_picture.h"

namespace render {

struct Line {
  std::vector<Vec3> points;  // ENU
  Colour colour;
  double width = 3;  // pixels
  bool way = false;  // from a start to a goal, which are marked
};

// Of everything that is there: trees first, then paths, then ways.
std::vector<Line> lines_of(const cli::Contents& contents, std::span<const Motion> motions,
                           geom::Axes axes);
// The same in space; a pixel is `metres` there.
std::vector<Tubes> tubes_of(std::span<const Line> lines, double metres);

void draw_lines(Picture& picture, const View& view, std::span<const Line> lines);
// A white disc at the start and a dark one at the goal of each way, `scale` times their size.
void draw_ends(Picture& picture, const View& view, std::span<const Line> lines, double scale);
// The two discs themselves.
void draw_start(Picture& picture, Spot at, double scale);
void draw_goal(Picture& picture, Spot at, double scale);
// A disc that points to where the vehicle looks.
void draw_vehicle(Picture& picture, const View& view, const Pose& pose);

}  // namespace render
