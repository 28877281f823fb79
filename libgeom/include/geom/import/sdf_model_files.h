#pragma once

// The files that an SDF world names by URI.
//
// Example:
//   geom::SdfModelFiles files({"/usr/share/gazebo/models"});  // where model:// is looked for
//   geom::SdfOptions options;
//   files.serve(options);
//   std::istringstream in("<sdf version=\"1.7\"><world name=\"w\"></world></sdf>");
//   const geom::SdfWorld world = geom::read_sdf_world(in, "city.world", options);

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geom/base/open_file.h"
#include "geom/import/sdf_world.h"

namespace geom {

// Must outlive the reading that it serves.
class SdfModelFiles {
 public:
  // `folders`: where model:// and package:// are looked for, and paths that lead nowhere else.
  explicit SdfModelFiles(std::vector<std::string> folders, OpenFile open = open_file)
      : folders_(std::move(folders)), open_(std::move(open)) {}

  void serve(SdfOptions& options);  // sets its `open` and `open_mesh`

  // The model file of an <include>: of a folder the one that its model.config names for the newest
  // version that is read here, else model.sdf. `from`: the file that the URI stands in.
  // Null where there is none.
  const SdfFile* open(const std::string& uri, const std::string& from);

  // The file of a <mesh>. Null where there is none.
  const SdfFile* open_mesh(const std::string& uri, const std::string& from);

  // "sha256:…" of the files that were opened, in their order.
  const std::vector<std::string>& hashes() const { return hashes_; }

 private:
  std::optional<std::string> path_of(const std::string& uri, const std::string& from) const;

  const SdfFile* load(const std::string& path);

  std::vector<std::string> folders_;
  OpenFile open_;
  std::map<std::string, SdfFile> files_;  // by their paths
  std::vector<std::string> hashes_;
};

}  // namespace geom
