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
  at.refuse(fmt::format("expected {}, found {}", expected, excerpt(found)));
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
  void look(const SdfNode& node) {
    look_at(node);
    for (const XmlElement& child : node.element->children) {
      const bool shown = child.name != "extra" && !child.name.starts_with("library_physics");
      if (shown) look(node.of(child));
    }
  }

 private:
  void look_at(const SdfNode& node) {
    const std::string& name = node.name();
    if (!node.element->prefix.empty()) refuse(node, "elements without a prefix", tag(node));
    if ((name == "up_axis" || name == "unit") && ++said_[name] > 1) {
      refuse(node, "axes and units that hold for the whole file", tag(node) + " again");
    }
    if (name == "animation" || name == "instance_controller") {
      refuse(node, "a mesh that stands still: write one state of it", tag(node));
    }
    if (name == "instance_node" || name == "lookat") {
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

  std::map<std::string, int> said_;
  std::set<std::string> ids_;
  std::set<std::string> placed_;  // geometries
};

}  // namespace

void require_simulators_agree(const SdfNode& collada) {
  if (collada.name() != "COLLADA") refuse(collada, "<COLLADA>", tag(collada));
  require_z_up(collada);
  Agreement().look(collada);
}

}  // namespace geom
