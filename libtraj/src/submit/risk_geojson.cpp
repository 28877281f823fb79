#include "traj/submit/risk_geojson.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/text/instant.h"
#include "geom/text/json_line.h"
#include "geom/text/parse_json.h"

namespace traj {
namespace {

using geom::JsonLine;
using geom::Volume4d;

constexpr const char* kGeography = "flight geography";
constexpr const char* kContingency = "contingency volume";
constexpr const char* kBuffer = "ground risk buffer";

std::string feature(const std::string& id, const char* kind, const Volume4d& volume,
                    const RiskVolume* buffer) {
  JsonLine properties;
  properties.add("flight", id).add("volume", kind);
  if (buffer) properties.add("height_m", buffer->height).add("buffer_m", buffer->across);
  properties.add("lower_m", volume.lower)
      .add("upper_m", volume.upper)
      .add("from", volume.start)
      .add("until", volume.end);
  std::vector<std::array<double, 2>> ring;
  for (const geom::GeodeticPlace& p : volume.outline.ring)
    ring.push_back({p.longitude, p.latitude});
  if (!ring.empty()) ring.push_back(ring.front());
  JsonLine geometry;
  geometry.add("type", "Polygon").add("coordinates", std::vector<decltype(ring)>(1, ring));
  return JsonLine()
      .add("type", "Feature")
      .add("properties", properties)
      .add("geometry", geometry)
      .object();
}

// One feature, read back.
class Feature {
 public:
  Feature(const nlohmann::json& json, std::string_view source, std::size_t index)
      : json_(json), source_(source), index_(index) {
    require_keys(json, {"type", "properties", "geometry"});
    const auto& geometry = json["geometry"];
    require_keys(geometry, {"type", "coordinates"});
    if (geometry["type"] != "Polygon") refuse("a Polygon");
  }

  std::string text(const char* key) const {
    const auto& value = property(key);
    if (!value.is_string()) refuse(fmt::format("a text \"{}\"", key));
    return value.get<std::string>();
  }

  double number(const char* key) const {
    const auto& value = property(key);
    if (!value.is_number()) refuse(fmt::format("a number \"{}\"", key));
    return value.get<double>();
  }

  void require_properties(std::size_t count) const {
    if (json_["properties"].size() != count) refuse(fmt::format("{} properties", count));
  }

  Volume4d volume() const {
    Volume4d out;
    out.lower = number("lower_m");
    out.upper = number("upper_m");
    out.start = instant("from");
    out.end = instant("until");
    out.outline.ring = ring();
    return out;
  }

  [[noreturn]] void refuse(const std::string& expected) const {
    throw geom::InputError(source_, {.item = fmt::format("feature {}", index_),
                                     .expected = expected,
                                     .found = "another value"});
  }

 private:
  void require_keys(const nlohmann::json& object, std::initializer_list<const char*> keys) const {
    if (!object.is_object() || object.size() != keys.size()) refuse("a feature of this format");
    for (const char* key : keys) {
      if (!object.contains(key)) refuse(fmt::format("the member \"{}\"", key));
    }
  }

  const nlohmann::json& property(const char* key) const {
    const auto& properties = json_["properties"];
    if (!properties.is_object() || !properties.contains(key)) {
      refuse(fmt::format("the property \"{}\"", key));
    }
    return properties[key];
  }

  std::string instant(const char* key) const {
    const std::string value = text(key);
    if (geom::epoch_from(value) != value) refuse(fmt::format("an instant \"{}\"", key));
    return value;
  }

  std::vector<geom::GeodeticPlace> ring() const {
    const auto& rings = json_["geometry"]["coordinates"];
    if (!rings.is_array() || rings.size() != 1 || !rings[0].is_array() || rings[0].size() < 4 ||
        rings[0].front() != rings[0].back()) {
      refuse("one closed ring");
    }
    std::vector<geom::GeodeticPlace> out;
    for (std::size_t i = 0; i + 1 < rings[0].size(); ++i) {
      const auto& at = rings[0][i];
      if (!at.is_array() || at.size() != 2 || !at[0].is_number() || !at[1].is_number()) {
        refuse("places of two numbers");
      }
      out.push_back({at[1].get<double>(), at[0].get<double>(), 0});
    }
    return out;
  }

  const nlohmann::json& json_;
  std::string_view source_;
  std::size_t index_;
};

void add(const Feature& feature, ReadRisk& out) {
  const std::string kind = feature.text("volume");
  if (kind == kGeography) {
    out.geography.push_back(feature.volume());
  } else if (kind == kContingency) {
    out.volumes.contingency.push_back(feature.volume());
  } else if (kind == kBuffer) {
    out.volumes.buffers.push_back(
        {feature.volume(), feature.number("height_m"), feature.number("buffer_m")});
  } else {
    feature.refuse("a flight geography, a contingency volume or a ground risk buffer");
  }
  feature.require_properties(kind == kBuffer ? 8 : 6);
}

}  // namespace

std::string risk_geojson(const std::string& id, const geom::IntentVolumes& intent,
                         const RiskVolumes& risk) {
  std::string out = "{\"type\":\"FeatureCollection\",\"features\":[\n";
  const char* between = "";
  const auto append = [&](const std::string& line) {
    out += between + line;
    between = ",\n";
  };
  for (const Volume4d& one : intent.nominal) append(feature(id, kGeography, one, nullptr));
  for (const Volume4d& one : risk.contingency) append(feature(id, kContingency, one, nullptr));
  for (const RiskVolume& one : risk.buffers) append(feature(id, kBuffer, one.volume, &one));
  return out + "\n]}\n";
}

ReadRisk read_risk_geojson(std::string_view text, std::string_view source) {
  const nlohmann::json json = geom::parse_json(text, source);
  if (!json.is_object() || json.size() != 2 || json.value("type", "") != "FeatureCollection" ||
      !json.contains("features") || !json["features"].is_array() || json["features"].empty()) {
    throw geom::InputError(source, {.expected = "a FeatureCollection of risk volumes"});
  }
  ReadRisk out;
  for (std::size_t i = 0; i < json["features"].size(); ++i) {
    const Feature feature(json["features"][i], source, i);
    if (i == 0) out.id = feature.text("flight");
    if (feature.text("flight") != out.id) feature.refuse("one flight");
    add(feature, out);
  }
  return out;
}

}  // namespace traj
