#include "traj/schedule/fleet_schedule.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "geom/base/percentile.h"
#include "geom/text/json_line.h"

namespace traj {
namespace {

constexpr std::size_t kNamed = 5;  // flights in the way that a message names

geom::JsonLine object_of(const Zone& zone) {
  geom::JsonLine line;
  return line.add("shape", zone.round ? "cylinder" : "box").add("reach", zone.reach);
}

}  // namespace

std::span<const Departure> FleetSchedule::own() const {
  return std::span(made_.departures.of).first(made_.stream.own());
}

FleetSchedule::FleetSchedule(const ScheduleParts& made, const Spacing& spacing, Parked parked)
    : made_(made), spacing_(spacing), parked_(parked) {
  for (const Departure& departure : made_.departures.of) {
    if (departure.start) departing_.push_back(departure.flight);
  }
}

FleetProof FleetSchedule::prove(const geom::Execution& run) const {
  std::vector<TimedFlight> timed;
  std::size_t own = 0;  // which come first
  for (const std::uint32_t way : departing_) {
    const FleetFlight& flight = made_.flights[way];
    const double start = made_.departures.of[flight.number].start.value();
    timed.push_back({flight.trajectory, start, flight.room});
    own += !flight.settled;
  }
  FleetProof proof{check_together(timed, {spacing_, parked_}, run), std::nullopt};
  const auto& refused = proof.together.refused;
  const auto count = std::count_if(refused.begin(), refused.end(),
                                   [&](const auto& pair) { return pair.flights.first < own; });
  if (count > 0) {
    throw std::runtime_error(
        fmt::format("the departures that were chosen could not be proved: {} pairs are too near, "
                    "or within rounding of it; nothing was written",
                    count));
  }
  proof.moving = made_.obstacles.prove(made_.flights, made_.departures);
  return proof;
}

std::pair<std::string, std::string> FleetSchedule::ids(const RefusedPair& pair) const {
  return {made_.stream.record(departing_[pair.flights.first]).id,
          made_.stream.record(departing_[pair.flights.second]).id};
}

std::string FleetSchedule::too_near(const RefusedPair& pair) const {
  const auto [one, other] = ids(pair);
  return fmt::format(
      "{} and {} of --others are not proved to keep apart from each other, which no departure "
      "chosen here can change",
      one, other);
}

std::size_t FleetSchedule::refused() const {
  return static_cast<std::size_t>(std::count_if(
      own().begin(), own().end(), [](const Departure& departure) { return !departure.start; }));
}

std::size_t FleetSchedule::departing() const { return own().size() - refused(); }

bool FleetSchedule::ok(Refused refused_ones) const {
  if (refused_ones == Refused::left_out) return departing() > 0;
  return refused() + without() == 0;
}

std::size_t FleetSchedule::without() const { return made_.stream.entries().size() - own().size(); }

std::vector<std::string> FleetSchedule::blocked_ids(const Departure& departure,
                                                    bool settled) const {
  std::vector<std::string> out;
  for (const std::uint32_t flight : departure.blocked) {
    if (made_.flights[flight].settled == settled) out.push_back(made_.stream.record(flight).id);
  }
  return out;
}

Barred FleetSchedule::barred(std::uint32_t number) const {
  const auto of_lower = [](const FleetFlight& flight, std::uint32_t n) {
    return flight.number < n;
  };
  const auto first = std::lower_bound(made_.flights.begin(), made_.flights.end(), number, of_lower);
  Barred out;
  for (auto way = first; way != made_.flights.end() && way->number == number; ++way) {
    const Barred& one =
        made_.obstacles.barred(static_cast<std::size_t>(way - made_.flights.begin()));
    out.by_map = out.by_map || one.by_map;
    out.moving.insert(out.moving.end(), one.moving.begin(), one.moving.end());
  }
  std::sort(out.moving.begin(), out.moving.end());
  out.moving.erase(std::unique(out.moving.begin(), out.moving.end()), out.moving.end());
  return out;
}

std::string FleetSchedule::why_refused(std::uint32_t number) const {
  const Departure& departure = made_.departures.of[number];
  const FleetFlight& flight = made_.flights[departure.flight];
  const Barred by = barred(number);
  std::vector<std::string> what;
  const auto add = [&](std::vector<std::string> names, std::string_view of) {
    if (names.empty()) return;
    const std::size_t more = names.size() > kNamed ? names.size() - kNamed : 0;
    names.resize(names.size() - more);
    what.push_back(fmt::format("{}{}{}", fmt::join(names, ", "),
                               more > 0 ? fmt::format(" and {} more", more) : "", of));
  };
  add(blocked_ids(departure, false), "");
  add(blocked_ids(departure, true), " of --others");
  if (by.by_map) what.emplace_back("the map's boxes with times");
  add(by.moving, " of --moving");
  return fmt::format("no departure from {} to {} s keeps it apart from {}", flight.earliest,
                     flight.latest, fmt::join(what, "; "));
}

std::string FleetSchedule::record_of(const FleetStream::Entry& entry) const {
  if (!entry.number) return to_json_line(*entry.record);
  const Departure& departure = made_.departures.of[*entry.number];
  const bool other = departure.start && &made_.stream.record(departure.flight) != entry.record;
  TrajectoryRecord record = other ? made_.stream.record(departure.flight) : *entry.record;
  record.time = entry.record->time;
  record.time.earliest = made_.flights[departure.flight].earliest;
  record.time.start = departure.start;
  if (!departure.start) {
    record.status = TrajectoryStatus::infeasible;
    record.trajectory = {};
    record.bound.reset();
    record.duration_bound.reset();
    record.rung.reset();
    record.solver.clear();
    record.message = why_refused(*entry.number);
  } else if (other) {
    record.message = "another way than the first, which could not depart in time";
  }
  return to_json_line(record);
}

std::vector<std::string> FleetSchedule::records(Refused refused) const {
  std::vector<std::string> out;
  for (const FleetStream::Entry& entry : made_.stream.entries()) {
    const bool departs = entry.number && made_.departures.of[*entry.number].start;
    if (departs || refused == Refused::kept) out.push_back(record_of(entry));
  }
  return out;
}

std::vector<double> FleetSchedule::delays() const {
  std::vector<double> out;
  for (const Departure& departure : own()) {
    if (departure.start) {
      out.push_back(*departure.start - made_.flights[departure.flight].earliest);
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::string FleetSchedule::refusal(const FleetStream::Entry& entry) const {
  const Departure& departure = made_.departures.of[*entry.number];
  std::vector<std::string> blocked = blocked_ids(departure, false);
  const std::vector<std::string> others = blocked_ids(departure, true);
  blocked.insert(blocked.end(), others.begin(), others.end());
  const Barred by = barred(*entry.number);
  geom::JsonLine line;
  line.add("id", entry.record->id).add("blocked_by", blocked);
  if (!others.empty()) line.add("others", others);
  if (by.by_map) line.add("map", true);
  if (!by.moving.empty()) line.add("moving", by.moving);
  return line.object();
}

std::vector<std::string> FleetSchedule::dropped_ids() const {
  std::vector<std::string> out;
  for (const FleetStream::Entry& entry : made_.stream.entries()) {
    const bool departs = entry.number && made_.departures.of[*entry.number].start;
    if (!departs) out.push_back(entry.record->id);
  }
  return out;
}

std::string FleetSchedule::report(const FleetProof& proof, int rounds, Refused refused_ones) const {
  using geom::JsonLine;
  const std::vector<double> delay = delays();
  const double sum = std::accumulate(delay.begin(), delay.end(), 0.0);
  const double count = std::max<double>(1, static_cast<double>(delay.size()));
  const TogetherResult& together = proof.together;
  JsonLine line;
  line.add("type", "fleet").add("ok", ok(refused_ones));
  line.add("flights", own().size()).add("departing", delay.size());
  if (made_.stream.others() > 0) line.add("others", made_.stream.others());
  if (!together.ok()) {
    line.add("others_too_near", together.refused,
             [&](const RefusedPair& pair) { return ids(pair); });
  }
  if (without() > 0) line.add("left_out", without());
  if (refused_ones == Refused::left_out) line.add("dropped", dropped_ids());
  line.add("delay", JsonLine()
                        .add("mean", sum / count)
                        .add("p95", delay.empty() ? 0 : geom::percentile(delay, 0.95))
                        .add("max", delay.empty() ? 0 : delay.back()));
  line.add("delayed", std::count_if(delay.begin(), delay.end(), [](double d) { return d > 0; }));
  std::vector<std::string> rerouted;
  std::vector<std::string> refusals;
  for (const FleetStream::Entry& entry : made_.stream.entries()) {
    if (!entry.number) continue;
    const Departure& departure = made_.departures.of[*entry.number];
    if (!departure.start) {
      refusals.push_back(refusal(entry));
    } else if (&made_.stream.record(departure.flight) != entry.record) {
      rerouted.push_back(entry.record->id);
    }
  }
  line.add("rerouted", rerouted);
  line.add_json("refused", fmt::format("[{}]", fmt::join(refusals, ",")));
  line.add("as_asked",
           JsonLine().add("conflicts", conflicts_as_asked(made_.flights, made_.conflicts)));
  line.add("pairs", together.pairs).add("near", made_.conflicts.looked_at);
  line.add("conflicting", made_.conflicts.pairs.size());
  JsonLine improved;
  improved.add("rounds", rounds).add("moved", made_.departures.moved);
  if (made_.departures.rescued > 0) improved.add("rescued", made_.departures.rescued);
  line.add("improved", improved.add("mean_before", made_.departures.before / count));
  add_proof(proof, line);
  return line.add("epoch", made_.stream.epoch()).line();
}

// What was proved, and of which distances.
void FleetSchedule::add_proof(const FleetProof& proof, geom::JsonLine& line) const {
  using geom::JsonLine;
  const TogetherResult& together = proof.together;
  line.add("proof", JsonLine()
                        .add("ok", together.ok())
                        .add("near", together.near)
                        .add("pieces", together.pieces));
  if (proof.moving) {
    line.add("moving", JsonLine()
                           .add("ok", proof.moving->ok())
                           .add("obstacles", proof.moving->obstacles)
                           .add("pieces", proof.moving->pieces));
  }
  if (spacing_.zone) {
    line.add("separation", object_of(*spacing_.zone));
  } else {
    line.add("separation", "vehicles");
  }
  if (spacing_.downwash) line.add("downwash", object_of(*spacing_.downwash));
  line.add("parked", name(parked_)).add("map", made_.stream.provenance().map);
}

}  // namespace traj
