// Models of triangles as box maps: a module of its own, as it needs assimp and Draco.

#include "cli/file/files.h"
#include "geom/model/draft_model.h"
#include "pybind_draft.h"
#include "pybind_keywords.h"

namespace binding {
namespace {

py::tuple import_model(const std::string& path, const py::dict& keywords) {
  const Keywords given(keywords);
  geom::ModelDraftOptions options;
  options.slack = given.number("slack", 0.001, 100);
  options.solid = given.flag("solid");
  const std::string up = given.word("up", {"y", "z"});
  if (!up.empty()) options.up = up == "y" ? geom::UpAxis::y : geom::UpAxis::z;
  options.unit = given.unit("units");
  options.origin = given.origin("origin");
  options.allow_skipped = given.flag("allow_skipped");
  options.map = given.map();
  const geom::ModelFormat* const format = given.format(geom::model_formats());
  const geom::Execution run = on_threads(given.count("threads", 0, 1024));
  return made([&](const geom::Notes& notes) {
    return geom::draft_model(
        geom::read_model(path, format,
                         [](const std::string& file) { return cli::InputFile(file).read_all(); }),
        path, options, notes, run);
  });
}

}  // namespace
}  // namespace binding

PYBIND11_MODULE(_skyway_mesh, module) {
  module.def("import_model", &binding::import_model, binding::py::arg("path"),
             binding::py::arg("keywords"));
  binding::bind_import_boxes(module);  // with the meshes of COLLADA, which Gazebo worlds name too
}
