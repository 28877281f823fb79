#include "fuzz/reader.h"
#include "geom/picture/camera.h"
#include "geom/picture/camera_poses.h"
#include "geom/picture/png_image.h"

std::vector<fuzz::Reader> fuzz::readers() {
  return {{"camera",
           [](std::istream& in) {
             geom::picture::parse_camera(geom::JsonFields(fuzz::rest_of(in), "fuzz", 0));
           }},
          {"camera_poses", [](std::istream& in) { geom::picture::read_camera_poses(in, "fuzz"); }},
          {"png", [](std::istream& in) { geom::picture::read_png(fuzz::rest_of(in), "fuzz"); }}};
}
