#include "schedule.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "geom/text/json_line.h"

namespace fleet {
namespace {

constexpr std::size_t kNamed = 5;  // flights in the way that a message names

geom::JsonLine object_of(const traj::Zone& zone) {
  geom::JsonLine line;
  return line.add("shape", zone.round ? "cylinder" : "box").add("reach", zone.reach);
}

// By nearest rank, of what is in order; 0 of none.
double percentile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0;
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

}  // namespace

std::vector<traj::TimedFlight> Schedule::timed() const {
  std::vector<traj::TimedFlight> out;
  for (const traj::Departure& departure : made_.departures.of) {
    if (!departure.start) continue;
    const traj::FleetFlight& flight = made_.flights[departure.flight];
    out.push_back({flight.trajectory, *departure.start, flight.room});
  }
  return out;
}

std::size_t Schedule::refused() const {
  return static_cast<std::size_t>(
      std::count_if(made_.departures.of.begin(), made_.departures.of.end(),
                    [](const traj::Departure& departure) { return !departure.start; }));
}

std::size_t Schedule::without() const {
  return made_.stream.entries().size() - made_.departures.of.size();
}

std::vector<std::string> Schedule::blocked_ids(const traj::Departure& departure) const {
  std::vector<std::string> out;
  for (const std::uint32_t flight : departure.blocked) {
    out.push_back(made_.stream.record(flight).id);
  }
  return out;
}

std::string Schedule::why_refused(std::uint32_t number) const {
  const traj::Departure& departure = made_.departures.of[number];
  const traj::FleetFlight& flight = made_.flights[departure.flight];
  std::vector<std::string> ids = blocked_ids(departure);
  const std::size_t all = ids.size();
  ids.resize(std::min(all, kNamed));
  if (all == 0) {
    return fmt::format("the map's boxes with times leave it no departure from {} to {} s",
                       flight.earliest, flight.latest);
  }
  return fmt::format("no departure from {} to {} s keeps it apart from {}{}", flight.earliest,
                     flight.latest, fmt::join(ids, ", "),
                     all > kNamed ? fmt::format(" and {} more", all - kNamed) : "");
}

std::string Schedule::record_of(const Stream::Entry& entry) const {
  if (!entry.number) return traj::to_json_line(*entry.record);
  const traj::Departure& departure = made_.departures.of[*entry.number];
  const bool other = departure.start && &made_.stream.record(departure.flight) != entry.record;
  traj::TrajectoryRecord record = other ? made_.stream.record(departure.flight) : *entry.record;
  record.time = entry.record->time;
  record.time.earliest = made_.flights[departure.flight].earliest;
  record.time.start = departure.start;
  if (!departure.start) {
    record.status = traj::TrajectoryStatus::infeasible;
    record.trajectory = {};
    record.bound.reset();
    record.duration_bound.reset();
    record.rung.reset();
    record.solver.clear();
    record.message = why_refused(*entry.number);
  } else if (other) {
    record.message = "another way than the first, which could not depart in time";
  }
  return traj::to_json_line(record);
}

std::vector<std::string> Schedule::records() const {
  std::vector<std::string> out;
  for (const Stream::Entry& entry : made_.stream.entries()) out.push_back(record_of(entry));
  return out;
}

std::vector<double> Schedule::delays() const {
  std::vector<double> out;
  for (const traj::Departure& departure : made_.departures.of) {
    if (departure.start) {
      out.push_back(*departure.start - made_.flights[departure.flight].earliest);
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::string Schedule::report(const traj::TogetherResult& proof, int rounds) const {
  using geom::JsonLine;
  const std::vector<double> delay = delays();
  const double sum = std::accumulate(delay.begin(), delay.end(), 0.0);
  const double count = std::max<double>(1, static_cast<double>(delay.size()));
  std::vector<std::string> rerouted;
  JsonLine line;
  line.add("type", "fleet").add("ok", refused() == 0 && without() == 0 && proof.ok());
  line.add("flights", made_.departures.of.size()).add("departing", delay.size());
  if (without() > 0) line.add("left_out", without());
  line.add("delay", JsonLine()
                        .add("mean", sum / count)
                        .add("p95", percentile(delay, 0.95))
                        .add("max", percentile(delay, 1)));
  line.add("delayed", std::count_if(delay.begin(), delay.end(), [](double d) { return d > 0; }));
  std::vector<std::string> refusals;
  for (const Stream::Entry& entry : made_.stream.entries()) {
    if (!entry.number) continue;
    const traj::Departure& departure = made_.departures.of[*entry.number];
    if (!departure.start) {
      refusals.push_back(JsonLine()
                             .add("id", entry.record->id)
                             .add("blocked_by", blocked_ids(departure))
                             .object());
    } else if (&made_.stream.record(departure.flight) != entry.record) {
      rerouted.push_back(entry.record->id);
    }
  }
  line.add("rerouted", rerouted);
  line.add_json("refused", fmt::format("[{}]", fmt::join(refusals, ",")));
  line.add("as_asked",
           JsonLine().add("conflicts", traj::conflicts_as_asked(made_.flights, made_.conflicts)));
  line.add("pairs", proof.pairs).add("near", made_.conflicts.looked_at);
  line.add("conflicting", made_.conflicts.pairs.size());
  line.add("improved", JsonLine()
                           .add("rounds", rounds)
                           .add("moved", made_.departures.moved)
                           .add("mean_before", made_.departures.before / count));
  line.add("proof",
           JsonLine().add("ok", proof.ok()).add("near", proof.near).add("pieces", proof.pieces));
  if (spacing_.zone) {
    line.add("separation", object_of(*spacing_.zone));
  } else {
    line.add("separation", "vehicles");
  }
  if (spacing_.downwash) line.add("downwash", object_of(*spacing_.downwash));
  line.add("parked", name(parked_)).add("map", made_.stream.provenance().map);
  return line.add("epoch", made_.stream.epoch()).line();
}

}  // namespace fleet
