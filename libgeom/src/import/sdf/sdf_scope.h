#pragma once

// Worlds and models of SDF as scopes of names, and the poses in them.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sdf_node.h"
#include "sdf_pose.h"

namespace geom {

// SDFormat's "Pose frame semantics": a name is a link, joint, frame or model of the scope, or
// "a::b" of the model a in it.
class SdfScope {
 public:
  SdfScope(SdfNode node, std::string name, const SdfScope* parent);

  SdfNode node;  // <world> or <model>
  std::string name;
  const SdfScope* parent;          // nothing of a world
  std::optional<SdfNode> placing;  // the <pose> of a model in its parent
  std::string placement_frame;     // of its own: what that pose places
  bool is_static = false;
  std::vector<std::unique_ptr<SdfScope>> models;

  // Of a link, a frame or a joint in the scope.
  SdfPose pose_of(const SdfNode& element, int depth = 0) const;
  // Of a collision or visual of a link that has this pose in the scope.
  SdfPose pose_in_link(const SdfNode& element, const SdfPose& link) const;
  // Of the scope itself in its parent.
  SdfPose pose_in_parent(int depth = 0) const;

 private:
  struct Named {
    std::optional<SdfNode> element;  // a link, a joint or a frame
    const SdfScope* model = nullptr;
    bool again = false;  // the name stands for more than one
    bool asked = false;  // its pose is being worked out
    std::optional<SdfPose> pose;
  };
  using Names = std::map<std::string, Named, std::less<>>;

  Names& names() const;
  SdfPose frame(std::string_view name, const SdfNode& asks, int depth) const;
  SdfPose relative(const std::optional<SdfNode>& pose, int depth, const SdfPose& otherwise) const;

  mutable std::optional<Names> names_;  // when first asked for
};

}  // namespace geom
