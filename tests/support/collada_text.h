#pragma once

// COLLADA files for tests.

#include <string>

namespace support {

// A wedge of four triangles; `asset`, and what stands in its node before the geometry, as given.
inline std::string collada(const std::string& asset = "<up_axis>Z_UP</up_axis>",
                           const std::string& place = "") {
  return "<?xml version=\"1.0\"?>\n<COLLADA version=\"1.4.1\">\n<asset>" + asset +
         "</asset>\n<library_geometries><geometry id=\"g\"><mesh>\n<source id=\"p\">"
         "<float_array id=\"a\" count=\"12\">0 0 0 4 0 0 0 0 3 0 2 0</float_array>"
         "<technique_common><accessor source=\"#a\" count=\"4\" stride=\"3\">"
         "<param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
         "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source>\n"
         "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>\n"
         "<triangles count=\"4\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
         "<p>0 1 2 0 2 3 0 3 1 1 3 2</p></triangles></mesh></geometry></library_geometries>\n"
         "<library_visual_scenes><visual_scene id=\"s\"><node id=\"n\">\n" +
         place +
         "<instance_geometry url=\"#g\"/></node></visual_scene></library_visual_scenes>\n"
         "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>\n";
}

}  // namespace support
