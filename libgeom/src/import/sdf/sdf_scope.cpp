#include "sdf_scope.h"

#include <fmt/format.h>

#include "geom/base/error.h"

namespace geom {
namespace {

constexpr int kDeepest = 200;  // frames that hang on each other

}  // namespace

SdfScope::SdfScope(SdfNode scope, std::string its_name, const SdfScope* its_parent)
    : node(scope), name(std::move(its_name)), parent(its_parent) {}

SdfScope::Names& SdfScope::names() const {
  if (names_) return *names_;
  names_.emplace();
  const auto add = [&](const std::string& key, const Named& named) {
    const auto [at, fresh] = names_->emplace(key, named);
    if (!fresh) at->second.again = true;
  };
  for (const char* kind : {"link", "joint", "frame"}) {
    for (const SdfNode& found : node.all(kind)) add(found.attribute("name"), {.element = found});
  }
  for (const auto& model : models) add(model->name, {.model = model.get()});
  return *names_;
}

SdfPose SdfScope::frame(std::string_view wanted, const SdfNode& asks, int depth) const {
  if (wanted == (parent ? "__model__" : "world")) return {};
  if (depth > kDeepest) {
    asks.refuse({.expected = fmt::format("at most {} frames that hang on each other", kDeepest),
                 .found = "more"});
  }
  const std::size_t colons = wanted.find("::");
  const auto at = names().find(wanted.substr(0, colons));
  if (at == names().end() || at->second.again) {
    asks.refuse(
        {.expected = fmt::format("the name of one frame of {} \"{}\"", parent ? "model" : "world",
                                 name.substr(0, 60)),
         .found = fmt::format("\"{}\"{}", wanted.substr(0, 60),
                              at == names().end() ? "" : ", which there is more than once")});
  }
  Named& found = at->second;
  if (!found.pose) {
    if (found.asked) {
      asks.refuse({.expected = "frames that lead to their model",
                   .found = fmt::format("\"{}\" that leads back to itself", wanted.substr(0, 60))});
    }
    found.asked = true;
    found.pose =
        found.model ? found.model->pose_in_parent(depth + 1) : pose_of(*found.element, depth + 1);
    found.asked = false;
  }
  if (colons == wanted.npos) return *found.pose;
  if (!found.model) {
    asks.refuse({.expected = "a model before ::", .found = in_quotes(wanted.substr(0, 60))});
  }
  return *found.pose * found.model->frame(wanted.substr(colons + 2), asks, depth + 1);
}

// Before SDFormat 1.7 the attribute was called frame.
SdfPose SdfScope::relative(const std::optional<SdfNode>& pose, int depth,
                           const SdfPose& otherwise) const {
  if (!pose) return otherwise;
  const SdfPose own = parse_sdf_pose(*pose);
  std::string to = pose->attribute("relative_to");
  if (to.empty()) to = pose->attribute("frame");
  return (to.empty() ? otherwise : frame(to, *pose, depth)) * own;
}

SdfPose SdfScope::pose_of(const SdfNode& element, int depth) const {
  const std::optional<SdfNode> pose = element.find("pose");
  const bool alone =
      pose && pose->attribute("relative_to").empty() && pose->attribute("frame").empty();
  if (pose && !alone) return relative(pose, depth, {});
  std::string on;
  if (element.name() == "frame") on = element.attribute("attached_to");
  if (element.name() == "joint") on = element.child("child").text();
  return relative(pose, depth, on.empty() ? SdfPose{} : frame(on, element, depth));
}

SdfPose SdfScope::pose_in_link(const SdfNode& element, const SdfPose& link) const {
  return relative(element.find("pose"), 0, link);
}

SdfPose SdfScope::pose_in_parent(int depth) const {
  if (!parent) return {};
  const SdfPose placed = parent->relative(placing, depth, {});
  if (placement_frame.empty()) return placed;
  return placed * inverse(frame(placement_frame, node, depth));
}

}  // namespace geom
