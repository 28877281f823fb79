#include "fuzz/readers.h"
#include "render/camera/camera_poses.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size,
                          [](std::istream& in) { render::read_camera_poses(in, "fuzz"); });
}
