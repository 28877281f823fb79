#include "traj/check/flight_set.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "geom/record/agreed_room.h"
#include "traj/proof/domain.h"
#include "traj/together/flights_hash.h"

namespace traj {

void FlightSet::require_needs(const TrajectoryRecord& record, const TimedFlight& flight,
                              std::string_view source, std::size_t line) const {
  if (needs_.start && !record.time.start) {
    throw geom::InputError(
        source, line,
        {.expected = fmt::format("\"start\" of \"{}\", seconds after the epoch", record.id),
         .found = "none",
         .advice = "where obstacles move, a verdict holds for one departure alone"});
  }
  if (!needs_.room || task_.rule.spacing.zone || flight.room.minCoeff() > 0) return;
  throw geom::InputError(
      source, line,
      {.expected = "a vehicle with a size along each axis, as the distance follows from that",
       .found = "none",
       .advice = "give --separation"});
}

FlightRoom room_of(const geom::CollisionScene& scene, const TrajectoryRecord& record) {
  return {scene.map().hash(), scene.half(),
          geom::smaller_than_asked({scene.vehicle(), scene.margin()}, record.provenance),
          scene.vehicle().half};
}

void FlightSet::add(const TrajectoryRecord& record, const geom::CollisionScene* scene,
                    std::string_view source, std::size_t line) {
  add(record, scene ? std::optional(room_of(*scene, record)) : std::nullopt, source, line);
}

void FlightSet::add(TrajectoryRecord record, const std::optional<FlightRoom>& room,
                    std::string_view source, std::size_t line) {
  const bool first = ids_.empty();
  if (!ids_.insert(record.id).second) {
    throw geom::InputError(
        source, line,
        {.expected = "each id once", .found = fmt::format("\"{}\" again", record.id)});
  }
  if (first) task_.epoch = record.time.epoch;
  geom::require_epoch_agrees(record.time.epoch, task_.epoch, source, line);
  if (!room || outside_domain(record.trajectory, {})) {
    ++left_out_;
    return;
  }
  TimedFlight flight{nullptr, record.time.starts(), room->half};
  require_needs(record, flight, source, line);
  vehicles_.add(record.id, room->vehicle);
  task_.map = room->map;
  task_.overridden = task_.overridden || room->overridden;
  flight.trajectory = &trajectories_.emplace_back(std::move(record.trajectory));
  flights_.push_back(flight);
  task_.ids.push_back(std::move(record.id));
}

void FlightSet::drop(std::vector<std::string> ids) {
  const std::set<std::string> gone(ids.begin(), ids.end());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < flights_.size(); ++i) {
    if (gone.count(task_.ids[i]) > 0) continue;
    flights_[kept] = flights_[i];
    if (kept != i) task_.ids[kept] = std::move(task_.ids[i]);
    ++kept;
  }
  flights_.erase(flights_.begin() + static_cast<std::ptrdiff_t>(kept), flights_.end());
  task_.ids.resize(kept);
  left_out_ = 0;
  task_.dropped = std::move(ids);
}

TogetherResult FlightSet::check(bool exact, const geom::Execution& run) {
  task_.rule.exact = exact;
  task_.flights_hash = flights_hash(task_.ids, flights_, task_.epoch);
  return check_together(flights_, task_.rule, run);
}

}  // namespace traj
