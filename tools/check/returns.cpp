#include "returns.h"

#include "cli/option/numbers_option.h"
#include "cli/option/option_check.h"

namespace checking {

void Returns::add_to(CLI::App& app) {
  app.add_option_function<std::vector<std::string>>(
         "--return",
         [this](const std::vector<std::string>& words) {
           asked_ = true;
           if (!words.empty() && !words.front().empty()) action_ = words.front();
         },
         "prove what the autopilot does by itself when its link is lost, from every instant: "
         "rtl or goHome (default): return and land at home or the nearest rally point; land: land "
         "below; hold: stay")
      ->expected(0, 1)
      ->default_str("rtl")
      ->check(CLI::IsMember({"rtl", "goHome", "land", "hold"}))
      ->type_name("ACTION");
  cli::add_point(app, "--home-place", home_,
                 "where it returns to, on the ground (default: a mission's home; else below the "
                 "beginning)");
  app.add_flag("--no-least-height", no_least_height_,
               "do not look for the least height from which every return is proved");
}

void Returns::refuse_idle(const CLI::App& app) const {
  cli::only_for(app, asked_, {"--home-place", "--no-least-height"}, "--return");
}

traj::ReturnRules Returns::rules(const std::optional<double>& height,
                                 const std::optional<double>& speed) const {
  const auto action = action_ == "goHome" ? traj::ReturnAction::rtl
                                          : *geom::value_of(traj::kReturnActionWords, action_);
  return {.action = action,
          .height = height,
          .home = home_,
          .speed = speed,
          .least_height = !no_least_height_};
}

}  // namespace checking
