#include "geom/import/sdf_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <istream>
#include <iterator>
#include <set>

#include "geom/base/error.h"
#include "geom/import/box_format.h"
#include "geom/text/beginning.h"
#include "sdf_loader.h"
#include "sdf_place_on_earth.h"
#include "sdf_shapes.h"

namespace geom {
namespace {

constexpr std::size_t kMostBoxes = 20000000;

using Kinds = std::set<std::string_view>;

// What is no obstacle, or is read elsewhere.
const Kinds kOfWorld = {"atmosphere",
                        "audio",
                        "frame",
                        "gravity",
                        "gui",
                        "include",
                        "joint",
                        "light",
                        "magnetic_field",
                        "model",
                        "physics",
                        "plugin",
                        "scene",
                        "spherical_coordinates",
                        "state",
                        "wind",
                        "world"};
const Kinds kOfModel = {"allow_auto_disable",
                        "enable_wind",
                        "frame",
                        "gripper",
                        "include",
                        "joint",
                        "link",
                        "model",
                        "plugin",
                        "pose",
                        "self_collide",
                        "static"};
const Kinds kOfLink = {
    "audio_sink", "audio_source",      "battery",          "collision",      "enable_wind",
    "frame",      "gravity",           "inertial",         "joint",          "kinematic",
    "light",      "must_be_base_link", "particle_emitter", "plugin",         "pose",
    "projector",  "self_collide",      "sensor",           "velocity_decay", "visual"};
const Kinds kOfPart = {"auto_inertia_params",
                       "cast_shadows",
                       "density",
                       "frame",
                       "geometry",
                       "laser_retro",
                       "layer",
                       "lighting",
                       "material",
                       "max_contacts",
                       "meta",
                       "plugin",
                       "pose",
                       "surface",
                       "transparency",
                       "visibility_flags"};
const Kinds kMoving = {"actor", "population", "road"};

struct BoxOrder {
  bool operator()(const Aabb& a, const Aabb& b) const {
    for (int i = 0; i < 3; ++i) {
      if (a.min[i] != b.min[i]) return a.min[i] < b.min[i];
      if (a.max[i] != b.max[i]) return a.max[i] < b.max[i];
    }
    return false;
  }
};

class WorldReader {
 public:
  WorldReader(const SdfOptions& options, SdfWorld& out)
      : options_(options),
        out_(out),
        meshes_(options, out.skipped),
        shapes_(options.slack, meshes_, out.skipped) {}

  void read(const SdfScope& world) {
    require_known(world.node, kOfWorld);
    for (const auto& model : world.models) {
      if (options_.without.contains(model->name)) {
        out_.left_out.insert(model->name);
        continue;
      }
      if (!model->is_static) ++out_.movable;
      read_model(*model, {}, "");
    }
    for (const SdfNode& state : world.node.all("state")) require_unmoved(state, world);
    add_plane_pictures();
    add_ground_alone();
  }

 private:
  void require_known(const SdfNode& node, const Kinds& known) {
    for (const XmlElement& child : node.element->children) {
      if (!child.prefix.empty() || known.contains(child.name)) continue;
      out_.skipped.add(kMoving.contains(child.name) ? child.name : "unknown element",
                       sdf_place(node.of(child), child.name));
    }
  }

  void read_model(const SdfScope& model, const SdfPose& outer, const std::string& outer_label) {
    require_known(model.node, kOfModel);
    const SdfPose pose = outer * model.pose_in_parent();
    const std::string label = label_of(model, outer_label);
    for (const SdfNode& link : model.node.all("link")) read_link(model, link, pose, label);
    for (const auto& nested : model.models) read_model(*nested, pose, label + "::");
  }

  static std::string label_of(const SdfScope& model, const std::string& outer_label) {
    for (const XmlElement& child : model.node.element->children) {
      if (child.prefix == "skyway" && child.name == "label") return child.text;
    }
    return outer_label + model.name;
  }

  void read_link(const SdfScope& model, const SdfNode& link, const SdfPose& outer,
                 const std::string& label) {
    require_known(link, kOfLink);
    const SdfPose pose = model.pose_of(link);
    std::set<Aabb, BoxOrder> there;
    const auto take = [&](const SdfNode& part, bool seen) {
      require_known(part, kOfPart);
      const SdfPose place = outer * model.pose_in_link(part, pose);
      const SdfBoxes made = shapes_.boxes_of(part.child("geometry"), place);
      take_boxes(part, made, seen, label, there);
    };
    for (const SdfNode& part : link.all("collision")) take(part, false);
    if (options_.visuals) {
      for (const SdfNode& part : link.all("visual")) take(part, true);
    }
    ++links_;
  }

  void take_boxes(const SdfNode& part, const SdfBoxes& made, bool seen, const std::string& label,
                  std::set<Aabb, BoxOrder>& there) {
    const bool plane = part.child("geometry").find("plane").has_value();
    if (plane && !seen) {
      if (made.plane) {
        for (const Aabb& box : made.boxes) grounds_.push_back({box, links_, label});
        out_.floor = std::max(*made.plane, out_.floor.value_or(*made.plane));
      } else {
        out_.skipped.add("plane that is no floor", sdf_place(part, "a collision must be level"));
      }
      return;
    }
    for (const Aabb& box : made.boxes) {
      if (!there.insert(box).second) continue;
      if (plane && made.plane) {
        pictures_.push_back({box, links_, label});
      } else {
        add(part, box, links_, label);
      }
    }
  }

  void add(const SdfNode& part, const Aabb& box, std::size_t id, const std::string& label) {
    if (box.min.cwiseAbs().maxCoeff() > kLargestCoordinate ||
        box.max.cwiseAbs().maxCoeff() > kLargestCoordinate) {
      part.refuse({.expected = "a body within 1e8 m", .found = "one beyond"});
    }
    if (out_.table.boxes.size() >= kMostBoxes) {
      part.refuse({.expected = fmt::format("at most {} boxes", kMostBoxes), .found = "more"});
    }
    out_.flat += (box.min.array() == box.max.array()).any();
    out_.table.add(box, id, out_.table.label_of(label));
  }

  struct Picture {
    Aabb box;
    std::size_t link;
    std::string label;
  };

  // Level planes that are seen and do not lie on the floor.
  void add_plane_pictures() {
    for (const Picture& p : pictures_) {
      if (out_.floor && p.box.max.z() <= *out_.floor) continue;
      add_picture(p);
    }
  }

  void add_picture(const Picture& p) {
    ++out_.flat;
    out_.table.add(p.box, p.link, out_.table.label_of(p.label));
  }

  // A world of ground alone is a map of that ground: a flat box as large as its plane.
  void add_ground_alone() {
    if (!out_.table.boxes.empty() || !out_.skipped.empty()) return;
    for (const Picture& p : grounds_.empty() ? pictures_ : grounds_) add_picture(p);
  }

  // Older simulators put models where a <state> says.
  void require_unmoved(const SdfNode& state, const SdfScope& world) {
    for (const XmlElement& child : state.element->children) {
      const SdfNode node = state.of(child);
      if (child.name == "insertions" || child.name == "deletions" ||
          (child.name == "model" && !is_where(node, world, {}))) {
        out_.skipped.add("model that a state moves", sdf_place(node, node.attribute("name")));
      }
    }
  }

  // Whether the model, its links and the models within stand where the state has them, at the same
  // size.
  static bool is_where(const SdfNode& state, const SdfScope& scope, const SdfPose& outer) {
    constexpr double kSame = 1e-6;
    const auto pose = state.find("pose");
    if (const auto scale = state.find("scale")) {
      const std::vector<double> v = scale->numbers(3);
      if (std::any_of(v.begin(), v.end(), [](double s) { return s != 1; })) return false;
    }
    for (const auto& model : scope.models) {
      if (model->name != state.attribute("name") || !pose) continue;
      const SdfPose own = model->pose_in_parent();
      const SdfPose is = outer * own;
      const SdfPose was = parse_sdf_pose(*pose);
      if (!is_same(is, was, kSame) && !is_same(own, was, kSame)) return false;
      const auto models = state.all("model");
      return links_are_where(state, *model, is) &&
             std::all_of(models.begin(), models.end(),
                         [&](const SdfNode& inner) { return is_where(inner, *model, is); });
    }
    return false;
  }

  // Simulators write the place in the world, in six digits; people that in the model.
  static bool links_are_where(const SdfNode& state, const SdfScope& model, const SdfPose& outer) {
    for (const SdfNode& moved : state.all("link")) {
      const auto pose = moved.find("pose");
      if (!pose) continue;
      const SdfPose was = parse_sdf_pose(*pose);
      const double same = 1e-5 * std::max(1.0, was.place().norm());
      bool found = false;
      for (const SdfNode& link : model.node.all("link")) {
        if (link.attribute("name") != moved.attribute("name")) continue;
        const SdfPose own = model.pose_of(link);
        found |= is_same(own, was, same) || is_same(outer * own, was, same);
      }
      if (!found) return false;
    }
    return true;
  }

  static bool is_same(const SdfPose& a, const SdfPose& b, double same) {
    return (a.place() - b.place()).norm() < same && (a.turn - b.turn).norm() < std::min(same, 1e-5);
  }

  const SdfOptions& options_;
  SdfWorld& out_;
  SdfMeshes meshes_;
  SdfShapes shapes_;
  std::vector<Picture> pictures_;
  std::vector<Picture> grounds_;  // level planes that collide, as large as the file says
  std::size_t links_ = 0;
};

}  // namespace

SdfWorld read_sdf_world(std::istream& in, std::string_view source, const SdfOptions& options) {
  const std::string text(std::istreambuf_iterator<char>(in), {});
  SdfWorld out;
  SdfLoader loader(options, out.skipped);
  const std::unique_ptr<SdfScope> world = loader.load(text, std::string(source));
  out.frame = frame_of(world->node);
  out.bounds = bounds_of(world->node);
  WorldReader(options, out).read(*world);
  return out;
}

namespace {

ImportedBoxes import_sdf_world(std::istream& in, std::string_view source,
                               const ImportOptions& options) {
  SdfWorld world = read_sdf_world(in, source, options.sdf);
  ImportedBoxes out;
  out.table = std::move(world.table);
  out.frame = world.frame;
  out.bounds = world.bounds;
  out.floor = world.floor;
  out.flat = world.flat;
  out.skipped = std::move(world.skipped);
  out.movable = world.movable;
  out.left_out = std::move(world.left_out);
  return out;
}

// The root, whatever stands before it between angle brackets.
bool is_sdf(std::string_view head) {
  const std::string_view text = text_of(head);
  const std::size_t root = text.find("<sdf");
  return text.starts_with('<') && root != text.npos && root + 4 < text.size() &&
         std::string_view(" \t\r\n>").find(text[root + 4]) != std::string_view::npos;
}

constexpr std::string_view kReaders[] = {"skyway-import"};
constexpr Format kFormat{
    .word = "sdf", .what = "a Gazebo world (SDF)", .begins = is_sdf, .readers = kReaders};

}  // namespace

constinit const BoxFormat kGazeboWorld{
    .format = &kFormat, .may_be = is_sdf, .read = import_sdf_world};

}  // namespace geom
