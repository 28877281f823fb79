#pragma once

// Pictures that skyway-render took along a motion.

#include <string>
#include <vector>

#include "geom/picture/camera_poses.h"

namespace view {

struct FrameFiles {
  std::string names;  // numbered, as f-%05d.png
  std::string poses;  // CSV; - for stdin
};

struct Frame {
  geom::picture::CameraPose pose;
  std::string webp;
};

struct Frames {
  std::string source;  // of the poses
  int width = 0;       // pixels, of all
  int height = 0;
  std::vector<Frame> list;  // times grow; at least one

  std::size_t bytes() const;
};

// A picture for each row of the poses. Throws geom::InputError for poses or pictures that are none,
// pictures of different sizes and more than 256 MB; std::system_error where one cannot be read;
// cli::UsageError for several frames and a name without a number.
Frames read_frames(const FrameFiles& files);

}  // namespace view
