#include "scenes.h"

#include <fmt/format.h>

#include "cli/answer/exit.h"
#include "geom/base/error.h"
#include "geom/record/made_for_another.h"

namespace cli {

Scenes::Scenes(geom::BoxMap map, const VehicleOptions& options, Differences differences)
    : map_(std::move(map)),
      profile_(options.profile()),
      asked_(options.asked(profile_)),
      differences_(differences),
      budget_(options.budget()) {}

const geom::CollisionScene& Scenes::build(const Room& room) {
  if (!scene_ || !(scene_->vehicle() == room.vehicle) || scene_->margin() != room.margin) {
    geom::CollisionOptions collision;
    collision.budget = budget_;
    scene_.emplace(map(), room.vehicle, room.margin, collision);
  }
  return *scene_;
}

const geom::CollisionScene& Scenes::scene() {
  if (!profile_)
    throw UsageError(
        "no vehicle: give --vehicle, such as tello or box:0.5,0.5,0.3 (there is no default)");
  if (asked_.spare > 0) {
    throw UsageError("--spare: expected records, whose margin it takes from: give --margin alone");
  }
  return build({profile_->vehicle, asked_.margin.value_or(0)});
}

const geom::CollisionScene& Scenes::scene_for(const geom::Provenance& record,
                                              std::string_view source, std::size_t line) {
  map_.require(record, source, line);
  const Room room = agreed_room(record, asked_, differences_, source, line);
  return build(room);
}

void Scenes::require_same_room(const geom::Provenance& record, std::string_view source,
                               std::size_t line) const {
  const Room room = agreed_room(record, asked_, differences_, source, line);
  if (scene_ && scene_->vehicle() == room.vehicle && scene_->margin() == room.margin) return;
  throw geom::InputError(
      source, line,
      {.expected = "the vehicle and margin of the records before",
       .found = "others",
       .advice = "draw them apart, or name one for all with --vehicle and --margin"});
}

nlohmann::ordered_json Scenes::stats() const {
  const geom::CollisionCounts counts = scene_ ? scene_->counts() : geom::CollisionCounts();
  return {{"groups", counts.groups},
          {"built", counts.built},
          {"built_again", counts.built_again},
          {"most_bytes", counts.most_bytes},
          {"memory", budget_}};
}

void require_same(const geom::Provenance& made_for, const geom::CollisionScene& scene,
                  const std::string& source, const char* kind) {
  if (const auto another = geom::made_for_another(made_for, geom::provenance_of(scene))) {
    throw geom::InputError(source,
                           {.says = fmt::format("the {} was {}", kind, *another),
                            .advice = fmt::format("ask for that one, or make the {} anew", kind)});
  }
}

}  // namespace cli
