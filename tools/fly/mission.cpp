#include "fly/mission.h"

#include <ctime>

#include "cli/run.h"
#include "geom/error.h"
#include "geom/parallel.h"
#include "traj/continuity.h"

namespace fly {
namespace {

// Flights that are held at once before their rows are written.
constexpr std::size_t kBlock = 32;

double thread_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Flown {
  traj::Flight flight;
  double cpu = 0;
};

}  // namespace

Mission::Mission(const Options& options, const cli::VehicleOptions& vehicle, const std::string& map)
    : options_(options), profile_(*vehicle.profile()), flight_(options.flight(profile_)) {
  if (!map.empty()) {
    scenes_.emplace(cli::open_map(map), vehicle, cli::Scenes::Differences::stricter_allowed);
  }
}

geom::Axes Mission::axes(const Entry& entry) const {
  if (entry.record.provenance.frame) return *entry.record.provenance.frame;
  return scenes_ ? scenes_->map().spec().frame.axes : geom::Axes::enu;
}

void Mission::read(cli::InputFile& file) {
  source_ = file.name();
  file.for_each_line([&](const std::string& line, std::size_t number) {
    Entry entry{traj::parse_trajectory_record(line, source_, number), number};
    if (entry.record.status == "solved" && entry.record.trajectory.segments.empty()) {
      throw geom::InputError(source_, number, "expected at least one segment, found none");
    }
    if (scenes_) scenes_->scene_for(entry.record.provenance, source_, number);
    entries_.push_back(std::move(entry));
  });
}

void Mission::judge(const Entry& entry, const traj::Flight& flight, traj::FlightReport& report) {
  report.lost = flight.lost;
  report.saturated = flight.saturated;
  report.hover_seconds = flight.hover_seconds;
  for (const double tilt : flight.tilt) report.tilt = std::max(report.tilt, tilt);
  if (!flight.lost) report.tracking = traj::tracking(flight, report.duration);
  if (!scenes_) return;
  const auto& scene = scenes_->scene_for(entry.record.provenance, source_, entry.line);
  report.provenance = geom::provenance_of(scene);
  if (flight.path.empty()) return;
  traj::TiltedVehicle tilted;
  if (profile_.body) {
    tilted.tilt_max = profile_.limits.tilt.value_or(0);
    tilted.half_at = [body = *profile_.body](double tilt) {
      return geom::attitude_half_sizes(body, std::min(tilt, 1.5707963267948966));
    };
  }
  report.check = traj::check_flown(scene, flight_.quadrotor, tilted, flight);
}

Tally Mission::fly(const geom::Execution& run, std::ostream& log, std::ostream* report) {
  Tally tally;
  traj::write_flight_log_header(log);
  const traj::FlightKeep keep{options_.log_period(), scenes_.has_value()};
  std::vector<std::optional<traj::SetpointTrack>> tracks(entries_.size());
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].record.status != "solved") continue;
    tracks[i].emplace(traj::to_enu(axes(entries_[i]), entries_[i].record.trajectory));
  }
  for (std::size_t first = 0; first < entries_.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, entries_.size() - first);
    std::vector<Flown> flown(count);
    const geom::Execution quiet{run.threads, {}};
    geom::parallel_for(count, quiet, [&](std::size_t i) {
      if (!tracks[first + i]) return;
      const double begin = thread_seconds();
      flown[i].flight = traj::simulate(*tracks[first + i], flight_, keep);
      flown[i].cpu = thread_seconds() - begin;
    });
    for (std::size_t i = 0; i < count; ++i) {
      const Entry& entry = entries_[first + i];
      traj::FlightReport told;
      told.id = entry.record.id;
      told.status = entry.record.status;
      told.options = flight_;
      told.provenance = entry.record.provenance;
      if (const auto& track = tracks[first + i]) {
        told.duration = track->duration();
        judge(entry, flown[i].flight, told);
        if (options_.runs > 0) {
          told.spread = traj::MonteCarloOptions{options_.runs, std::abs(options_.mass_error)};
          told.tube = traj::fly_often(*track, flight_, *told.spread, quiet);
        }
        if (options_.tube && told.tube.lost == 0) {
          told.tube_check =
              traj::check_tube(scenes_->scene_for(entry.record.provenance, source_, entry.line),
                               entry.record.trajectory, told.tube.radius, traj::kTubePeriod);
        }
        traj::write_flight(log, {entry.record.id, std::move(flown[i].flight.samples)});
        tally.flown += options_.hover + told.lost.value_or(told.duration + options_.settle);
        tally.cpu += flown[i].cpu;
      }
      ++tally.records;
      tally.failed += !traj::accepted(told);
      if (report) {
        *report << traj::to_json_line(told, profile_.airframe, scenes_ ? &scenes_->map() : nullptr);
      }
      if (run.progress) run.progress(first + i + 1, entries_.size());
    }
  }
  return tally;
}

traj::TuneResult Mission::tune(const geom::Execution& run) const {
  std::vector<traj::SetpointTrack> tracks;
  for (const Entry& entry : entries_) {
    if (entry.record.status != "solved") continue;
    tracks.emplace_back(traj::to_enu(axes(entry), entry.record.trajectory));
  }
  if (tracks.empty()) {
    throw geom::InputError(source_, "expected at least one solved trajectory, found none");
  }
  return traj::tune(tracks, flight_, options_.flight_cost(), {run.threads, {}});
}

}  // namespace fly
