// Point clouds as box maps: a module of its own, as it needs PCL and PROJ.

#include <fmt/format.h>

#include <cmath>

#include "cli/answer/exit.h"
#include "geom/cloud/draft_cloud.h"
#include "geom/cloud/las_class.h"
#include "pybind_draft.h"
#include "pybind_keywords.h"

namespace binding {
namespace {

std::optional<geom::CloudPlaceOptions::Unit> unit_of(const Keywords& given, const char* name) {
  const auto metres = given.unit(name);
  if (!metres) return std::nullopt;
  return geom::CloudPlaceOptions::Unit{given.text(name), *metres};
}

geom::CloudPlaceOptions place_of(const Keywords& given, bool near_points) {
  geom::CloudPlaceOptions place;
  place.crs = given.text("crs");
  if (!place.crs.empty() && !geom::knows_reference(place.crs)) {
    throw cli::UsageError(
        "crs: expected a reference system that PROJ knows, as EPSG:25832 is, found \"" +
        place.crs.substr(0, 80) + '"');
  }
  place.plane = unit_of(given, "units");
  place.up = unit_of(given, "vertical_units");
  place.origin_near_points = near_points;
  if (!near_points) place.origin = given.origin("origin");
  return place;
}

std::optional<geom::OutlierRule> outliers_of(const Keywords& given) {
  const std::vector<double> rule = given.numbers("outliers");
  if (rule.empty()) return std::nullopt;
  const bool right = rule.size() == 2 && rule[0] >= 1 && rule[0] <= 1000 &&
                     rule[0] == std::floor(rule[0]) && rule[1] > 0 && std::isfinite(rule[1]);
  if (right) return geom::OutlierRule{static_cast<int>(rule[0]), rule[1]};
  throw cli::UsageError("outliers: expected (neighbours, deviations), as (8, 1.5), found others");
}

std::bitset<256> classes_of(const Keywords& given) {
  std::bitset<256> out;
  for (const std::string& word : given.texts("classes")) {
    const std::bitset<256> named = geom::las_class_set(word);
    if (named.none()) {
      throw cli::UsageError(
          fmt::format("classes: expected numbers from 0 to 255 or names ({}), found \"{}\"",
                      geom::las_class_names(), word));
    }
    out |= named;
  }
  return out;
}

geom::CloudDraftOptions options_of(const Keywords& given, bool near_points) {
  geom::CloudDraftOptions options;
  options.format = given.format(geom::cloud_formats());
  options.place = place_of(given, near_points);
  options.classes = classes_of(given);
  options.drop_noise = given.word("noise_points", {"keep", "drop"}) == "drop";
  options.outliers = outliers_of(given);
  options.voxel = given.optional_number("voxel", 0.001, 1000).value_or(0);
  options.resolution = given.optional_number("resolution", 0.001, 1000).value_or(0);
  options.drop_ground = given.word("ground_points", {"keep", "drop"}) == "drop";
  options.ground_by = given.word("ground_by", {"auto", "class", "shape"});
  options.ground = {.cell = given.number("ground_cell", 0.1, 1000),
                    .slope = given.number("ground_slope", 0, 100),
                    .height = given.number("ground_height", 0, 100),
                    .step = given.number("ground_step", 0, 100),
                    .widest = given.number("ground_widest", 1, 1e6)};
  options.objects = given.word("mode", {"columns", "objects"}) == "objects";
  options.columns = {.cell = given.number("cell", 0.05, 1000),
                     .step = given.number("step", 0.05, 1000),
                     .gap = given.number("gap", 0, 1e6),
                     .unknown_blocked = given.word("unknown", {"free", "blocked"}) == "blocked"};
  options.tolerance = given.number("tolerance", 0.001, 1000);
  options.min_points = given.count("min_points", 1, 1000000000);
  options.allow_skipped = given.flag("allow_skipped");
  options.map = given.map();
  return options;
}

py::tuple import_cloud(const std::string& path, const py::dict& keywords) {
  const Keywords given(keywords);
  const bool near_points = py::isinstance<py::str>(keywords["origin"]) &&
                           keywords["origin"].cast<std::string>() == "auto";
  const geom::CloudDraftOptions options = options_of(given, near_points);
  const geom::Execution run = on_threads(given.count("threads", 0, 1024));
  return made(
      [&](const geom::Notes& notes) { return geom::draft_cloud(path, options, notes, run); });
}

}  // namespace
}  // namespace binding

PYBIND11_MODULE(_skyway_cloud, module) {
  module.def("import_cloud", &binding::import_cloud, binding::py::arg("path"),
             binding::py::arg("keywords"));
}
