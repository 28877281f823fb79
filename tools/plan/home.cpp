#include "home.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/batch.h"
#include "cli/file/files.h"
#include "cli/option/option_check.h"
#include "cli/option/scenes.h"
#include "cli/shard/record_output.h"
#include "geom/base/in_order.h"
#include "geom/text/record_lines.h"
#include "traj/home/home_flight.h"
#include "traj/home/ways_home.h"
#include "ways_planner.h"

namespace planning {
namespace {

constexpr std::size_t kHeld = 64;  // flights at a time

struct Item {
  geom::RecordLine line;
  WaysPlanner::Answer answer = {};
};

// "q1: no way home from 12.3 to 15.2 s of the flight"
std::string sentence(const WaysPlanner::Answer& answer) {
  if (!answer.flight.without.empty()) return answer.flight.id + ": " + answer.flight.without;
  for (const traj::WayGap& gap : answer.home.gaps) {
    return fmt::format("{}: no way home from {:.6g} to {:.6g} s of the flight", answer.flight.id,
                       gap.from, gap.until);
  }
  for (const traj::WayHome& way : answer.home.ways) {
    if (way.latest_departure == way.until) continue;
    const double last = way.latest_departure.value_or(way.from);
    return fmt::format("{}: not enough energy for a way home from {:.6g} s of the flight on",
                       answer.flight.id, last);
  }
  return {};
}

std::string_view reason(const WaysPlanner::Answer& answer) {
  if (!answer.flight.without.empty()) return "no_path";
  return answer.home.gaps.empty() ? "endurance" : "unreachable";
}

// What the ways of all flights came to.
struct Totals {
  std::size_t flights = 0;
  std::size_t ways = 0;
  double seconds = 0;  // of all flights
  double covered = 0;
  double metres = 0;  // s m: the longest way of each contingency, times how long it holds
  std::optional<double> shortest;

  void add(const traj::WaysHome& home) {
    ways += home.ways.size();
    seconds += home.duration;
    covered += home.duration * traj::share(home);
    for (const traj::WayHome& way : home.ways) {
      metres += way.length * (way.until - way.from);
      shortest = std::min(shortest.value_or(way.length), way.length);
    }
  }

  nlohmann::ordered_json stats() const {
    nlohmann::ordered_json out = {{"flights", flights},
                                  {"ways", ways},
                                  {"seconds", seconds},
                                  {"share", seconds > 0 ? covered / seconds : 0}};
    if (covered > 0) out["mean_length"] = metres / covered;
    if (shortest) out["least_length"] = *shortest;
    return out;
  }
};

// Contingencies of all flights, and what they came to.
class HomeOutput {
 public:
  explicit HomeOutput(const HomeOption::Run& run)
      : run_(run), out_(run.output, "output", run.sharding) {}

  std::size_t next() { return total_++; }  // the number of a flight of the stream

  void add(const WaysPlanner::Answer& answer) {
    any_path_ = any_path_ || answer.flight.kind == "path";
    std::string lines;
    for (const auto& record : answer.records) lines += traj::to_json_line(record);
    out_.add(lines);
    out_.pass_on();
    ++totals_.flights;
    totals_.add(answer.home);
    all_ = all_ && answer.complete;
    answer.complete ? batch_.add_good() : batch_.add_failed(reason(answer), sentence(answer));
  }

  cli::Exit commit(const std::optional<double>& vmax) {
    if (!run_.sharding.asked()) traj::require_vmax_used(vmax, any_path_);
    const cli::Exit exit = all_ ? cli::Exit::yes : cli::Exit::no;
    out_.commit(total_, exit);
    run_.common.write_stats(totals_.stats());
    batch_.tell(run_.common, "skyway-plan", "flights have no way home at some times");
    return exit;
  }

 private:
  const HomeOption::Run& run_;
  cli::RecordOutput out_;
  Totals totals_;
  cli::Batch batch_;
  std::size_t total_ = 0;
  bool any_path_ = false;
  bool all_ = true;
};

// Lets --margin be no less than what the autopilots stray.
WaysPlanner::Options settled(cli::AutopilotOptions& autopilot, cli::VehicleOptions& vehicle) {
  autopilot.settle(vehicle.profile());
  WaysPlanner::Options out;
  out.models = traj::return_models(autopilot.flier);
  if (vehicle.margin) {
    vehicle.margin = std::max(*vehicle.margin, traj::least_margin(out.models));
  }
  return out;
}

}  // namespace

void HomeOption::add_to(CLI::App& app) {
  auto* home = app.add_option("--home", sites_,
                              "landing sites, GeoJSON points and polygons: plan ways home from "
                              "every instant of FLIGHTS");
  app.add_option("flights", flights_, "with --home: trajectories or paths (default: stdin)")
      ->needs(home);
  app.add_flag("--home-local", local_,
               "coordinates of the landing sites are the map's own metres, not degrees")
      ->needs(home);
  app.add_option("--vmax", vmax_,
                 "with --home: m/s with which paths are flown (default: the vehicle's limit)")
      ->check(CLI::PositiveNumber)
      ->needs(home);
  autopilot_.add_to(app);
}

void HomeOption::refuse_idle(const CLI::App& app) const {
  cli::only_for(app, asked(), {"--autopilot", "--params", "--drag", "--navigation"}, "--home");
  if (!asked()) return;
  cli::only_for(app, false,
                {"--queries",   "--from",        "--to",     "--lattice",  "--roadmap", "--raw",
                 "--resample",  "--snap-ends",   "--method", "--spacing",  "--connect", "--step",
                 "--goal-bias", "--iterations",  "--radius", "--patience", "--seconds", "--seed",
                 "--bound",     "--certificate", "--layers", "--tree"},
                "paths between two places: leave --home out");
}

cli::Exit HomeOption::plan(const Run& run) {
  cli::VehicleOptions vehicle = run.vehicle;
  WaysPlanner::Options options = settled(autopilot_, vehicle);
  options.vmax = vmax_;
  options.quality = run.quality.value_or(plan::Quality::fast);
  cli::Scenes scenes(
      cli::open_map(run.map, geom::Verified::extents, run.common.execution("verify")), vehicle,
      cli::Scenes::Differences::stricter_allowed);
  cli::InputFile drawn(sites_);
  options.source = drawn.name();
  options.sites =
      traj::read_sites(drawn.stream(), drawn.name(), scenes.map().spec().frame, {local_});
  WaysPlanner planner(scenes, run.metres, std::move(options));
  cli::InputFile file(flights_);
  geom::RecordLines lines(file.stream(), file.name());
  HomeOutput out(run);
  const auto next = [&]() -> std::optional<Item> {
    while (auto line = lines.next()) {
      if (run.sharding.shard().takes(out.next())) return Item{*std::move(line)};
    }
    return std::nullopt;
  };
  const auto work = [&](Item& item) {
    item.answer = planner.answer(item.line.text, file.name(), item.line.number);
    item.line.text = {};
  };
  geom::in_order<Item>(run.common.execution("flights"), kHeld, next, work,
                       [&](Item& item) { out.add(item.answer); });
  return out.commit(vmax_);
}

}  // namespace planning
