// Footprints, city models and height models as box maps: a module of its own, as it needs GDAL.

#include "cli/file/files.h"
#include "geom/gis/draft_footprints.h"
#include "pybind_draft.h"
#include "pybind_keywords.h"

namespace binding {
namespace {

geom::gis::ReadOptions read_options(const Keywords& given) {
  geom::gis::ReadOptions read;
  read.slack = given.number("slack", 0.01, 100);
  read.height.attribute = given.text("height_attribute");
  read.height.storey = given.number("storey", 1, 20);
  if (const auto height = given.optional_number("default_height", 0.1, 2000)) {
    read.height.default_height = *height;
  }
  read.types = given.texts("types");
  if (given.word("label_by", {"type", "object"}) == "object") {
    read.label_by = geom::gis::LabelBy::object;
  }
  read.where = given.text("where");
  read.height_step = given.number("height_step", 0, 100);
  read.height_unit = given.unit("height_units");
  const std::string axes = given.word("axes", {"east-north", "north-east"});
  if (axes == "east-north") read.axes = geom::gis::Axes::east_north;
  if (axes == "north-east") read.axes = geom::gis::Axes::north_east;
  if (const auto at = given.origin("origin")) read.origin = {at->latitude, at->longitude};
  return read;
}

py::tuple import_footprints(const std::string& path, const py::dict& keywords) {
  const Keywords given(keywords);
  geom::gis::FootprintDraftOptions options;
  options.format = given.format(geom::gis::footprint_formats());
  options.read = read_options(given);
  options.default_height_chosen = given.optional_number("default_height", 0.1, 2000).has_value();
  options.terrain = given.text("terrain");
  options.metres = given.flag("metres");
  options.allow_skipped = given.flag("allow_skipped");
  options.map = given.map();
  options.open = cli::open_input;
  const geom::Execution run = on_threads(given.count("threads", 0, 1024));
  return made([&](const geom::Notes& notes) {
    return geom::gis::draft_footprints(path, options, notes, run);
  });
}

}  // namespace
}  // namespace binding

PYBIND11_MODULE(_skyway_gis, module) {
  module.def("import_footprints", &binding::import_footprints, binding::py::arg("path"),
             binding::py::arg("keywords"));
}
