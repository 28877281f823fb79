// Tables, block texts, worlds, voxels and octrees as box maps.

#include "cli/file/files.h"
#include "geom/import/draft_boxes.h"
#include "pybind_draft.h"
#include "pybind_keywords.h"
#ifdef SKYWAY_MESH
#include "geom/model/assimp_scene.h"
#endif

namespace binding {
namespace {

py::tuple import_boxes(const std::string& path, const py::dict& keywords) {
  const Keywords given(keywords);
  geom::BoxDraftOptions options;
  options.format = given.format(geom::box_formats());
  if (const std::string frame = given.word("frame", {"enu", "neu"}); !frame.empty()) {
    options.axes = *geom::value_of(geom::kAxesWords, frame);
  }
  options.unit = given.unit("units").value_or(1);
  options.unknown_blocked = given.word("unknown", {"free", "blocked"}) == "blocked";
  options.slack = given.number("slack", 0.001, 100);
  options.visuals = !given.flag("collisions_only");
  options.without = given.texts("without");
  options.model_path = given.texts("model_path");
  options.allow_skipped = given.flag("allow_skipped");
  options.map = given.map();
  options.open = cli::open_input;
#ifdef SKYWAY_MESH
  options.read_collada = [](const geom::SdfFile& file) {
    return geom::read_collada(file.text, file.name);
  };
#endif
  return made([&](const geom::Notes& notes) {
    return geom::draft_boxes(path, options, notes, cli::all_cores());
  });
}

}  // namespace

void bind_import_boxes(py::module_& module) {
  module.def("import_boxes", &import_boxes, py::arg("path"), py::arg("keywords"));
}

}  // namespace binding
