#include "import/city_footprints.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "geom/shape/aabb.h"
#include "import/plan_gap.h"
#include "import/written_height.h"

namespace geom {
namespace {

constexpr double kLevelTo = 1e-3;  // metres: what rises by less is drawn flat
// What lies on the ground: without a geometry, nothing of it is known to be in the air.
const std::set<std::string> kLevel = {"TINRelief",
                                      "LandUse",
                                      "WaterBody",
                                      "Waterway",
                                      "Road",
                                      "Railway",
                                      "TransportSquare",
                                      "Track",
                                      "Square",
                                      "Section",
                                      "Intersection",
                                      "TrafficSpace",
                                      "AuxiliaryTrafficSpace",
                                      "ClearanceSpace",
                                      "Hole",
                                      "ReliefFeature",
                                      "TransportationComplex"};
const std::set<std::string> kGround = {"TINRelief", "LandUse", "WaterBody", "Waterway"};
const std::set<std::string> kBuilding = {"Building", "BuildingPart"};

// An object's surfaces that are taken, and what they say.
struct Shape {
  const CityObject* object = nullptr;
  std::uint64_t id = 0;
  double lod = 0;
  bool roof_edges = true;  // all of them
  bool roofs = true;
  bool raised = false;  // drawn flat, and as high as something else says
  CitySurfaces surfaces;
  CitySurfaces plans;  // of level of detail 0, beside surfaces that do not stand on all of them
  double low = std::numeric_limits<double>::infinity();  // metres
  double high = -std::numeric_limits<double>::infinity();
};

// What objects that are parts of one have in common.
struct Whole {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  bool grounded = false;  // something says where its ground is
};

// Where geometries are, and how much of the plan their surfaces take, one over the other.
struct Extent {
  std::optional<Aabb> box;
  double plan = 0;

  void add(const CityGeometry& geometry) {
    for (const CitySurface& surface : geometry.surfaces) add(surface);
  }
  void add(const CitySurface& surface) {
    for (const auto& ring : surface) add({bounds(std::span<const Vec3>(ring)), 0});
    if (!surface.empty()) plan += plan_of(surface.front());
  }
  void add(const Extent& other) {
    if (other.box) box = box ? merged(*box, *other.box) : *other.box;
    plan += other.plan;
  }

  // Whether this reaches a quarter of its size further in plan or up, or takes half as much of the
  // plan again: so the roofs of one level are kept where another has windows or walls alone.
  bool reaches_beyond(const Extent& other) const {
    if (!box || !other.box) return box.has_value();
    const Vec3 quarter = (box->max - box->min) / 4;
    const bool further = (box->max.array() > (other.box->max + quarter).array()).any() ||
                         (box->min.array() < (other.box->min - quarter).array()).head<2>().any();
    return further || plan > 1.5 * other.plan;
  }

 private:
  static double plan_of(const std::vector<Vec3>& ring) {
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec3 a = ring[i] - ring.front();
      const Vec3 b = ring[(i + 1) % ring.size()] - ring.front();
      twice += a.x() * b.y() - a.y() * b.x();
    }
    return std::abs(twice) / 2;
  }
};

class Builder {
 public:
  Builder(const CityModel& model, double unit, const HeightOptions& options)
      : model_(model), unit_(unit), options_(options) {
    out_.skipped = model.skipped;
  }

  CityFootprints build() {
    for (const CityObject& object : model_.objects) note_part(object);
    for (std::size_t i = 0; i < model_.objects.size(); ++i) {
      if (!model_.objects[i].left_out) look_at(model_.objects[i], i);
    }
    for (const CityObject& object : model_.objects) reach_ground(object);
    for (const Shape& shape : shapes_) {
      if (wholes_.at(shape.object->whole).grounded) {
        add(shape);
      } else {
        skip(*shape.object, "building of roofs alone, without a measured height");
      }
    }
    return std::move(out_);
  }

 private:
  void look_at(const CityObject& object, std::uint64_t id) {
    Shape shape = chosen(object);
    shape.id = id;
    if (shape.surfaces.empty()) {
      const bool known = kLevel.contains(object.type) || object.type == "CityObjectGroup";
      if (object.others > 0 || !(object.has_parts || known)) {
        skip(object, fmt::format("{} without surfaces", object.type.substr(0, 40)));
      }
      return;
    }
    // Lines of what lies on the ground are its middle or its network.
    if (object.drawn > 0 && !kLevel.contains(object.type)) {
      skip(object,
           fmt::format("{} of lines or points beside its surfaces", object.type.substr(0, 40)));
    }
    for (const CitySurfaces* surfaces : {&shape.surfaces, &shape.plans}) {
      for (const CitySurface* surface : *surfaces) reach(*surface, shape);
    }
    if (!stand(shape)) return;
    Whole& whole = wholes_[object.whole];
    whole.low = std::min(whole.low, shape.low);
    whole.high = std::max(whole.high, shape.high);
    whole.grounded |= shape.raised || !shape.roofs;
    shapes_.push_back(std::move(shape));
  }

  void reach(const CitySurface& surface, Shape& shape) const {
    for (const auto& ring : surface) {
      for (const Vec3& p : ring) {
        shape.low = std::min(shape.low, p.z() * unit_);
        shape.high = std::max(shape.high, p.z() * unit_);
      }
    }
  }

  // What the parts of a whole have that is not flat.
  void note_part(const CityObject& object) {
    if (!object.is_part || object.left_out) return;
    const Shape shape = chosen(object);
    Extent extent;
    for (const CitySurface* surface : shape.surfaces) extent.add(*surface);
    if (!extent.box || (extent.box->max.z() - extent.box->min.z()) * unit_ <= kLevelTo) return;
    CitySurfaces& parts = parts_[object.whole];
    parts.insert(parts.end(), shape.surfaces.begin(), shape.surfaces.end());
  }

  // Whether the shape, drawn flat, is the plan of parts that stand on all of it: their roofs are
  // its heights.
  bool is_plan_of_parts(const Shape& shape) const {
    const auto parts = parts_.find(shape.object->whole);
    if (shape.lod >= 1 || !shape.object->has_parts || parts == parts_.end()) return false;
    return !has_gap(shape.surfaces, parts->second);
  }

  static Shape chosen(const CityObject& object) {
    Shape shape;
    shape.object = &object;
    std::map<double, std::vector<const CityGeometry*>, std::greater<>> levels;  // finest first
    for (const CityGeometry& g : object.geometries) {
      if (!g.surfaces.empty()) levels[g.lod].push_back(&g);
    }
    if (levels.empty()) return shape;
    shape.lod = levels.begin()->first;
    Extent extent;
    for (const auto& [lod, geometries] : levels) {
      Extent own;
      CitySurfaces surfaces;
      for (const CityGeometry* g : geometries) {
        own.add(*g);
        for (const CitySurface& surface : g->surfaces) surfaces.push_back(&surface);
      }
      if (!own.reaches_beyond(extent) && !has_gap(surfaces, shape.surfaces)) continue;
      extent.add(own);
      for (const CityGeometry* g : geometries) take(*g, shape);
    }
    return shape;
  }

  static void take(const CityGeometry& g, Shape& shape) {
    shape.roof_edges &= g.roof_edge;
    shape.roofs &= g.roofs_only;
    const bool plan = g.lod < 1 && shape.lod >= 1 && !kLevel.contains(shape.object->type);
    for (const CitySurface& surface : g.surfaces) {
      (plan ? shape.plans : shape.surfaces).push_back(&surface);
    }
  }

  void skip(const CityObject& object, const std::string& kind) {
    out_.skipped.add(kind, object.name.substr(0, 60));
  }

  std::string attribute(const CityObject& object, const char* key) const {
    const auto at = object.attributes.find(key);
    return at == object.attributes.end() ? "" : at->second;
  }

  BuildingHeight height_of(const CityObject& object) const {
    return building_height(
        [&](const char* key) -> std::string {
          const std::string asked = key;
          std::string value = attribute(object, key);
          if (asked == "height") {
            add_value(attribute(object, "measuredHeight"), value);
            if (value.empty()) value = attribute(object, "averageHeight");
          }
          if (asked == "building:levels" && value.empty()) {
            value = attribute(object, "storeysAboveGround");
          }
          return asked == "min_height" || asked == "building:min_level" ? "" : value;
        },
        options_);
  }

  // Gives the shape the heights that its surfaces do not have. False where it cannot be built.
  bool stand(Shape& shape) {
    const CityObject& object = *shape.object;
    if (kGround.contains(object.type) || kLevel.contains(object.type)) return true;
    const bool building = kBuilding.contains(object.type);
    if (shape.high - shape.low > kLevelTo || is_plan_of_parts(shape)) return true;
    const BuildingHeight height = height_of(object);
    if (building) out_.heights.emplace_back(object.name.substr(0, 60), height);
    if (height.from == HeightFrom::nothing && !building) {
      if (height.junk) {
        skip(object, "height that is not understood");
      } else if (shape.lod < 1) {
        skip(object, fmt::format("{} drawn flat, without a height", object.type.substr(0, 40)));
      }
      return !height.junk && shape.lod >= 1;
    }
    if (shape.roof_edges) shape.low -= height.top;
    shape.high += height.top;
    shape.raised = true;
    return true;
  }

  // What is as high as somebody has measured may begin below its surfaces.
  void reach_ground(const CityObject& object) {
    const auto at = wholes_.find(object.whole);
    const auto height = parse_highest(attribute(object, "measuredHeight"), options_.unit);
    if (at == wholes_.end() || !height || !(*height > 0)) return;
    if (!object.is_part) at->second.low = std::min(at->second.low, at->second.high - *height);
    at->second.grounded = true;
  }

  void add(const Shape& shape) {
    ++out_.objects;
    ++out_.by_kind[fmt::format("{} LoD {}", shape.object->type.substr(0, 40), shape.lod)];
    const double bottom = wholes_.at(shape.object->whole).low;
    for (const CitySurface* surface : shape.surfaces) {
      Footprint f = footprint_of(*surface);
      if (shape.raised) raise(shape.high, f);
      add(std::move(f), shape, bottom);
    }
    // As high as the rest of the object, or as its attributes say: nothing else tells.
    for (const CitySurface* surface : shape.plans) {
      Footprint f = footprint_of(*surface);
      const BuildingHeight height = height_of(*shape.object);
      const double own = height.from == HeightFrom::nothing ? 0 : height.top;
      raise(std::max(shape.high, f.top + own), f);
      add(std::move(f), shape, bottom);
    }
  }

  static void raise(double top, Footprint& f) {
    f.heights.clear();
    f.top = top;
  }

  void add(Footprint f, const Shape& shape, double bottom) {
    f.id = shape.id;
    f.ground = kGround.contains(shape.object->type);
    f.bottom = bottom;
    f.likely_covered = f.top <= bottom;
    out_.footprints.push_back(std::move(f));
  }

  Footprint footprint_of(const CitySurface& surface) const {
    Footprint f;
    f.top = -std::numeric_limits<double>::infinity();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t r = 0; r < surface.size(); ++r) {
      std::vector<Vec2>& ring = r == 0 ? f.polygon.outer : f.polygon.holes.emplace_back();
      ring.reserve(surface[r].size());
      f.heights.reserve(f.heights.size() + surface[r].size());
      for (const Vec3& v : surface[r]) {
        ring.push_back({v.x(), v.y()});
        f.heights.push_back(v.z() * unit_);
        f.top = std::max(f.top, f.heights.back());
        least = std::min(least, f.heights.back());
      }
    }
    if (least == f.top) f.heights.clear();
    return f;
  }

  const CityModel& model_;
  double unit_;
  const HeightOptions& options_;
  std::vector<Shape> shapes_;
  std::map<std::string, Whole> wholes_;
  std::map<std::string, CitySurfaces> parts_;  // of wholes: what stands up of their parts
  CityFootprints out_;
};

}  // namespace

CityFootprints footprints_of(const CityModel& model, double unit, const HeightOptions& options) {
  return Builder(model, unit, options).build();
}

}  // namespace geom
