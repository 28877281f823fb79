#pragma once

// The files that an SDF world names by URI.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geom/import/sdf_world.h"

namespace import {

class ModelFiles {
 public:
  explicit ModelFiles(std::vector<std::string> folders) : folders_(std::move(folders)) {}

  // The model file of an <include>: of a folder the one that its model.config names for the newest
  // version that is read here, else model.sdf. `from`: the file that the URI stands in.
  // Null where there is none.
  const geom::SdfFile* open(const std::string& uri, const std::string& from);

  // The file of a <mesh>. Null where there is none.
  const geom::SdfFile* open_mesh(const std::string& uri, const std::string& from);

  // "sha256:…" of the files that were opened, in their order.
  const std::vector<std::string>& hashes() const { return hashes_; }

 private:
  std::optional<std::string> path_of(const std::string& uri, const std::string& from) const;

  const geom::SdfFile* load(const std::string& path);

  std::vector<std::string> folders_;            // --model-path
  std::map<std::string, geom::SdfFile> files_;  // by their paths
  std::vector<std::string> hashes_;
};

}  // namespace import
