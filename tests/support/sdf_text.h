#pragma once

// SDF worlds for tests.

#include <string>

namespace support {

inline std::string sdf(const std::string& inside, const std::string& version = "1.9") {
  return "<?xml version=\"1.0\"?>\n<sdf version=\"" + version + "\">\n<world name=\"w\">\n" +
         inside + "\n</world>\n</sdf>\n";
}

// A static model `name` with one link that holds one collision of this geometry.
inline std::string sdf_model(const std::string& name, const std::string& pose,
                             const std::string& geometry) {
  return "<model name=\"" + name + "\"><static>true</static>" +
         (pose.empty() ? "" : "<pose>" + pose + "</pose>") +
         "<link name=\"l\"><collision name=\"c\"><geometry>" + geometry +
         "</geometry></collision></link></model>";
}

inline std::string sdf_box(const std::string& size) {
  return "<box><size>" + size + "</size></box>";
}

}  // namespace support
