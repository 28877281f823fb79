#include "vehicle_option.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "cli/run.h"
#include "geom/base/error.h"

namespace cli {

void VehicleOptions::add_to(CLI::App& app) {
  app.add_option("--vehicle", word,
                 fmt::format("{}, FILE.json, box:HX,HY,HZ or sphere:R (metres)",
                             fmt::join(traj::vehicle_names(), ", ")));
  app.add_option("--margin", margin, "metres added to each half size of the vehicle")
      ->check(CLI::Range(0.0, 1e6));
}

std::optional<traj::VehicleProfile> VehicleOptions::profile() const {
  if (word.empty()) return std::nullopt;
  return parse_vehicle(word);
}

AskedRoom VehicleOptions::asked(const std::optional<traj::VehicleProfile>& profile) const {
  if (margin && !std::isfinite(*margin)) {
    throw UsageError(fmt::format("--margin: expected metres, found {}", *margin));
  }
  return {profile ? std::optional(profile->vehicle) : std::nullopt, margin};
}

Scenes::Scenes(geom::BoxMap map, const VehicleOptions& options, Differences differences,
               std::size_t budget)
    : map_(std::move(map)),
      profile_(options.profile()),
      asked_(options.asked(profile_)),
      differences_(differences),
      budget_(budget) {}

const geom::CollisionScene& Scenes::build(const Room& room) {
  if (!scene_ || !(scene_->vehicle() == room.vehicle) || scene_->margin() != room.margin) {
    geom::CollisionOptions collision;
    collision.budget = budget_;
    scene_.emplace(map_, room.vehicle, room.margin, collision);
  }
  return *scene_;
}

const geom::CollisionScene& Scenes::scene() {
  if (!profile_) throw UsageError("no vehicle: give --vehicle (there is no default)");
  return build({profile_->vehicle, asked_.margin.value_or(0)});
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
  const Room room = agreed_room(record, asked_, differences_, source, line);
  return build(room);
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
