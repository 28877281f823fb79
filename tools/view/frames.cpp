#include "frames.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/file/files.h"
#include "cli/file/frame_output.h"
#include "cli/run.h"
#include "geom/base/error.h"
#include "webp_frame.h"

namespace view {
namespace {

constexpr int kMostSide = 4096;
constexpr std::size_t kMostBytes = 256u << 20;  // what a browser still takes as one text

std::string read_picture(const std::string& name, Frames& frames) {
  cli::InputFile file(name);
  const geom::picture::Pixels picture = geom::picture::read_png(file.read_all(), file.name());
  if (frames.list.empty()) {
    frames.width = picture.width;
    frames.height = picture.height;
  }
  if (picture.width != frames.width || picture.height != frames.height) {
    throw geom::InputError(name, {.expected = fmt::format("{} x {} pixels, as the first frame has",
                                                          frames.width, frames.height),
                                  .found = fmt::format("{} x {}", picture.width, picture.height)});
  }
  if (std::max(picture.width, picture.height) > kMostSide) {
    throw geom::InputError(name, {.expected = fmt::format("at most {} pixels a side", kMostSide),
                                  .found = fmt::format("{} x {}", picture.width, picture.height)});
  }
  return webp(picture);
}

}  // namespace

std::size_t Frames::bytes() const {
  std::size_t sum = 0;
  for (const Frame& frame : list) sum += frame.webp.size();
  return sum;
}

Frames read_frames(const FrameFiles& files) {
  cli::InputFile file(files.poses);
  const auto poses = geom::picture::read_camera_poses(file.stream(), file.name());
  if (poses.size() > 1 && !cli::is_numbered(files.names)) {
    throw cli::UsageError(
        fmt::format("--frames: expected a name with a number for {} frames, as "
                    "\"frame-%05d.png\", found \"{}\"",
                    poses.size(), files.names));
  }
  Frames out{file.name(), 0, 0, {}};
  std::size_t bytes = 0;
  for (const geom::picture::CameraPose& pose : poses) {
    const std::string name = cli::numbered(files.names, out.list.size());
    out.list.push_back({pose, read_picture(name, out)});
    bytes += out.list.back().webp.size();
    if (bytes > kMostBytes) {
      throw geom::InputError(
          name,
          {.expected = fmt::format("at most {} MB of frames", kMostBytes >> 20), .found = "more"});
    }
  }
  return out;
}

}  // namespace view
