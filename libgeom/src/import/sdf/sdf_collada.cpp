#include "sdf_collada.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "geom/text/excerpt.h"

namespace geom {
namespace {

constexpr double kOfLengthOne = 1e-3;  // how far an axis may be from it
// Elements that others name by their ids.
const std::set<std::string_view> kOfTriangles = {"geometry",    "mesh",     "source",
                                                 "float_array", "vertices", "visual_scene"};

[[noreturn]] void refuse(const SdfNode& at, std::string_view expected, std::string_view found) {
  at.refuse({.expected = std::string(expected), .found = excerpt(found)});
}

std::string tag(const SdfNode& node) { return "<" + node.name() + ">"; }

void require_z_up(const SdfNode& root) {
  const std::optional<SdfNode> asset = root.find("asset");
  const std::optional<SdfNode> up = asset ? asset->find("up_axis") : std::nullopt;
  if (up && up->text() == "Z_UP") return;
  refuse(up.value_or(root), "<up_axis>Z_UP</up_axis>: write the mesh with z up",
         up ? up->text() : "none");
}

// One matrix; or a translation, turns and a scale in this order.
void require_agreed_place(const SdfNode& node) {
  constexpr std::array<std::string_view, 4> kOrder = {"matrix", "translate", "rotate", "scale"};
  std::size_t last = kOrder.size();  // none yet
  for (const XmlElement& child : node.element->children) {
    const SdfNode step = node.of(child);
    const auto i = static_cast<std::size_t>(std::find(kOrder.begin(), kOrder.end(), step.name()) -
                                            kOrder.begin());
    if (i == kOrder.size()) continue;
    const bool first = last == kOrder.size();
    const bool follows = last > 0 && (i > last || (i == last && step.name() == "rotate"));
    if (!first && !follows) {
      refuse(step, "one <matrix>, or <translate>, <rotate> and <scale> in this order",
             tag(step) + " after <" + std::string(kOrder[last]) + ">");
    }
    last = i;
    if (step.name() != "rotate") continue;
    const std::vector<double> v = step.numbers(4);
    if (v[3] != 0 && !(std::abs(std::hypot(v[0], v[1], v[2]) - 1) <= kOfLengthOne)) {
      refuse(step, "a turn about an axis of length 1", step.text());
    }
  }
}

// x, y and z of each position, one after the other from the first number of one list on.
void require_plain(const SdfNode& source) {
  const SdfNode numbers = source.child("float_array");
  const SdfNode accessor = source.child("technique_common").child("accessor");
  const std::string offset = accessor.attribute("offset");
  std::string names;
  for (const SdfNode& param : accessor.all("param")) names += param.attribute("name");
  const bool whole = accessor.attribute("source") == "#" + numbers.attribute("id");
  if (whole && (offset.empty() || offset == "0") && accessor.attribute("stride") == "3" &&
      names == "XYZ") {
    return;
  }
  refuse(accessor, "positions of X, Y and Z in threes, of the whole list",
         fmt::format("stride \"{}\", offset \"{}\", \"{}\"", accessor.attribute("stride"), offset,
                     names));
}

void require_plain_positions(const SdfNode& mesh) {
  for (const SdfNode& vertices : mesh.all("vertices")) {
    for (const SdfNode& input : vertices.all("input")) {
      if (input.attribute("semantic") != "POSITION") continue;
      const std::string url = input.attribute("source");
      bool found = false;
      for (const SdfNode& source : mesh.all("source")) {
        if ("#" + source.attribute("id") != url) continue;
        require_plain(source);
        found = true;
      }
      if (!found) refuse(input, "a <source> of the same mesh", url);
    }
  }
}

class Agreement {
 public:
  void look(const SdfNode& node, bool in_library = false) {
    look_at(node, in_library);
    in_library |= node.name() == "library_nodes";
    for (const XmlElement& child : node.element->children) {
      const bool shown = child.name != "extra" && !child.name.starts_with("library_physics");
      if (shown) look(node.of(child), in_library);
    }
  }

  // After the look at all: nodes of the library that others place must be there, once.
  void require_placed_nodes() const {
    for (const auto& [url, at] : placed_nodes_) {
      const bool there = url.starts_with('#') && library_nodes_.count(url.substr(1)) == 1 &&
                         scene_nodes_.count(url.substr(1)) == 0;
      if (!there) refuse(at, "a node of <library_nodes>, of an id that no other has", url);
    }
  }

 private:
  void look_at(const SdfNode& node, bool in_library) {
    const std::string& name = node.name();
    if (!node.element->prefix.empty()) refuse(node, "elements without a prefix", tag(node));
    if ((name == "up_axis" || name == "unit") && ++said_[name] > 1) {
      refuse(node, "axes and units that hold for the whole file", tag(node) + " again");
    }
    if (name == "animation" || name == "instance_controller") {
      refuse(node, "a mesh that stands still: write one state of it", tag(node));
    }
    if (name == "node") take_node(node, in_library);
    if (name == "lookat") {
      refuse(node, "nodes that stand where they are placed: write the mesh with one <matrix> each",
             tag(node));
    }
    if (name == "instance_geometry" && !placed_.insert(node.attribute("url")).second) {
      refuse(node, "each geometry in one place: write a copy for each", node.attribute("url"));
    }
    const std::string id = node.attribute("id");
    if (kOfTriangles.contains(name) && !id.empty() && !ids_.insert(id).second) {
      refuse(node, "each id once", id);
    }
    if (name == "node") require_agreed_place(node);
    if (name == "mesh") require_plain_positions(node);
  }

  // One that places another shows nothing else: simulators stop at the first.
  void take_node(const SdfNode& node, bool in_library) {
    const std::string id = node.attribute("id");
    if (!id.empty()) (in_library ? library_nodes_ : scene_nodes_).insert(id);
    const std::vector<SdfNode> others = node.all("instance_node");
    if (others.empty()) return;
    if (others.size() > 1 || !node.all("instance_geometry").empty()) {
      refuse(others.back(), "one <instance_node> alone in a <node>: write a <node> for each",
             "another shape beside it");
    }
    const std::string url = others[0].attribute("url");
    if (!placed_nodes_.emplace(url, others[0]).second) {
      refuse(others[0], "each node of <library_nodes> in one place: write a copy for each", url);
    }
  }

  std::map<std::string, int> said_;
  std::set<std::string> ids_;
  std::set<std::string> placed_;              // geometries
  std::multiset<std::string> library_nodes_;  // by ids
  std::multiset<std::string> scene_nodes_;
  std::map<std::string, SdfNode> placed_nodes_;  // by their urls: where
};

}  // namespace

void require_simulators_agree(const SdfNode& collada) {
  if (collada.name() != "COLLADA") refuse(collada, "<COLLADA>", tag(collada));
  require_z_up(collada);
  Agreement agreement;
  agreement.look(collada);
  agreement.require_placed_nodes();
}

}  // namespace geom
