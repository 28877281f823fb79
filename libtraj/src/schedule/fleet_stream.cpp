#include "traj/schedule/fleet_stream.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/base/error.h"
#include "geom/base/in_order.h"
#include "geom/base/rounding.h"
#include "geom/text/record_lines.h"
#include "traj/proof/domain.h"

namespace traj {

using geom::InputError;

namespace {
constexpr std::size_t kHeld = 1024;  // records that are read ahead
}  // namespace

void FleetStream::read_each(std::istream& in, const std::string& source, Add member) {
  struct Item {
    geom::RecordLine line;
    TrajectoryRecord record = {};
  };
  geom::RecordLines lines(in, source);
  const auto next = [&]() -> std::optional<Item> {
    auto line = lines.next();
    return line ? std::optional(Item{*std::move(line)}) : std::nullopt;
  };
  const auto parse = [&](Item& item) {
    item.record = parse_trajectory_record(item.line.text, source, item.line.number);
  };
  geom::in_order<Item>(run_, kHeld, next, parse, [&](Item& item) {
    (this->*member)(std::move(item.record), source, item.line.number);
  });
  gather();
}

void FleetStream::read(std::istream& in, const std::string& source) {
  read_each(in, source, &FleetStream::add);
}

void FleetStream::read_ways(std::istream& in, const std::string& source) {
  read_each(in, source, &FleetStream::add_way);
}

void FleetStream::read_others(std::istream& in, const std::string& source) {
  read_each(in, source, &FleetStream::add_other);
}

void FleetStream::gather() {
  ways_ = own_;
  ways_.insert(ways_.end(), alternatives_.begin(), alternatives_.end());
  std::stable_sort(ways_.begin(), ways_.end(),
                   [](const Way& a, const Way& b) { return a.flight.number < b.flight.number; });
  auto number = static_cast<std::uint32_t>(own_.size());
  for (Way way : others_) {
    way.flight.number = number++;
    ways_.push_back(way);
  }
}

void FleetStream::require_agrees(const TrajectoryRecord& record, const std::string& source,
                                 std::size_t line) {
  if (!any_) epoch_ = record.time.epoch;
  any_ = true;
  geom::require_map_agrees(record.provenance, provenance_, source, line);
  // What the first does not say, others may: they must agree among themselves.
  if (!provenance_.map) provenance_.map = record.provenance.map;
  if (!provenance_.frame) provenance_.frame = record.provenance.frame;
  geom::require_epoch_agrees(record.time.epoch, epoch_, source, line);
  if (outside_domain(record.trajectory, {})) {
    throw InputError(source, line,
                     {.expected = "durations from 1e-9 to 1e9 s in all and coordinates within 1e8 "
                                  "m: nothing can be proved of this trajectory"});
  }
}

namespace {

// As a collision scene has it.
geom::Vec3 grown(const geom::Vec3& half, double margin) {
  geom::Vec3 room;
  for (int axis = 0; axis < 3; ++axis) room[axis] = geom::add_up(half[axis], margin);
  return room;
}

}  // namespace

geom::Vec3 FleetStream::room_of(const TrajectoryRecord& record, const std::string& source,
                                std::size_t line) {
  geom::Vec3 room = geom::Vec3::Zero();
  if (record.provenance.vehicle || rules_.asked.vehicle) {
    const geom::Room agreed = geom::agreed_room(record.provenance, rules_.asked,
                                                geom::Differences::refused, source, line);
    room = grown(agreed.vehicle.half, agreed.margin);
    vehicles_.add(record.id, agreed.vehicle.half);
  }
  if (room.minCoeff() > 0) return room;
  if (rules_.by_vehicles) {
    throw InputError(
        source, line,
        {.expected = "a vehicle with a size along each axis, as the distance follows from that",
         .found = "none",
         .advice = "give --separation"});
  }
  if (rules_.moving) {
    throw InputError(source, line,
                     {.expected = "a vehicle with a size along each axis, as its box is what keeps "
                                  "clear of obstacles that move",
                      .found = "none",
                      .advice = "give --vehicle"});
  }
  return room;
}

// The options say nothing of the vehicles of others.
geom::Vec3 FleetStream::room_of_other(const TrajectoryRecord& record, const std::string& source,
                                      std::size_t line) {
  geom::Vec3 room = geom::Vec3::Zero();
  if (const auto& vehicle = record.provenance.vehicle) {
    room = grown(vehicle->half, record.provenance.margin.value_or(0));
    vehicles_.add(record.id, vehicle->half);
  }
  if (rules_.by_vehicles && !(room.minCoeff() > 0)) {
    throw InputError(source, line,
                     {.expected = "a record that names its vehicle, with a size along each axis, "
                                  "as the distance follows from that",
                      .found = "none",
                      .advice = "give --separation"});
  }
  return room;
}

void FleetStream::add(TrajectoryRecord record, const std::string& source, std::size_t line) {
  if (!entry_of_.emplace(record.id, entries_.size()).second) {
    throw InputError(
        source, line,
        {.expected = "each id once",
         .found = fmt::format(
             "\"{}\" again (other ways for a flight belong in a file of their own: --alternatives)",
             record.id)});
  }
  const TrajectoryRecord& kept = records_.emplace_back(std::move(record));
  if (kept.status != TrajectoryStatus::solved) {
    entries_.push_back({&kept, std::nullopt});
    return;
  }
  require_agrees(kept, source, line);
  FleetFlight flight;
  flight.trajectory = &kept.trajectory;
  flight.room = room_of(kept, source, line);
  flight.earliest = kept.time.earliest.value_or(kept.time.starts());
  flight.latest =
      std::min(kept.time.latest.value_or(geom::kLargestTime), flight.earliest + rules_.max_delay);
  flight.priority = kept.time.priority.value_or(0);
  flight.number = static_cast<std::uint32_t>(own_.size());
  entries_.push_back({&kept, flight.number});
  own_.push_back({&kept, flight});
}

namespace {

// Of two ways of one flight: both begin at one place, and both end at one.
void require_same_flight(const TrajectoryRecord& way, const TrajectoryRecord& first,
                         const std::string& source, std::size_t line) {
  constexpr double kSame = 1e-6;  // metres
  const auto require = [&](const char* does, const geom::Vec3& found, const geom::Vec3& expected) {
    if ((found - expected).cwiseAbs().maxCoeff() <= kSame) return;
    const auto shown = [](const geom::Vec3& p) {
      return fmt::format("({:g}, {:g}, {:g})", p.x(), p.y(), p.z());
    };
    throw InputError(source, line,
                     {.expected = fmt::format("another way of \"{}\", which {} at {}", way.id, does,
                                              shown(expected)),
                      .found = fmt::format("one that {} at {}", does, shown(found)),
                      .advice = "give this flight an id of its own"});
  };
  const auto& ours = way.trajectory.segments;
  const auto& theirs = first.trajectory.segments;
  require("begins", ours.front().point.front(), theirs.front().point.front());
  require("ends", ours.back().point.back(), theirs.back().point.back());
}

}  // namespace

void FleetStream::add_way(TrajectoryRecord record, const std::string& source, std::size_t line) {
  if (record.status != TrajectoryStatus::solved) return;
  const auto found = entry_of_.find(record.id);
  if (found == entry_of_.end()) {
    throw InputError(source, line,
                     {.expected = "another way for a flight of the stream",
                      .found = fmt::format("\"{}\", which is none of them", record.id)});
  }
  require_agrees(record, source, line);
  const Entry& entry = entries_[found->second];
  if (!entry.number) return;
  const Way& first = own_[*entry.number];
  Way way = first;
  way.record = &records_.emplace_back(std::move(record));
  way.flight.trajectory = &way.record->trajectory;
  way.flight.room = room_of(*way.record, source, line);
  require_same_flight(*way.record, *first.record, source, line);
  if (way.flight.room.minCoeff() > 0 &&
      (way.flight.room.array() < first.flight.room.array()).any()) {
    throw InputError(source, line,
                     {.expected = fmt::format("another way of \"{}\" with as much room for vehicle "
                                              "and margin as the stream has for it",
                                              way.record->id),
                      .found = "less",
                      .advice = "make it for that vehicle and margin"});
  }
  alternatives_.push_back(way);
}

void FleetStream::add_other(TrajectoryRecord record, const std::string& source, std::size_t line) {
  if (entry_of_.contains(record.id) || !others_ids_.insert(record.id).second) {
    throw InputError(source, line,
                     {.expected = "an id that no other flight has",
                      .found = fmt::format("\"{}\" again", record.id)});
  }
  const bool solved = record.status == TrajectoryStatus::solved;
  if (!solved || !record.time.start) {
    throw InputError(
        source, line,
        {.expected = "a flight that departs, as those of the stream keep apart from it",
         .found =
             fmt::format("\"{}\" without {}", record.id, solved ? "a start" : "a trajectory")});
  }
  require_agrees(record, source, line);
  const TrajectoryRecord& kept = records_.emplace_back(std::move(record));
  FleetFlight flight;
  flight.trajectory = &kept.trajectory;
  flight.room = room_of_other(kept, source, line);
  flight.earliest = flight.latest = *kept.time.start;
  flight.settled = true;
  others_.push_back({&kept, flight});
}

std::vector<FleetFlight> FleetStream::flights() const {
  std::vector<FleetFlight> out;
  for (const Way& way : ways_) out.push_back(way.flight);
  return out;
}

}  // namespace traj
