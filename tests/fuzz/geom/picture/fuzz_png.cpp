#include "fuzz/readers.h"
#include "geom/picture/png_image.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  return refuses_or_reads(data, size,
                          [&](std::istream&) { geom::picture::read_png(bytes, "fuzz"); });
}
