#include "spacing_options.h"

#include <fmt/format.h>

#include <optional>
#include <string>

#include "cli/answer/exit.h"
#include "cli/option/numbers_option.h"

namespace cli {
namespace {

// Two or three numbers above 0, into `zone`.
CLI::Option* add_zone(CLI::App& app, const std::string& flag, std::size_t count,
                      const std::string& form, std::optional<traj::Zone>& zone,
                      const std::string& description) {
  return app
      .add_option_function<std::string>(
          flag,
          [&zone, flag, count, form](const std::string& text) {
            const auto v = parse_numbers(text, count);
            if (!v) {
              throw UsageError(
                  fmt::format("{}: expected {} in metres, found \"{}\"", flag, form, text));
            }
            zone = count == 2 ? traj::cylinder((*v)[0], (*v)[1])
                              : traj::Zone{false, {(*v)[0], (*v)[1], (*v)[2]}};
            if (const auto fault = traj::spacing_fault(*zone)) {
              throw UsageError(flag + ": " + sentence(*fault));
            }
          },
          description)
      ->type_name(form);
}

}  // namespace

void add_spacing(CLI::App& app, traj::Spacing& spacing, traj::Parked& parked) {
  CLI::Option* const separation =
      add_zone(app, "--separation", 2, "H,V", spacing.zone,
               "two flights conflict within H metres across and V in height, of reference points "
               "(default: where their boxes with margins touch)");
  add_zone(app, "--separation-box", 3, "X,Y,Z", spacing.zone,
           "the same as a box: within X, Y and Z metres along the axes")
      ->excludes(separation);
  add_zone(app, "--downwash", 2, "R,M", spacing.downwash,
           "also within R metres across and M below: a cylinder of air that a vehicle pushes down");
  app.add_option_function<std::string>(
         "--parked",
         [&parked](const std::string& word) {
           parked = geom::value_of(traj::kParkedWords, word).value_or(traj::Parked::pad);
         },
         "before its departure and after its arrival a flight stands on its pad, or is gone "
         "(default pad)")
      ->check(CLI::IsMember({"pad", "gone"}));
}

}  // namespace cli
