#pragma once

// Paths, trees and ways of vehicles as they are drawn on maps and in overviews.

#include <span>
#include <vector>

#include "canvas.h"
#include "geom/picture/camera.h"
#include "geom/picture/line.h"
#include "geom/picture/picture_scene.h"
#include "geom/picture/view.h"

namespace geom::picture {

// The lines in space, where a pixel is `metres`.
std::vector<Tubes> tubes_of(std::span<const Line> lines, double metres);

void draw_lines(Picture& picture, const View& view, std::span<const Line> lines);
// Ways once more, faintly, so that what stands before them does not hide them.
void draw_faintly(Picture& picture, const View& view, std::span<const Line> lines);
// A ring at the start and a dot at the goal of each way, as large as the picture's key
// (map_key.h); faint where a box of the scene hides them. With few ways also their ids.
void draw_ends(Picture& picture, const View& view, const PictureScene& scene,
               std::span<const Line> lines);
// The two marks themselves. A dot within a ring is seen.
void draw_start(Picture& picture, Spot at, double scale, double share = 1);
void draw_goal(Picture& picture, Spot at, double scale, double share = 1);
// Edges of boxes as thin lines: of the air that is kept out of.
void draw_zones(Picture& picture, const View& view, std::span<const Aabb> zones);
// A disc that points to where the vehicle looks.
void draw_vehicle(Picture& picture, const View& view, const Pose& pose);

}  // namespace geom::picture
