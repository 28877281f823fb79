#include "fuzz/readers.h"
#include "geom/picture/camera_poses.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return refuses_or_reads(data, size,
                          [](std::istream& in) { geom::picture::read_camera_poses(in, "fuzz"); });
}
