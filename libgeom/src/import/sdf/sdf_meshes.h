#pragma once

// The <mesh> of SDF as boxes.

#include <map>
#include <string>
#include <vector>

#include "geom/import/sdf_world.h"
#include "geom/model/model.h"
#include "sdf_pose.h"

namespace geom {

class SdfMeshes {
 public:
  SdfMeshes(const SdfOptions& options, Skipped& skipped) : options_(options), skipped_(skipped) {}

  // Of the element in the world: boxes that hold its triangles and what closed surfaces of them
  // enclose, within the slack. What is not read is skipped, and so is what the file itself has
  // besides triangles.
  std::vector<Aabb> boxes_of(const SdfNode& mesh, const SdfPose& pose);

 private:
  struct MeshFile {
    std::string name;
    Model model;
    std::string unlike;  // how simulators may show it in different ways; empty: they agree
  };
  bool skips(const SdfNode& mesh);
  const MeshFile* find(const SdfNode& uri);
  MeshFile read(const SdfFile& file, const std::string& ending) const;
  std::vector<Aabb> covered(const MeshFile& file, const Vec3& scale, const SdfPose& pose,
                            const SdfNode& mesh) const;

  const SdfOptions& options_;
  Skipped& skipped_;
  std::map<std::string, MeshFile> files_;  // by their names
};

}  // namespace geom
