#include <cstdint>
#include <cstdlib>
#include <string>

#include "fuzz/readers.h"
#include "geom/import/building_height.h"

// The text as every attribute in turn, and as all at once: what comes out is always a height.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (const char* only : {"", "height", "building:levels", "min_height", "building:min_level"}) {
    const auto tag = [&](const char* key) {
      return *only == 0 || std::string(key) == only ? text : std::string();
    };
    const geom::BuildingHeight h = geom::building_height(tag, {});
    if (!(h.bottom >= 0 && h.bottom < h.top && h.top <= 2e4)) std::abort();
  }
  return 0;
}
