#pragma once

// The names of the library's room of pictures that skyway-render uses as its own.

#include "geom/picture/camera.h"
#include "geom/picture/camera_poses.h"
#include "geom/picture/grid_lines.h"
#include "geom/picture/image_file.h"
#include "geom/picture/look.h"
#include "geom/picture/picture.h"
#include "geom/picture/picture_scene.h"
#include "geom/picture/shade.h"
#include "geom/picture/take.h"
#include "geom/picture/view.h"

namespace render {

using geom::Vec3;
using geom::picture::Camera;
using geom::picture::Colour;
using geom::picture::GridLines;
using geom::picture::Hit;
using geom::picture::Light;
using geom::picture::Look;
using geom::picture::OverviewOptions;
using geom::picture::Picture;
using geom::picture::PictureScene;
using geom::picture::Pose;
using geom::picture::Rays;
using geom::picture::Shader;
using geom::picture::Tubes;
using geom::picture::View;
using geom::picture::Wanted;

using geom::picture::grid_lines;
using geom::picture::kPosesHeader;
using geom::picture::look_of;
using geom::picture::overview;
using geom::picture::parse_camera;
using geom::picture::pfm;
using geom::picture::plan_view;
using geom::picture::pose_row;
using geom::picture::project;
using geom::picture::round_length;
using geom::picture::take_pictures;
using geom::picture::view_from;
using geom::picture::y4m_frame;
using geom::picture::y4m_header;

}  // namespace render
