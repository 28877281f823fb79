#include "fuzz/readers.h"
#include "geom/picture/camera.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  return refuses_or_reads(data, size, [&](std::istream&) {
    geom::picture::parse_camera(geom::JsonFields(text, "fuzz", 0));
  });
}
