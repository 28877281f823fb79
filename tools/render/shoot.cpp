#include "shoot.h"

#include <algorithm>
#include <chrono>
#include <ctime>

#include "cli/file/frame_output.h"
#include "geom/base/parallel.h"
#include "geom/picture/camera_poses.h"
#include "geom/picture/image_file.h"
#include "geom/picture/png_image.h"

namespace render {
namespace {

using cli::FrameOutput;
using geom::picture::kPosesHeader;
using geom::picture::Picture;

using geom::picture::colour_png;
using geom::picture::depth_png;
using geom::picture::id_png;
using geom::picture::pfm;
using geom::picture::pose_row;
using geom::picture::y4m_frame;
using geom::picture::y4m_header;

constexpr std::size_t kBatch = 8;  // frames in memory at a time; more with more threads

double cpu_of_process() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Wall and CPU time (of all threads) of something that is done again and again.
class Stopwatch {
 public:
  template <class F>
  auto time(const F& f) {
    const auto begin = std::chrono::steady_clock::now();
    const double cpu_before = cpu_of_process();
    auto out = f();
    wall += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    cpu += cpu_of_process() - cpu_before;
    return out;
  }
  double wall = 0;
  double cpu = 0;
};

struct Encoded {
  std::string colour;
  std::string depth;
  std::string ids;
};

Encoded encoded(const Picture& picture, const Options& options) {
  Picture bare;  // depth and ids have the size of the camera, also in a combined frame
  bare.width = options.has_eye() ? options.film.camera.width : picture.width;
  bare.height = options.has_eye() ? options.film.camera.height : picture.height;
  bare.depth = picture.depth;
  bare.id = picture.id;
  Encoded out;
  out.colour = options.is_video() ? y4m_frame(picture) : colour_png(picture);
  if (!options.depth.empty()) {
    out.depth = options.depth.ends_with(".pfm") ? pfm(bare) : depth_png(bare, options.depth_unit);
  }
  if (!options.ids.empty()) out.ids = id_png(bare);
  return out;
}

struct Outputs {
  FrameOutput colour;
  FrameOutput depth;
  FrameOutput ids;
  FrameOutput poses;

  void write(std::size_t frame, const Encoded& bytes) {
    colour.write(frame, bytes.colour);
    depth.write(frame, bytes.depth);
    ids.write(frame, bytes.ids);
  }
  void commit() {
    for (FrameOutput* output : {&colour, &depth, &ids, &poses}) output->commit();
  }
};

}  // namespace

nlohmann::ordered_json shoot(const geom::picture::Film& film, const Times& times,
                             const Options& options, const geom::Execution& run) {
  Outputs to{FrameOutput(options.colour, times.size(), options.is_video()),
             FrameOutput(options.depth, times.size(), false),
             FrameOutput(options.ids, times.size(), false),
             FrameOutput(options.poses, times.size(), true)};
  if (options.is_video()) to.colour.begin(y4m_header(film.width(), film.height(), options.rate));
  to.poses.begin(std::string(kPosesHeader) + '\n');
  geom::Execution quiet = run;
  quiet.progress = nullptr;
  Stopwatch casting;
  Stopwatch writing;
  const std::size_t batch = std::max<std::size_t>(kBatch, run.threads);
  for (std::size_t first = 0; first < times.size(); first += batch) {
    const std::size_t count = std::min(batch, times.size() - first);
    const auto begin = times.begin() + static_cast<std::ptrdiff_t>(first);
    const Times part(begin, begin + static_cast<std::ptrdiff_t>(count));
    const auto pictures = casting.time([&] { return film.frames(part, quiet); });
    writing.time([&] {
      std::vector<Encoded> bytes(count);
      geom::parallel_for(count, quiet,
                         [&](std::size_t i) { bytes[i] = encoded(pictures[i], options); });
      for (std::size_t i = 0; i < count; ++i) {
        to.write(first + i, bytes[i]);
        if (part[i]) to.poses.write(first + i, pose_row(film.view(*part[i]), first + i, *part[i]));
      }
      return 0;
    });
    if (run.progress) run.progress(first + count, times.size());
  }
  to.commit();
  return {{"frames", times.size()},    {"width", film.width()},
          {"height", film.height()},   {"threads", run.threads},
          {"casting_s", casting.wall}, {"casting_cpu_s", casting.cpu},
          {"writing_s", writing.wall}, {"writing_cpu_s", writing.cpu}};
}

}  // namespace render
