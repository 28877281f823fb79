#include "together.h"

#include <fmt/format.h>

#include "cli/option/numbers_option.h"
#include "cli/option/option_check.h"
#include "cli/run.h"
#include "geom/base/error.h"
#include "traj/proof/domain.h"

namespace checking {
namespace {

// Two or three numbers above 0, into `zone`.
CLI::Option* add_zone(CLI::App& app, const std::string& flag, std::size_t count,
                      const std::string& form, std::optional<traj::Zone>& zone,
                      const std::string& description) {
  return app
      .add_option_function<std::string>(
          flag,
          [&zone, flag, count, form](const std::string& text) {
            const auto v = cli::parse_numbers(text, count);
            if (!v) {
              throw CLI::ValidationError(
                  flag, fmt::format("expected {} in metres, found \"{}\"", form, text));
            }
            zone = count == 2 ? traj::cylinder((*v)[0], (*v)[1])
                              : traj::Zone{false, {(*v)[0], (*v)[1], (*v)[2]}};
            if (const auto fault = traj::spacing_fault(*zone)) {
              throw CLI::ValidationError(flag, *fault);
            }
          },
          description)
      ->type_name(form);
}

}  // namespace

void Together::add_to(CLI::App& app) {
  app.add_flag("--together", asked_,
               "check the trajectories against one another, too, for all time");
  CLI::Option* const separation =
      add_zone(app, "--separation", 2, "H,V", task_.rule.spacing.zone,
               "two flights conflict within H metres across and V in height, of reference points "
               "(default: where their boxes with margins touch)");
  add_zone(app, "--separation-box", 3, "X,Y,Z", task_.rule.spacing.zone,
           "the same as a box: within X, Y and Z metres along the axes")
      ->excludes(separation);
  add_zone(app, "--downwash", 2, "R,M", task_.rule.spacing.downwash,
           "also within R metres across and M below: a cylinder of air that a vehicle pushes down");
  app.add_option_function<std::string>(
         "--parked",
         [this](const std::string& word) {
           task_.rule.parked = geom::value_of(traj::kParkedWords, word).value_or(traj::Parked::pad);
         },
         "before its departure and after its arrival a flight stands on its pad, or is gone "
         "(default pad)")
      ->check(CLI::IsMember({"pad", "gone"}));
}

void Together::refuse_idle(const CLI::App& app, bool drone_file) const {
  cli::only_for(app, asked_, {"--separation", "--separation-box", "--downwash", "--parked"},
                "--together");
  if (asked_ && drone_file) {
    throw cli::UsageError(
        "--together takes trajectories as JSON Lines, which say when each begins: "
        "skyway-import-trajectory makes them of drone files");
  }
}

void Together::require_room(const traj::TimedFlight& flight, const std::string& source,
                            std::size_t line) const {
  if (task_.rule.spacing.zone || flight.room.minCoeff() > 0) return;
  throw geom::InputError(source, line,
                         "expected a vehicle with a size along each axis, as the distance follows "
                         "from that, found none: give --separation");
}

void Together::add(const traj::TrajectoryRecord& record, const geom::CollisionScene* scene,
                   const std::string& source, std::size_t line) {
  if (!asked_) return;
  if (!ids_.insert(record.id).second) {
    throw geom::InputError(source, line,
                           fmt::format("expected each id once, found \"{}\" again", record.id));
  }
  if (!any_) task_.epoch = record.time.epoch;
  geom::require_epoch_agrees(record.time.epoch, task_.epoch, source, line);
  any_ = true;
  if (!scene || traj::outside_domain(record.trajectory, {})) {
    ++left_out_;
    return;
  }
  task_.map = scene->map().hash();
  traj::TimedFlight flight{nullptr, record.time.starts(), scene->half()};
  require_room(flight, source, line);
  flight.trajectory = &trajectories_.emplace_back(record.trajectory);
  flights_.push_back(flight);
  task_.ids.push_back(record.id);
}

void Together::refuse_path(const std::string& id, const std::string& source,
                           std::size_t line) const {
  throw geom::InputError(
      source, line,
      fmt::format("expected a trajectory, as --together needs times, found the path \"{}\": "
                  "skyway-traj makes one of it",
                  id));
}

traj::TogetherResult Together::check(bool exact, const geom::Execution& run) {
  task_.rule.exact = exact;
  return traj::check_together(flights_, task_.rule, run);
}

}  // namespace checking
