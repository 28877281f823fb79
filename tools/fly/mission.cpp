#include "mission.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <sstream>

#include "cli/run.h"
#include "geom/base/error.h"
#include "geom/base/parallel.h"
#include "geom/record/made_for_another.h"
#include "geom/text/counted.h"
#include "traj/curve/to_enu.h"

namespace fly {
namespace {

constexpr double kLongest = 36000;  // s: what is kept of a flight grows with it

// Flights that are held at once before their rows are written.
constexpr std::size_t kBlock = 32;

double thread_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Flown {
  std::optional<traj::ReferenceTrack> track;
  traj::Flight flight;
  double cpu = 0;
};

}  // namespace

Mission::Mission(const Options& options, const cli::VehicleOptions& vehicle,
                 const std::optional<geom::BoxMap>& map)
    : options_(options), profile_(*vehicle.profile()), flight_(options.flight(profile_)) {
  if (!map) return;
  // A record's margin was kept for what happens here, so it is not asked for again.
  cli::VehicleOptions flown = vehicle;
  flown.margin = vehicle.margin.value_or(0);
  scenes_.emplace(*map, flown, cli::Scenes::Differences::allowed);
}

void Mission::refuse_size(const geom::Vehicle& made_for, std::size_t line) const {
  const auto another =
      geom::made_for_another({{}, {}, made_for, {}}, {{}, {}, profile_.vehicle, {}});
  throw geom::InputError(
      source_, line,
      {.says = fmt::format("the trajectory was {}", another.value_or("made for another vehicle")),
       .advice = "fly that one, or plan anew for this"});
}

// The vehicle that flies must be the one it was made for: in its limits, and over a map in its
// size.
void Mission::require_vehicle(const Entry& entry) const {
  geom::Provenance made_for = entry.record.provenance;
  if (made_for.vehicle && made_for.vehicle->half != profile_.vehicle.half) {
    if (scenes_) refuse_size(*made_for.vehicle, entry.line);
    made_for.vehicle->half = profile_.vehicle.half;  // without a map nothing is said of room
  }
  made_for.margin.reset();  // kept for what happens here
  cli::agreed_room(made_for, {profile_.vehicle, 0}, cli::Differences::refused, source_, entry.line);
}

const geom::CollisionScene& Mission::scene_for(const Entry& entry) {
  return scenes_->scene_for(entry.record.provenance, source_, entry.line);
}

geom::Axes Mission::axes(const Entry& entry) const {
  if (entry.record.provenance.frame) return *entry.record.provenance.frame;
  return scenes_ ? scenes_->map().spec().frame.axes : geom::Axes::enu;
}

traj::ReferenceTrack Mission::track_of(const Entry& entry) const {
  return traj::ReferenceTrack(traj::to_enu(axes(entry), entry.record.trajectory));
}

std::size_t Mission::read(cli::InputFile& file, const geom::Shard& shard) {
  source_ = file.name();
  std::size_t total = 0;
  file.for_each_line([&](const std::string& line, std::size_t number) {
    if (!shard.takes(total++)) return;
    Entry entry{traj::parse_trajectory_record(line, source_, number), number};
    if (entry.record.status == traj::TrajectoryStatus::solved &&
        entry.record.trajectory.segments.empty()) {
      throw geom::InputError(source_, number,
                             {.expected = "at least one segment", .found = "none"});
    }
    const double length = traj::duration(entry.record.trajectory);
    if (length > kLongest) {
      throw geom::InputError(source_, number,
                             {.key = "duration",
                              .expected = fmt::format("at most {} s to be flown", kLongest),
                              .found = fmt::to_string(length)});
    }
    require_vehicle(entry);
    if (scenes_) {
      const geom::CollisionScene& scene = scene_for(entry);
      options_.metres.check_input(scene.map().spec().frame, entry.record.trajectory, source_,
                                  number);
    }
    entries_.push_back(std::move(entry));
  });
  return total;
}

void Mission::judge(const Entry& entry, const traj::Flight& flight, traj::FlightReport& report) {
  report.lost = flight.lost;
  report.saturated = flight.saturated;
  report.hover_seconds = flight.hover_seconds;
  for (const double tilt : flight.tilt) report.tilt = std::max(report.tilt, tilt);
  if (!flight.lost) report.tracking = traj::tracking(flight, report.duration);
  if (!scenes_) return;
  const geom::CollisionScene& scene = scene_for(entry);
  report.provenance = geom::provenance_of(scene);
  if (flight.path.empty()) return;  // lost at once
  traj::TiltedVehicle tilted;
  const auto& tilt_max =
      profile_.vehicle.limits[geom::Limit::tilt];  // else the box holds every attitude
  if (tilt_max && profile_.body) {
    tilted.tilt_max = *tilt_max;
    tilted.half_at = [body = *profile_.body](double tilt) {
      return geom::attitude_half_sizes(body, std::min(tilt, 1.5707963267948966));
    };
  }
  report.check = traj::check_flight_path(scene, traj::true_vehicle(flight_), tilted, flight);
}

traj::FlightReport Mission::report_of(const Entry& entry, const traj::ReferenceTrack* track,
                                      const traj::Flight& flight) {
  traj::FlightReport report;
  report.id = entry.record.id;
  report.status = entry.record.status;
  report.options = flight_;
  report.provenance = entry.record.provenance;
  report.time = entry.record.time;
  if (!track) return report;
  report.duration = track->duration();
  judge(entry, flight, report);
  return report;
}

void Mission::add_runs(const Entry& entry, std::span<const traj::RunOutcome> runs,
                       traj::FlightReport& report) {
  report.spread = options_.spread();
  report.tube = traj::tube_of(runs);
  if (options_.tube && report.tube.lost == 0) {
    report.tube_check = traj::check_tube(scene_for(entry), entry.record.trajectory,
                                         report.tube.radius, traj::kTubePeriod);
  }
}

std::vector<std::vector<traj::RunOutcome>> Mission::fly_runs(const geom::Shard& shard,
                                                             const geom::Execution& run) const {
  std::vector<std::vector<traj::RunOutcome>> out;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].record.status == traj::TrajectoryStatus::solved) {
      out.push_back(traj::fly_runs(track_of(entries_[i]), flight_, options_.spread(), shard,
                                   {run.threads, {}}));
    }
    if (run.progress) run.progress(i + 1, entries_.size());
  }
  return out;
}

void Mission::take(traj::JoinedRuns runs) {
  const auto solved = static_cast<std::size_t>(std::count_if(
      entries_.begin(), entries_.end(),
      [](const Entry& entry) { return entry.record.status == traj::TrajectoryStatus::solved; }));
  if (runs.trajectories() != solved) {
    throw geom::InputError(
        source_, {.expected = fmt::format("the {} of the shards",
                                          geom::counted(runs.trajectories(), "solved trajectory",
                                                        "solved trajectories")),
                  .found = fmt::to_string(solved)});
  }
  joined_.emplace(std::move(runs));
}

std::string Mission::map_of(const Entry& entry) const {
  return scenes_ ? scenes_->map().hash() : entry.record.provenance.map.value_or("");
}

Tally Mission::fly(const geom::Execution& run, cli::RecordOutput& log, cli::RecordOutput* report) {
  Tally tally;
  std::size_t solved = 0;
  std::ostringstream head;
  traj::write_flight_log_header(head);
  log.head(head.str());
  for (std::size_t first = 0; first < entries_.size(); first += kBlock) {
    std::vector<Flown> flown(std::min(kBlock, entries_.size() - first));
    geom::parallel_for(flown.size(), {run.threads, {}}, [&](std::size_t i) {
      const Entry& entry = entries_[first + i];
      if (entry.record.status != traj::TrajectoryStatus::solved) return;
      flown[i].track.emplace(track_of(entry));
      const double begin = thread_seconds();
      const traj::FlightKeep keep{options_.log_period(), scenes_.has_value()};
      flown[i].flight = traj::simulate(*flown[i].track, flight_, keep);
      flown[i].cpu = thread_seconds() - begin;
    });
    for (std::size_t i = 0; i < flown.size(); ++i) {
      const Entry& entry = entries_[first + i];
      const traj::ReferenceTrack* track = flown[i].track ? &*flown[i].track : nullptr;
      auto told = report_of(entry, track, flown[i].flight);
      if (track && options_.runs > 0) {
        add_runs(entry,
                 joined_
                     ? joined_->outcomes(solved, track->duration())
                     : traj::fly_runs(*track, flight_, options_.spread(), {}, {run.threads, {}}),
                 told);
      }
      solved += track != nullptr;
      std::ostringstream rows;
      const geom::BoxMap* map = scenes_ ? &scenes_->map() : nullptr;
      traj::write_flight(rows,
                         {entry.record.id, map_of(entry), std::move(flown[i].flight.samples)});
      log.add(rows.str());
      if (track) {
        tally.flown += options_.hover + told.lost.value_or(told.duration + options_.settle);
        tally.cpu += flown[i].cpu;
      }
      ++tally.records;
      if (traj::accepted(told)) {
        tally.batch.add_good();
      } else {
        ++tally.failed;
        tally.batch.add_failed(traj::reason(told));
      }
      if (report) report->add(traj::to_json_line(told, profile_.airframe, map));
      if (run.progress) run.progress(first + i + 1, entries_.size());
    }
  }
  return tally;
}

traj::TuneResult Mission::tune(const geom::Execution& run) const {
  std::vector<traj::ReferenceTrack> tracks;
  for (const Entry& entry : entries_) {
    if (entry.record.status != traj::TrajectoryStatus::solved) continue;
    tracks.push_back(track_of(entry));
  }
  if (tracks.empty()) {
    throw geom::InputError(source_,
                           {.expected = "at least one solved trajectory", .found = "none"});
  }
  return traj::tune(tracks, flight_, options_.flight_cost(), {run.threads, {}});
}

}  // namespace fly
