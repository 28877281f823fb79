#include "traj/record/simulated_flights.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/base/error.h"
#include "geom/base/parallel.h"
#include "geom/record/made_for_another.h"
#include "geom/text/record_lines.h"
#include "traj/curve/to_enu.h"
#include "traj/curve/trajectory_hash.h"
#include "traj/flight/tilted_radius.h"
#include "traj/tube/tube_certificate.h"
#include "traj/tube/tune_tube.h"

namespace traj {
namespace {

constexpr double kLongest = 36000;  // s: what is kept of a flight grows with it

// Flights that are held at once before their rows are written.
constexpr std::size_t kBlock = 32;

}  // namespace

struct SimulatedFlights::Flown {
  std::optional<ReferenceTrack> track;
  Flight flight;
  double cpu = 0;
};

void SimulatedFlights::refuse_size(const geom::Vehicle& made_for, std::size_t line) const {
  const auto another =
      geom::made_for_another({{}, {}, made_for, {}}, {{}, {}, options_.profile.vehicle, {}});
  throw geom::InputError(
      source_, line,
      {.says = fmt::format("the trajectory was {}", another.value_or("made for another vehicle")),
       .advice = "fly that one, or plan anew for this"});
}

// The vehicle that flies must be the one it was made for: in its limits, and over a map in its
// size.
void SimulatedFlights::require_vehicle(const Entry& entry) const {
  geom::Provenance made_for = entry.record.provenance;
  if (made_for.vehicle && made_for.vehicle->half != options_.profile.vehicle.half) {
    if (scenes_) refuse_size(*made_for.vehicle, entry.line);
    made_for.vehicle->half =
        options_.profile.vehicle.half;  // without a map nothing is said of room
  }
  made_for.margin.reset();  // kept for what happens here
  geom::agreed_room(made_for, {options_.profile.vehicle, 0}, geom::Differences::refused, source_,
                    entry.line);
}

const geom::CollisionScene& SimulatedFlights::scene_for(const Entry& entry) {
  return scenes_->scene_for(entry.record.provenance, source_, entry.line);
}

geom::Axes SimulatedFlights::axes(const Entry& entry) const {
  if (entry.record.provenance.frame) return *entry.record.provenance.frame;
  return scenes_ ? scenes_->map().spec().frame.axes : geom::Axes::enu;
}

ReferenceTrack SimulatedFlights::track_of(const Entry& entry) const {
  return ReferenceTrack(to_enu(axes(entry), entry.record.trajectory));
}

void SimulatedFlights::add(const TrajectoryRecord& record, std::size_t line,
                           const LookAt& look_at) {
  if (record.status == TrajectoryStatus::solved && record.trajectory.segments.empty()) {
    throw geom::InputError(source_, line, {.expected = "at least one segment", .found = "none"});
  }
  const double length = duration(record.trajectory);
  if (length > kLongest) {
    throw geom::InputError(source_, line,
                           {.key = "duration",
                            .expected = fmt::format("at most {} s to be flown", kLongest),
                            .found = fmt::to_string(length)});
  }
  const Entry entry{record, line};
  const auto has_its_id = [&](const Entry& other) {
    return other.record.id == record.id && other.record.status == TrajectoryStatus::solved;
  };
  if (record.status == TrajectoryStatus::solved &&
      std::any_of(entries_.begin(), entries_.end(), has_its_id)) {
    throw geom::InputError(source_, line,
                           {.expected = "each id once",
                            .found = geom::in_quotes(record.id) + " again",
                            .advice = "give each trajectory an id of its own"});
  }
  require_vehicle(entry);
  if (scenes_) scene_for(entry);
  if (scenes_ && look_at) look_at(record.trajectory, line);
  entries_.push_back(entry);
}

std::size_t SimulatedFlights::read(std::istream& in, const std::string& source,
                                   const geom::Shard& shard, const LookAt& look_at) {
  source_ = source;
  std::size_t total = 0;
  geom::for_each_line(in, source, [&](const std::string& line, std::size_t number) {
    if (shard.takes(total++)) add(parse_trajectory_record(line, source, number), number, look_at);
  });
  return total;
}

void SimulatedFlights::judge(const Entry& entry, const Flight& flight, FlightReport& report) {
  report.lost = flight.lost;
  report.saturated = flight.saturated;
  report.hover_seconds = flight.hover_seconds;
  for (const double tilt : flight.tilt) report.tilt = std::max(report.tilt, tilt);
  if (!flight.lost) report.tracking = traj::tracking(flight, report.duration);
  if (!scenes_) return;
  const geom::CollisionScene& scene = scene_for(entry);
  report.provenance = geom::provenance_of(scene);
  if (flight.path.empty()) return;  // lost at once
  TiltedVehicle tilted;
  const auto& tilt_max =
      options_.profile.vehicle.limits[geom::Limit::tilt];  // else the box holds every attitude
  if (tilt_max && options_.profile.body) {
    tilted.tilt_max = *tilt_max;
    tilted.half_at = [body = *options_.profile.body](double tilt) {
      return geom::attitude_half_sizes(body, std::min(tilt, 1.5707963267948966));
    };
  }
  report.check = check_flight_path(scene, true_vehicle(options_.flight), tilted, flight);
}

FlightReport SimulatedFlights::report_of(const Entry& entry, const ReferenceTrack* track,
                                         const Flight& flight) {
  FlightReport report;
  report.id = entry.record.id;
  report.status = entry.record.status;
  report.options = options_.flight;
  report.provenance = entry.record.provenance;
  report.time = entry.record.time;
  if (!track) return report;
  report.duration = track->duration();
  report.trajectory = trajectory_hash(entry.record.trajectory);
  judge(entry, flight, report);
  return report;
}

std::vector<double> SimulatedFlights::at_tilt(std::span<const double> radius, double tilt) const {
  return tilted_radius(radius, tilt, options_.profile.vehicle, options_.profile.body);
}

void SimulatedFlights::add_runs(const Entry& entry, std::span<const RunOutcome> runs,
                                FlightReport& report) {
  report.spread = *options_.spread;
  report.tube = tube_of(runs);
  if (options_.tube && report.tube.lost == 0) {
    report.tube_check = check_tube(scene_for(entry), entry.record.trajectory,
                                   at_tilt(report.tube.radius, report.tube.tilt), kTubePeriod);
  }
}

void SimulatedFlights::add_proof(const Entry& entry, const ReferenceTrack& track,
                                 const geom::Execution& run, FlightReport& report) {
  report.disturbances = options_.disturbances;
  report.provenance.vehicle = options_.profile.vehicle;  // the one that it is proved for
  report.proved = prove_tube(track, options_.flight, *options_.disturbances, run,
                             {.by_spans = options_.certificate});
  if (options_.certificate) report.proved = with_room(std::move(report.proved));
  if (options_.tube && !report.proved.trouble) {
    report.proved_check =
        check_tube(scene_for(entry), entry.record.trajectory,
                   at_tilt(report.proved.radius, report.proved.tilt), kTubePeriod);
  }
}

std::string SimulatedFlights::certificate_of(const Entry& entry, const FlightReport& report) const {
  if (!options_.certificate || report.proved.trouble) return {};
  return tube_certificate_line(entry.record.id, axes(entry),
                               {options_.flight, *options_.disturbances}, report.proved);
}

std::string SimulatedFlights::map_of(const Entry& entry) const {
  return scenes_ ? scenes_->map().hash() : entry.record.provenance.map.value_or("");
}

SimulatedFlights::Flown SimulatedFlights::flown(const Entry& entry) const {
  Flown out;
  if (entry.record.status != TrajectoryStatus::solved) return out;
  out.track.emplace(track_of(entry));
  const auto now = [&] { return options_.clock ? options_.clock() : 0; };
  const double begin = now();
  out.flight = simulate(*out.track, options_.flight, {options_.log_period, scenes_ != nullptr});
  out.cpu = now() - begin;
  return out;
}

void SimulatedFlights::fly(const geom::Execution& run,
                           const std::function<void(SimulatedFlight)>& told) {
  for (std::size_t first = 0; first < entries_.size(); first += kBlock) {
    std::vector<Flown> block(std::min(kBlock, entries_.size() - first));
    geom::parallel_for(block.size(), {run.threads, {}},
                       [&](std::size_t i) { block[i] = flown(entries_[first + i]); });
    for (std::size_t i = 0; i < block.size(); ++i) {
      const Entry& entry = entries_[first + i];
      const ReferenceTrack* track = block[i].track ? &*block[i].track : nullptr;
      SimulatedFlight out{report_of(entry, track, block[i].flight), {}, {}, {}, block[i].cpu};
      if (track && options_.spread) {
        add_runs(entry, fly_runs(*track, options_.flight, *options_.spread, {run.threads, {}}),
                 out.report);
      }
      if (track && options_.disturbances) {
        add_proof(entry, *track, {run.threads, {}}, out.report);
        out.certificate = certificate_of(entry, out.report);
      }
      out.log = {entry.record.id, map_of(entry), std::move(block[i].flight.samples)};
      if (track) {
        out.seconds = options_.flight.hover +
                      out.report.lost.value_or(out.report.duration + options_.flight.settle);
      }
      told(std::move(out));
      if (run.progress) run.progress(first + i + 1, entries_.size());
    }
  }
}

std::vector<ReferenceTrack> SimulatedFlights::solved_tracks() const {
  std::vector<ReferenceTrack> tracks;
  for (const Entry& entry : entries_) {
    if (entry.record.status != TrajectoryStatus::solved) continue;
    tracks.push_back(track_of(entry));
  }
  if (tracks.empty()) {
    throw geom::InputError(source_,
                           {.expected = "at least one solved trajectory", .found = "none"});
  }
  return tracks;
}

TuneResult SimulatedFlights::tune(const FlightCost& cost, const geom::Execution& run) const {
  return traj::tune(solved_tracks(), options_.flight, cost, {run.threads, {}});
}

TuneResult SimulatedFlights::tune_tube(const geom::Execution& run) const {
  return traj::tune_tube(solved_tracks(), options_.flight, *options_.disturbances, run);
}

}  // namespace traj
