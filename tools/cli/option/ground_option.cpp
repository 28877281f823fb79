#include "ground_option.h"

#include "geom/base/usage_error.h"
#include "numbers_option.h"
#include "option_check.h"

namespace cli {

geom::GroundModel ground_from(const std::string& word) {
  if (const auto z = parse_numbers(word, 1)) return geom::GroundModel::flat((*z)[0]);
  return geom::read_ground(word);
}

geom::GroundBand band_from(const std::string& agl) {
  const auto both = parse_numbers(agl, 2);
  if (!both || (*both)[0] >= (*both)[1]) {
    throw geom::UsageError("--agl: expected LOW,HIGH, metres above the ground, found \"" + agl +
                           '"');
  }
  return {.low = (*both)[0], .high = (*both)[1]};
}

void note_ground(const geom::GroundModel& ground, const std::string& word, geom::MapPatch& patch) {
  geom::require_same_frame(ground, patch.spec().frame, word);
  if (ground.is_flat()) {
    patch.note("ground", {{"flat", ground.range({}).low}});
  } else {
    patch.note("ground", {{"file", ground.spec().source},
                          {"hash", ground.spec().hash},
                          {"error", ground.spec().error},
                          {"cell", ground.spec().cell}});
  }
}

std::size_t close_band(const geom::GroundBand& band, const geom::GroundModel& ground,
                       const std::string& word, geom::MapPatch& patch) {
  const std::size_t boxes =
      patch.add("ground_band", geom::ground_band_boxes(band, ground, patch.spec(), word));
  if (band.low) patch.note("agl_low", *band.low);
  if (band.high) patch.note("agl_high", *band.high);
  return boxes;
}

void AglOption::add_to(CLI::App& app) {
  app.add_option("--ground-model", ground_, kGroundHelp);
  app.add_option("--agl", agl_,
                 "keep between these heights above the ground, metres: LOW,HIGH; the map is then "
                 "the one that skyway-map patch --agl makes");
}

void AglOption::refuse_idle(const CLI::App& app) const {
  only_for(app, !agl_.empty(), {"--ground-model"}, "--agl");
  if (!agl_.empty() && ground_.empty()) {
    throw geom::UsageError("--agl counts from the ground: give --ground-model");
  }
}

geom::BoxMap AglOption::applied(const geom::BoxMap& map, const std::string& name) const {
  if (agl_.empty()) return map;
  map.require(geom::Verified::contents);
  const geom::GroundModel ground = ground_from(ground_);
  geom::require_same_zero(ground, map, ground_);
  geom::MapPatch patch(map, name);
  note_ground(ground, ground_, patch);
  patch.note_cut_to_bounds();
  close_band(band_from(agl_), ground, ground_, patch);
  return patch.made();
}

}  // namespace cli
