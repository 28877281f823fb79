#include "skipped_option.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "geom/text/counted.h"
#include "geom/text/parse_json.h"

namespace cli {

void SkippedOption::add_to(CLI::App& app) {
  app.add_flag("--allow-skipped", allowed_,
               "leave out what is or may be an obstacle and cannot be built; the map's history "
               "says how many");
}

void SkippedOption::settle(const geom::Skipped& skipped, const std::string& source,
                           const Common& common, nlohmann::ordered_json& step) const {
  if (skipped.empty()) return;
  if (!allowed_) {
    throw geom::InputError(
        source,
        {.says = fmt::format("{} cannot be built: {}; correct the file, or leave out what cannot "
                             "be built with --allow-skipped",
                             geom::counted(skipped.count(), "possible obstacle"), skipped.text())});
  }
  common.warn(
      fmt::format("{}: {} left out: {}", source,
                  geom::counted(skipped.count(), "possible obstacle is", "possible obstacles are"),
                  skipped.text()));
  step["skipped"] = skipped.count();
}

std::size_t skipped_in(const geom::BoxMapSpec& spec) {
  std::size_t count = 0;
  if (spec.history.empty()) return count;
  const nlohmann::json steps = geom::parse_json(spec.history, "the map's history");
  for (const nlohmann::json& step : steps) {
    if (!step.is_object()) continue;
    const auto skipped = step.find("skipped");
    if (skipped != step.end() && skipped->is_number_unsigned()) {
      count += skipped->get<std::size_t>();
    }
  }
  return count;
}

}  // namespace cli
