#include "home.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>

#include "cli/batch.h"
#include "cli/file/files.h"
#include "cli/option/option_check.h"
#include "cli/option/scenes.h"
#include "cli/shard/record_output.h"
#include "geom/base/in_order.h"
#include "geom/text/json_fields.h"
#include "geom/text/record_lines.h"
#include "traj/home/contingency_record.h"
#include "traj/home/home_flight.h"
#include "traj/home/ways_home.h"

namespace planning {
namespace {

constexpr std::size_t kHeld = 64;  // flights at a time

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

// Ways home for flights of any vehicle over one map.
class WaysPlanner {
 public:
  struct Options {
    std::vector<traj::DrawnSite> sites;
    std::string source;  // of these
    std::vector<traj::ReturnModel> models;
    std::optional<double> vmax;
    plan::Quality quality = plan::Quality::fast;
  };

  WaysPlanner(cli::Scenes& scenes, const cli::MetresOption& metres, Options options)
      : scenes_(scenes), metres_(metres), options_(std::move(options)) {}

  struct Answer {
    traj::HomeFlight flight;
    traj::WaysHome home = {};
    bool complete = false;
    std::vector<traj::ContingencyRecord> records = {};
  };

  // Threads may call at once.
  Answer answer(const std::string& text, const std::string& source, std::size_t line) {
    Answer out{traj::read_home_flight(geom::JsonFields(text, source, line), options_.vmax)};
    if (out.flight.stages.empty()) {
      traj::ContingencyRecord& record = out.records.emplace_back();
      record.id = out.flight.id;
      record.message = out.flight.without;
      record.provenance = out.flight.provenance;
      return out;
    }
    const auto base = base_for(out.flight.provenance, source, line);
    metres_.check_input(scenes_.map().spec().frame, out.flight.places(), source, line);
    out.home = traj::ways_home(*base->scene, out.flight.stages, base->task);
    out.complete = traj::complete(out.home, base->task);
    out.records = traj::contingency_records(out.flight.id, out.home, base->task,
                                            geom::provenance_of(*base->scene));
    return out;
  }

 private:
  // What all flights of one vehicle and margin share.
  struct Base {
    std::shared_ptr<const geom::CollisionScene> scene;
    std::unique_ptr<plan::Planner> planner;
    traj::WaysTask task;
  };

  // The margin is at least what autopilots stray.
  std::shared_ptr<const Base> base_for(geom::Provenance provenance, const std::string& source,
                                       std::size_t line) {
    provenance.margin =
        std::max(provenance.margin.value_or(0), traj::least_margin(options_.models));
    const auto scene = scenes_.shared_scene_for(provenance, source, line);
    const std::lock_guard lock(mutex_);
    auto& base = bases_[scene.get()];
    if (!base) base = made(scene);
    return base;
  }

  std::shared_ptr<const Base> made(std::shared_ptr<const geom::CollisionScene> scene) const {
    auto out = std::make_shared<Base>();
    out->planner = std::make_unique<plan::Planner>(*scene);
    out->task.models = options_.models;
    if (scenes_.profile()) out->task.energy = scenes_.profile()->energy;
    for (const traj::DrawnSite& site : options_.sites) {
      out->task.sites.push_back(traj::landing_site(*scene, site, options_.source));
    }
    plan::PlanOptions search;
    search.quality = options_.quality;
    out->task.plan = [planner = out->planner.get(), search](
                         const geom::Vec3& from,
                         const traj::LandingSite& site) -> std::optional<geom::Polyline> {
      plan::PlanResult result = planner->plan(from, site.above, search);
      if (result.status != geom::PathStatus::found) return std::nullopt;
      return std::move(result.path);
    };
    out->scene = std::move(scene);
    return out;
  }

  cli::Scenes& scenes_;
  const cli::MetresOption& metres_;
  Options options_;
  std::mutex mutex_;  // guards what follows
  std::map<const geom::CollisionScene*, std::shared_ptr<const Base>> bases_;
};

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
  autopilot_.settle(vehicle.profile());
  WaysPlanner::Options options;
  options.models = traj::return_models(autopilot_.flier);
  if (vehicle.margin) {
    vehicle.margin = std::max(*vehicle.margin, traj::least_margin(options.models));
  }
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
  cli::RecordOutput out(run.output, "output", run.sharding);
  geom::RecordLines lines(file.stream(), file.name());
  std::size_t total = 0;
  Totals totals;
  cli::Batch batch;
  bool all = true;
  const auto next = [&]() -> std::optional<Item> {
    while (auto line = lines.next()) {
      if (run.sharding.shard().takes(total++)) return Item{*std::move(line)};
    }
    return std::nullopt;
  };
  const auto work = [&](Item& item) {
    item.answer = planner.answer(item.line.text, file.name(), item.line.number);
    item.line.text = {};
  };
  const auto take = [&](Item& item) {
    const WaysPlanner::Answer& answer = item.answer;
    ++totals.flights;
    totals.add(answer.home);
    for (const auto& record : answer.records) out.add(traj::to_json_line(record));
    out.flush();
    all = all && answer.complete;
    answer.complete ? batch.add_good() : batch.add_failed(reason(answer), sentence(answer));
  };
  geom::in_order<Item>(run.common.execution("flights"), kHeld, next, work, take);
  const cli::Exit exit = all ? cli::Exit::yes : cli::Exit::no;
  out.commit(total, exit);
  run.common.write_stats(totals.stats());
  batch.tell(run.common, "skyway-plan", "flights have no way home at some times");
  return exit;
}

}  // namespace planning
