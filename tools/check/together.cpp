#include "together.h"

#include <fmt/format.h>

#include "cli/option/option_check.h"
#include "cli/option/spacing_options.h"
#include "cli/run.h"
#include "geom/base/error.h"

namespace checking {

void Together::add_to(CLI::App& app) {
  app.add_flag("--together", asked_,
               "check the trajectories against one another, too, for all time");
  cli::add_spacing(app, rule_.spacing, rule_.parked);
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

void Together::add(traj::TrajectoryRecord record, const std::optional<traj::FlightRoom>& room,
                   const std::string& source, std::size_t line) {
  if (!set_) set_.emplace(rule_, traj::FlightSet::Needs{asked_, moving_.asked()});
  set_->add(std::move(record), room, source, line);
}

void Together::refuse_path(const std::string& id, const std::string& source,
                           std::size_t line) const {
  throw geom::InputError(source, line,
                         {.expected = fmt::format("a trajectory, as {} needs times", name()),
                          .found = fmt::format("the path \"{}\"", id),
                          .advice = "skyway-traj makes one of it"});
}

}  // namespace checking
