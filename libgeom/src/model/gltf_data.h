#pragma once

// The numbers of a glTF file: its text, buffers, views and accessors.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "geom/model/draco_mesh.h"
#include "geom/model/model.h"
#include "json_members.h"

namespace geom {

// Reads the JSON at once, buffers when they are asked for. `bytes` must outlive it.
class GltfData {
 public:
  GltfData(std::string_view bytes, std::string source, const ModelFiles& files,
           std::string_view path);

  const JsonMembers& root() const { return *root_; }
  const std::string& source() const { return source_; }

  // What an accessor gives: `count` rows of `columns` numbers, normalised where it says so.
  struct Numbers {
    std::size_t columns = 0;
    std::vector<double> values;

    std::size_t count() const { return values.size() / columns; }
  };
  // `type`: VEC3, SCALAR or whatever is wanted. Refuses sparse ones, views and buffers that are
  // too short, and what is no number.
  Numbers numbers(std::uint64_t accessor, const std::string& type);

  // The same of an accessor whose rows Draco has compressed, and that must say as many.
  Numbers numbers(std::uint64_t accessor, const std::string& type,
                  const DracoMesh::Attribute& unpacked);

  // Whether the file has the numbers of an accessor as they are.
  bool has_rows(std::uint64_t accessor) const;

  // The bytes of a view, which may be compressed.
  std::string_view view(std::uint64_t i);

 private:
  void read_container(std::string_view bytes);
  std::string_view buffer(std::uint64_t i);
  std::string_view view(std::uint64_t i, std::uint64_t& stride);

  std::string source_;
  std::string path_;
  const ModelFiles& files_;
  nlohmann::json json_;
  std::string_view binary_;  // of a .glb
  bool has_binary_ = false;
  std::map<std::uint64_t, std::string> loaded_;
  std::optional<JsonMembers> root_;
};

}  // namespace geom
