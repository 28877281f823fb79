#include "gdal_content.h"

#include "gdal_handles.h"
#include "geom/base/error.h"

namespace geom::gis {

std::string content_of(const std::string& path, const std::string& name) {
  GByte* bytes = nullptr;
  vsi_l_offset size = 0;
  if (!gdal().read_whole(nullptr, path.c_str(), &bytes, &size, -1)) {
    throw InputError(name,
                     {.expected = "a file that can be read whole", .found = "one that cannot"});
  }
  const BytesHandle<GByte> owner(bytes);
  return {reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size)};
}

}  // namespace geom::gis
