#pragma once

// Triangles that Draco has compressed (KHR_draco_mesh_compression), as a decoder gives them.
//
// Example:
//   const geom::DracoDecoder none = [](std::string_view bytes, const std::string& source) {
//     if (!bytes.empty()) throw geom::InputError(source, {.says = "Draco is not supported here"});
//     return geom::DracoMesh();
//   };
//
// The libraries have no decoder: the caller passes one.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace geom {

struct DracoMesh {
  struct Attribute {
    std::uint64_t component_type = 0;  // as glTF counts them: 5126 is a float
    std::size_t columns = 0;
    std::vector<double> values;  // of each vertex as many as there are columns; not normalised
  };

  std::size_t vertices = 0;
  std::vector<std::uint64_t> corners;             // three vertices for each triangle
  std::map<std::uint64_t, Attribute> attributes;  // by their numbers in the compressed data
};

// Throws InputError(source, …) if the bytes are no such mesh, or cut short.
using DracoDecoder = std::function<DracoMesh(std::string_view bytes, const std::string& source)>;

}  // namespace geom
