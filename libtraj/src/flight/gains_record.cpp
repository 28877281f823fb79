#include "traj/flight/gains_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string_view>
#include <vector>

#include "geom/text/json_fields.h"

namespace traj {
namespace {

using geom::JsonFields;
using geom::Vec3;

constexpr double kSteepest = 80;  // degrees

// One object of the gains: its known keys, each taken over where it is there.
class Block {
 public:
  Block(const JsonFields& fields, const nlohmann::json& object, std::string name)
      : fields_(fields), object_(object), name_(std::move(name)) {
    if (!object_.is_object()) {
      fields_.refuse({.key = std::string(name_), .expected = "an object", .found = object_.dump()});
    }
  }

  void vector(const char* key, Vec3& value) {
    if (!take(key)) return;
    const Vec3 read = fields_.point(object_[key], path(key));
    if (read.minCoeff() < 0) refuse(key, ">= 0 on each axis");
    value = read;
  }

  void number(const char* key, double least, double most, double& value, double scale = 1) {
    if (!take(key)) return;
    const double read = fields_.number(object_[key], path(key));
    if (!(read >= least && read <= most)) refuse(key, fmt::format("from {} to {}", least, most));
    value = read * scale;
  }

  void pid(const char* key, PidGains& value) {
    if (!take(key)) return;
    Block block(fields_, object_[key], path(key));
    block.vector("p", value.p);
    block.vector("i", value.i);
    block.vector("d", value.d);
    block.number("clip", 1e-9, 1e9, value.clip);
    block.end();
  }

  template <class Read>
  void block(const char* key, const Read& read) {
    if (!take(key)) return;
    Block inner(fields_, object_[key], path(key));
    read(inner);
    inner.end();
  }

  // Refuses a key that was not asked for: a misspelt gain is not a gain.
  void end() const {
    for (const auto& [key, value] : object_.items()) {
      if (std::find(known_.begin(), known_.end(), key) == known_.end()) {
        fields_.refuse({.says = fmt::format("{} has no key \"{}\"; expected one of {}", name_, key,
                                            fmt::join(known_, ", "))});
      }
    }
  }

 private:
  bool take(const char* key) {
    known_.push_back(key);
    return object_.contains(key);
  }
  std::string path(const char* key) const { return name_ + '.' + key; }
  [[noreturn]] void refuse(const char* key, std::string_view range) const {
    fields_.refuse(
        {.key = path(key), .expected = std::string(range), .found = object_[key].dump()});
  }

  const JsonFields& fields_;
  const nlohmann::json& object_;
  std::string name_;
  std::vector<std::string_view> known_;
};

nlohmann::ordered_json numbers(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

nlohmann::ordered_json object_of(const PidGains& gains) {
  nlohmann::ordered_json out = {
      {"p", numbers(gains.p)}, {"i", numbers(gains.i)}, {"d", numbers(gains.d)}};
  if (std::isfinite(gains.clip)) out["clip"] = gains.clip;
  return out;
}

}  // namespace

Gains parse_gains(const JsonFields& fields, const Gains& base) {
  Gains gains = base;
  if (!fields.has("gains")) return gains;
  Block all(fields, fields.value("gains"), "gains");
  all.pid("position", gains.position);
  all.pid("velocity", gains.velocity);
  all.vector("attitude", gains.attitude);
  all.pid("rates", gains.rates);
  all.block("feed_forward", [&](Block& block) {
    block.number("velocity", 0, 2, gains.feed_forward.velocity);
    block.number("acceleration", 0, 2, gains.feed_forward.acceleration);
    block.number("body_rates", 0, 2, gains.feed_forward.body_rates);
  });
  all.number("tilt_max_deg", 1, kSteepest, gains.tilt_max, std::numbers::pi / 180);
  all.block("geometric", [&](Block& block) {
    block.vector("position", gains.geometric.position);
    block.vector("velocity", gains.geometric.velocity);
    block.vector("attitude", gains.geometric.attitude);
    block.vector("rates", gains.geometric.rates);
    block.vector("lead", gains.geometric.lead);
  });
  all.end();
  return gains;
}

std::string to_json(const Gains& gains) {
  const FeedForward& forward = gains.feed_forward;
  const GeometricGains& geometric = gains.geometric;
  const nlohmann::ordered_json out = {{"position", object_of(gains.position)},
                                      {"velocity", object_of(gains.velocity)},
                                      {"attitude", numbers(gains.attitude)},
                                      {"rates", object_of(gains.rates)},
                                      {"feed_forward",
                                       {{"velocity", forward.velocity},
                                        {"acceleration", forward.acceleration},
                                        {"body_rates", forward.body_rates}}},
                                      {"tilt_max_deg", gains.tilt_max * 180 / std::numbers::pi},
                                      {"geometric",
                                       {{"position", numbers(geometric.position)},
                                        {"velocity", numbers(geometric.velocity)},
                                        {"attitude", numbers(geometric.attitude)},
                                        {"rates", numbers(geometric.rates)},
                                        {"lead", numbers(geometric.lead)}}}};
  return nlohmann::ordered_json{{"gains", out}}.dump(2) + '\n';
}

}  // namespace traj
