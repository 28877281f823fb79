#include "traj/submit/operation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/text/parse_json.h"

namespace traj {
namespace {

constexpr std::array<std::string_view, 8> kClasses = {"C0", "C1", "C2", "C3",
                                                      "C4", "C5", "C6", "none"};
constexpr double kLargestDimension = 100;  // m
constexpr double kLargestMass = 1e5;       // kg
constexpr double kLongestEndurance = 1e6;  // s
constexpr double kAbove = 1 + 1e-9;        // more than rounding

// One object of the file; `within` is "operator." or empty.
class Members {
 public:
  Members(const nlohmann::json& object, std::string within, std::string_view source,
          std::initializer_list<std::string_view> known)
      : object_(object), within_(std::move(within)), source_(source) {
    if (!object.is_object()) {
      refuse({.key = within_.substr(0, within_.empty() ? 0 : within_.size() - 1),
              .expected = "an object",
              .found = geom::shown(object)});
    }
    for (const auto& [key, value] : object.items()) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      refuse({.says = fmt::format("{}{} is no member of an operation; expected some of: {}",
                                  within_, key, fmt::join(known, " "))});
    }
  }

  const nlohmann::json& value(const char* key, const char* expected) const {
    const auto at = object_.find(key);
    if (at == object_.end() || at->is_null()) {
      refuse({.key = within_ + key, .expected = expected, .found = "none"});
    }
    return *at;
  }

  std::string text(const char* key) const {
    const nlohmann::json& at = value(key, "a text that is not empty");
    if (!at.is_string() || at.get_ref<const std::string&>().empty()) {
      refuse(
          {.key = within_ + key, .expected = "a text that is not empty", .found = geom::shown(at)});
    }
    return at.get<std::string>();
  }
  std::string text_or_nothing(const char* key) const { return has(key) ? text(key) : ""; }

  double above_zero(const char* key, double most) const {
    const std::string expected = fmt::format("a number above 0 and at most {}", most);
    const nlohmann::json& at = value(key, expected.c_str());
    if (!at.is_number() || !(at.get<double>() > 0 && at.get<double>() <= most)) {
      refuse({.key = within_ + key, .expected = expected, .found = geom::shown(at)});
    }
    return at.get<double>();
  }
  std::optional<double> above_zero_or_nothing(const char* key, double most) const {
    return has(key) ? std::optional(above_zero(key, most)) : std::nullopt;
  }

  std::string word(const char* key, std::span<const std::string_view> words) const {
    const std::string found = text(key);
    if (std::find(words.begin(), words.end(), found) == words.end()) {
      refuse({.key = within_ + key,
              .expected = fmt::format("one of: {}", fmt::join(words, " ")),
              .found = geom::in_quotes(found)});
    }
    return found;
  }

 private:
  bool has(const char* key) const {
    const auto at = object_.find(key);
    return at != object_.end() && !at->is_null();
  }

  [[noreturn]] void refuse(geom::Fault fault) const {
    throw geom::InputError(source_, std::move(fault));
  }

  const nlohmann::json& object_;
  std::string within_;
  std::string_view source_;
};

Operator read_operator(const nlohmann::json& json, std::string_view source) {
  const Members members(json, "operator.", source, {"name", "registration", "contact"});
  return {members.text("name"), members.text("registration"), members.text_or_nothing("contact")};
}

Uas read_uas(const nlohmann::json& json, std::string_view source) {
  const Members members(
      json, "uas.", source,
      {"manufacturer", "model", "serial", "class", "dimension_m", "mass_kg", "endurance_s"});
  Uas out;
  out.manufacturer = members.text_or_nothing("manufacturer");
  out.model = members.text("model");
  out.serial = members.text("serial");
  out.uas_class = members.word("class", kClasses);
  out.dimension = members.above_zero("dimension_m", kLargestDimension);
  out.mass = members.above_zero_or_nothing("mass_kg", kLargestMass);
  out.endurance = members.above_zero_or_nothing("endurance_s", kLongestEndurance);
  return out;
}

// Of a built-in vehicle that this is.
std::optional<Vec3> built_in_body(const geom::Vehicle& vehicle) {
  const auto known = vehicle_named(vehicle.name);
  return known && known->vehicle.half == vehicle.half ? known->body : std::nullopt;
}

}  // namespace

std::optional<std::string> why_dimension_wrong(double dimension, const geom::Vehicle& vehicle,
                                               std::optional<Vec3> body) {
  const double room = 2 * std::hypot(vehicle.half.head<2>().minCoeff(), vehicle.half.z());
  if (dimension > room * kAbove) {
    return fmt::format(
        "the operation says that two points of the vehicle are {:g} m apart (dimension_m), and the "
        "box of {} that was proved has room for {:.3f} m: give a larger --vehicle",
        dimension, vehicle.name, room);
  }
  if (!body) body = built_in_body(vehicle);
  const double longest = body ? 2 * body->maxCoeff() : 0;
  if (dimension * kAbove >= longest) return std::nullopt;
  return fmt::format(
      "the operation says that no two points of the vehicle are more than {:g} m apart "
      "(dimension_m), and the body of {} is {:g} m long by its profile: say that much or more",
      dimension, vehicle.name, longest);
}

void require_dimension(const Operation& operation, const VehicleProfile& profile,
                       std::string_view source) {
  const auto why = why_dimension_wrong(operation.uas.dimension, profile.vehicle, profile.body);
  if (why) throw geom::InputError(source, {.says = *why});
}

Operation read_operation(std::string_view json, std::string_view source) {
  const nlohmann::json file = geom::parse_json(json, source);
  const Members members(file, "", source, {"operator", "uas", "lost_link", "purpose"});
  Operation out;
  out.by = read_operator(members.value("operator", "an object"), source);
  out.uas = read_uas(members.value("uas", "an object"), source);
  out.lost_link = members.text("lost_link");
  out.what = members.text_or_nothing("purpose");
  return out;
}

}  // namespace traj
