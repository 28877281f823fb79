#pragma once

// The rules of text/xml_head.h for files that libraries read by themselves: they are looked
// through from the first byte to the last.

#include <string>

namespace geom::gis {

// An OpenStreetMap file as XML, packed or not. Throws InputError(name, …).
void require_plain_osm(const std::string& path, const std::string& name);

// A file that GDAL reads: KML, GML, GPX and the like, also gzipped, or in a ZIP archive (KMZ).
void require_plain_vector(const std::string& path, const std::string& name);

}  // namespace geom::gis
