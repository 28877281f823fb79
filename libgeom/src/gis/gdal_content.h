#pragma once

// The bytes of a file that GDAL opens.

#include <string>

namespace geom::gis {

// All of them, also of a file in an archive ("/vsizip/…"). Throws InputError(name, …) where it
// cannot be read whole.
std::string content_of(const std::string& path, const std::string& name);

}  // namespace geom::gis
