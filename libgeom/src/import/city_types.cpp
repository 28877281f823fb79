#include "city_types.h"

#include <algorithm>
#include <limits>
#include <set>

namespace geom {
namespace {

constexpr double kFlatRise = 3;  // metres
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// What lies on the ground as a sheet. Terrain (TINRelief, ReliefFeature) is not among these: it is
// the ground.
const std::set<std::string> kFlat = {"LandUse",
                                     "WaterBody",
                                     "Waterway",
                                     "Road",
                                     "Railway",
                                     "Track",
                                     "Square",
                                     "TransportSquare",
                                     "Section",
                                     "Intersection",
                                     "TrafficSpace",
                                     "AuxiliaryTrafficSpace",
                                     "Marking",
                                     "Hole",
                                     "TrafficArea",
                                     "AuxiliaryTrafficArea",
                                     "TransportationComplex"};
const std::set<std::string> kTerrain = {"TINRelief", "ReliefFeature"};

struct Heights {
  double low = kInfinity;
  double high = -kInfinity;
};

Heights heights_of(const CityObject& object, double unit) {
  Heights out;
  for (const CityGeometry& geometry : object.geometries) {
    for (const CitySurface& surface : geometry.surfaces) {
      for (const auto& ring : surface) {
        for (const Vec3& p : ring) {
          out.low = std::min(out.low, p.z() * unit);
          out.high = std::max(out.high, p.z() * unit);
        }
      }
    }
  }
  return out;
}

// The types of the wholes that have parts, by their names.
std::map<std::string, std::string> whole_types(const CityModel& model) {
  std::map<std::string, std::string> out;
  for (const CityObject& object : model.objects) {
    if (!object.is_part) out[object.whole] = object.type;
  }
  return out;
}

LeftOutTypes leave_out_unnamed(CityModel& model, const std::vector<std::string>& types) {
  LeftOutTypes out;
  const std::map<std::string, std::string> wholes = whole_types(model);
  const auto named = [&](const std::string& type) {
    return std::find(types.begin(), types.end(), type) != types.end();
  };
  for (CityObject& object : model.objects) {
    const auto whole = wholes.find(object.whole);
    if (named(object.type) || (whole != wholes.end() && named(whole->second))) continue;
    object.left_out = true;
    ++out.count[object.type];
  }
  return out;
}

// Whether something would be left without the flat types.
bool has_others(const CityModel& model) {
  return std::any_of(model.objects.begin(), model.objects.end(), [](const CityObject& object) {
    return !kFlat.contains(object.type) && !object.geometries.empty();
  });
}

LeftOutTypes leave_out_flat(CityModel& model, double unit) {
  LeftOutTypes out;
  if (!has_others(model)) return out;
  double ground = kInfinity;
  for (const CityObject& object : model.objects) {
    const bool lies = kFlat.contains(object.type) || kTerrain.contains(object.type);
    if (lies) ground = std::min(ground, heights_of(object, unit).low);
  }
  for (CityObject& object : model.objects) {
    if (!kFlat.contains(object.type)) continue;
    const double rise = heights_of(object, unit).high - ground;
    if (!(rise >= 0 && rise <= kFlatRise)) continue;  // below 0: it has no surface
    object.left_out = true;
    ++out.count[object.type];
    out.rise = std::max(out.rise, rise);
  }
  return out;
}

}  // namespace

LeftOutTypes leave_out(CityModel& model, const std::vector<std::string>& types, double unit) {
  return types.empty() ? leave_out_flat(model, unit) : leave_out_unnamed(model, types);
}

std::map<std::string, std::size_t> types_of(const CityModel& model) {
  std::map<std::string, std::size_t> out;
  for (const CityObject& object : model.objects) ++out[object.type];
  return out;
}

}  // namespace geom
