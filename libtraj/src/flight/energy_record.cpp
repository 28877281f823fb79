#include "flight/energy_record.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "geom/text/parse_json.h"

namespace traj {
namespace {

using geom::JsonFields;

constexpr double kSecondsPerHour = 3600;
constexpr double kUsualReserve = 0.2;
constexpr double kMostWind = 100;  // m/s
constexpr std::array kKeys = {"capacity_wh", "hover_w", "cruise_w",
                              "climb_w",     "reserve", "wind_m_s"};

// The values of one object, as numbers.
class Values {
 public:
  Values(const JsonFields& fields, const nlohmann::json& object)
      : fields_(fields), object_(object) {
    if (!object.is_object()) {
      fields.refuse({.key = "energy", .expected = "an object", .found = geom::shown(object)});
    }
    for (const auto& [key, value] : object.items()) {
      if (std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end()) continue;
      fields.refuse({.says = fmt::format("{} is no key of energy; expected some of: {}",
                                         geom::shown(nlohmann::json(key)), fmt::join(kKeys, " "))});
    }
  }

  std::optional<double> above_zero(const char* key) const {
    const auto value = number(key);
    if (value && !(*value > 0)) refuse(key, "> 0", *value);
    return value;
  }

  double within(const char* key, double fallback, double most) const {
    const double value = number(key).value_or(fallback);
    if (!(value >= 0 && value < most)) {
      refuse(key, fmt::format("from 0 to below {}", most), value);
    }
    return value;
  }

 private:
  std::optional<double> number(const char* key) const {
    const auto at = object_.find(key);
    if (at == object_.end() || at->is_null()) return std::nullopt;
    return fields_.number(*at, name(key));
  }

  [[noreturn]] void refuse(const char* key, std::string expected, double found) const {
    fields_.refuse(
        {.key = name(key), .expected = std::move(expected), .found = fmt::to_string(found)});
  }

  static std::string name(const char* key) { return std::string("energy.") + key; }

  const JsonFields& fields_;
  const nlohmann::json& object_;
};

}  // namespace

std::optional<Energy> parse_energy(const JsonFields& fields, const Airframe& airframe) {
  if (!fields.has("energy")) return std::nullopt;
  const Values values(fields, fields.value("energy"));
  Energy out;
  const auto capacity = values.above_zero("capacity_wh");
  out.capacity = kSecondsPerHour * capacity.value_or(airframe.battery.value_or(0));
  if (out.capacity == 0) {
    fields.refuse({.key = "energy.capacity_wh",
                   .expected = "the energy of a full battery, Wh, here or as battery_wh",
                   .found = "neither"});
  }
  auto hover = values.above_zero("hover_w");
  if (!hover && airframe.endurance) {
    // The endurance is that of the battery as it was made, which may hold less by now.
    const double made = kSecondsPerHour * airframe.battery.value_or(0);
    hover = std::max(out.capacity, made) / *airframe.endurance;
  }
  if (!hover) {
    fields.refuse({.key = "energy.hover_w",
                   .expected = "the power of hovering, W, or endurance_s beside energy",
                   .found = "neither"});
  }
  out.power = std::max({*hover, values.above_zero("cruise_w").value_or(0),
                        values.above_zero("climb_w").value_or(0)});
  out.reserve = values.within("reserve", kUsualReserve, 1);
  out.wind = values.within("wind_m_s", 0, kMostWind);
  return out;
}

}  // namespace traj
