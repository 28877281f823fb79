#include "together.h"

#include <fmt/format.h>

#include "cli/option/option_check.h"
#include "cli/option/spacing_options.h"
#include "cli/run.h"
#include "geom/base/error.h"
#include "geom/record/agreed_room.h"
#include "traj/proof/domain.h"
#include "traj/together/flights_hash.h"

namespace checking {

void Together::add_to(CLI::App& app) {
  app.add_flag("--together", asked_,
               "check the trajectories against one another, too, for all time");
  cli::add_spacing(app, task_.rule.spacing, task_.rule.parked);
  moving_.add_to(app, "prove each trajectory clear of each at every instant, too");
}

void Together::refuse_idle(const CLI::App& app, bool drone_file) const {
  for (const char* option : cli::kSpacingOptions) {
    const bool parked = std::string_view(option) == "--parked";
    cli::only_for(app, parked ? collects() : asked_, {option},
                  parked ? "--together or --moving" : "--together");
  }
  if (collects() && drone_file) {
    throw cli::UsageError(
        fmt::format("{} takes trajectories as JSON Lines, which say when each begins: "
                    "skyway-import-trajectory makes them of drone files",
                    name()));
  }
}

void Together::require_room(const traj::TimedFlight& flight, const std::string& source,
                            std::size_t line) const {
  if (!asked_ || task_.rule.spacing.zone || flight.room.minCoeff() > 0) return;
  throw geom::InputError(
      source, line,
      {.expected = "a vehicle with a size along each axis, as the distance follows from that",
       .found = "none",
       .advice = "give --separation"});
}

void Together::add(const traj::TrajectoryRecord& record, const geom::CollisionScene* scene,
                   const std::string& source, std::size_t line) {
  if (!collects()) return;
  if (!ids_.insert(record.id).second) {
    throw geom::InputError(
        source, line,
        {.expected = "each id once", .found = fmt::format("\"{}\" again", record.id)});
  }
  if (!any_) task_.epoch = record.time.epoch;
  geom::require_epoch_agrees(record.time.epoch, task_.epoch, source, line);
  any_ = true;
  if (!scene || traj::outside_domain(record.trajectory, {})) {
    ++left_out_;
    return;
  }
  if (moving_.asked() && !record.time.start) {
    throw geom::InputError(
        source, line,
        {.expected = fmt::format("\"start\" of \"{}\", seconds after the epoch", record.id),
         .found = "none",
         .advice = "where obstacles move, a verdict holds for one departure alone"});
  }
  task_.map = scene->map().hash();
  task_.overridden =
      task_.overridden ||
      geom::smaller_than_asked({scene->vehicle(), scene->margin()}, record.provenance);
  traj::TimedFlight flight{nullptr, record.time.starts(), scene->half()};
  require_room(flight, source, line);
  flight.trajectory = &trajectories_.emplace_back(record.trajectory);
  flights_.push_back(flight);
  task_.ids.push_back(record.id);
}

void Together::refuse_path(const std::string& id, const std::string& source,
                           std::size_t line) const {
  throw geom::InputError(source, line,
                         {.expected = fmt::format("a trajectory, as {} needs times", name()),
                          .found = fmt::format("the path \"{}\"", id),
                          .advice = "skyway-traj makes one of it"});
}

void Together::drop(std::vector<std::string> ids) {
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

traj::TogetherResult Together::check(bool exact, const geom::Execution& run) {
  task_.rule.exact = exact;
  task_.flights_hash = traj::flights_hash(task_.ids, flights_, task_.epoch);
  return traj::check_together(flights_, task_.rule, run);
}

}  // namespace checking
