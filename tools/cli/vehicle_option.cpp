#include "vehicle_option.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "files.h"
#include "geom/error.h"
#include "geom/io/json_fields.h"
#include "numbers_option.h"
#include "run.h"
#include "traj/io/airframe_record.h"
#include "traj/io/trajectory_record.h"

namespace cli {
namespace {

using geom::Vec3;

struct NamedBody {
  const char* name;
  Vec3 body;        // half sizes, metres
  double tilt_deg;  // the tilt the autopilot allows
  double vmax;      // m/s
};

VehicleProfile from_body(std::string name, const Vec3& body, double tilt_deg, traj::Limits limits) {
  const double tilt = tilt_deg * std::numbers::pi / 180;
  limits.tilt = tilt;
  return {{std::move(name), geom::attitude_half_sizes(body, tilt)}, limits, {}, body};
}

std::optional<VehicleProfile> built_in(const std::string& word) {
  // Ryze Tello user manual: 98 x 92.5 x 41 mm, 8 m/s. Bitcraze Crazyflie 2.1 data sheet:
  // 92 x 92 x 29 mm.
  const std::array<NamedBody, 2> bodies = {
      {{"tello", {0.049, 0.04625, 0.0205}, 35, 8}, {"crazyflie", {0.046, 0.046, 0.0145}, 35, 3}}};
  for (const NamedBody& b : bodies) {
    if (word != b.name) continue;
    traj::Limits limits;
    limits.vmax = b.vmax;
    return from_body(word, b.body, b.tilt_deg, limits);
  }
  return std::nullopt;
}

Vec3 half_sizes(std::string_view numbers, std::size_t count, const std::string& word) {
  const auto values = parse_numbers(numbers, count);
  if (!values || *std::min_element(values->begin(), values->end()) < 0) {
    throw UsageError(
        fmt::format("--vehicle: expected {} finite number(s) >= 0 in metres, "
                    "found \"{}\"",
                    count, word));
  }
  return count == 1 ? Vec3::Constant(values->front())
                    : Vec3((*values)[0], (*values)[1], (*values)[2]);
}

VehicleProfile from_file(const std::string& path) {
  InputFile file(path);
  const geom::JsonFields fields(file.read_all(), path, 0);
  const Vec3 body = fields.point("body");
  const double tilt = fields.number("tilt_max_deg").value_or(0);
  if (body.minCoeff() < 0) fields.refuse("body must be half sizes >= 0 in metres");
  if (tilt < 0 || tilt > 80) fields.refuse("tilt_max_deg must be within 0 to 80");
  VehicleProfile profile =
      from_body(fields.text("name", path), body, tilt, traj::parse_limits(fields));
  if (!fields.has("tilt_max_deg")) profile.limits.tilt.reset();
  profile.airframe = traj::parse_airframe(fields);
  return profile;
}

std::string shown(const geom::Vehicle& v) {
  return fmt::format("{} [{}, {}, {}]", v.name, v.half[0], v.half[1], v.half[2]);
}

}  // namespace

VehicleProfile parse_vehicle(const std::string& word) {
  if (word.starts_with("box:")) return {{word, half_sizes(word.substr(4), 3, word)}, {}, {}, {}};
  if (word.starts_with("sphere:")) return {{word, half_sizes(word.substr(7), 1, word)}, {}, {}, {}};
  if (const auto named = built_in(word)) return *named;
  if (word.ends_with(".json")) return from_file(word);
  throw UsageError(
      fmt::format("--vehicle: expected tello, crazyflie, FILE.json, box:HX,HY,HZ or "
                  "sphere:R, found \"{}\"",
                  word));
}

void VehicleOptions::add_to(CLI::App& app) {
  app.add_option("--vehicle", word,
                 "tello, crazyflie, FILE.json, box:HX,HY,HZ or sphere:R (metres)");
  app.add_option("--margin", margin, "metres added to each half size of the vehicle")
      ->check(CLI::Range(0.0, 1e6));
}

std::optional<VehicleProfile> VehicleOptions::profile() const {
  if (word.empty()) return std::nullopt;
  return parse_vehicle(word);
}

Scenes::Scenes(geom::BoxMap map, const VehicleOptions& options, Differences differences,
               std::size_t budget)
    : map_(std::move(map)),
      profile_(options.profile()),
      margin_(options.margin),
      differences_(differences),
      budget_(budget) {}

const geom::CollisionScene& Scenes::build(const geom::Vehicle& vehicle, double margin) {
  if (!scene_ || !(scene_->vehicle() == vehicle) || scene_->margin() != margin) {
    geom::CollisionOptions collision;
    collision.budget = budget_;
    scene_.emplace(map_, vehicle, margin, collision);
  }
  return *scene_;
}

const geom::CollisionScene& Scenes::scene() {
  if (!profile_) throw UsageError("no vehicle: give --vehicle (there is no default)");
  return build(profile_->vehicle, margin_.value_or(0));
}

const geom::CollisionScene& Scenes::scene_for(const geom::Provenance& record,
                                              std::string_view source, std::size_t line) {
  const auto refuse = [&](const std::string& message) {
    throw geom::InputError(source, line, message);
  };
  if (record.map && *record.map != map_.hash()) {
    refuse(fmt::format("made for another map: expected {}, found {}", map_.hash(), *record.map));
  }
  if (record.frame && *record.frame != map_.spec().frame.axes) {
    refuse(fmt::format("expected frame {}, as the map has, found {}",
                       geom::name(map_.spec().frame.axes), geom::name(*record.frame)));
  }
  if (!profile_ && !record.vehicle) {
    throw UsageError("no vehicle: the record names none, so give --vehicle");
  }
  const geom::Vehicle vehicle = profile_ ? profile_->vehicle : *record.vehicle;
  const double margin = margin_ ? *margin_ : record.margin.value_or(0);
  if (record.vehicle && differences_ != Differences::allowed) {
    const bool same = vehicle.half == record.vehicle->half && margin == record.margin.value_or(0);
    const Vec3 asked = vehicle.half.array() + margin;
    const Vec3 had = record.vehicle->half.array() + record.margin.value_or(0);
    const bool stricter = (asked.array() >= had.array()).all();
    if (!same && !(stricter && differences_ == Differences::stricter_allowed)) {
      refuse(fmt::format("expected vehicle {} with margin {}, as asked, found {} with margin {}",
                         shown(vehicle), margin, shown(*record.vehicle),
                         record.margin.value_or(0)));
    }
  }
  return build(vehicle, margin);
}

void require_same(const geom::Provenance& made_for, const geom::CollisionScene& scene,
                  const std::string& source, const char* kind) {
  const geom::Provenance ours = geom::provenance_of(scene);
  const auto refuse = [&](const char* what) {
    throw geom::InputError(source, fmt::format("the {} was made for another {}", kind, what));
  };
  if (made_for.map != ours.map) refuse("map");
  if (made_for.frame != ours.frame) refuse("frame");
  if (!made_for.vehicle || made_for.vehicle->half != ours.vehicle->half) refuse("vehicle");
  if (made_for.margin != ours.margin) refuse("margin");
}

}  // namespace cli
