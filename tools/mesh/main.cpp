// skyway-mesh: models of triangles become box maps.

#include "cli/file/files.h"
#include "cli/option/format_options.h"
#include "cli/option/map_output.h"
#include "cli/option/origin_option.h"
#include "cli/option/output_option.h"
#include "cli/option/units.h"
#include "cli/run.h"
#include "cli/tell.h"
#include "geom/model/draft_model.h"

namespace {

constexpr const char* kTool = "skyway-mesh";

// COLLADA, and 3D Tiles on Earth, say their own axes and units.
std::vector<cli::FormatOption> format_options() {
  std::vector<std::string_view> words = geom::words_of(geom::model_formats());
  std::erase(words, geom::kColladaModel.format->word);
  return {{"--up", words}, {"--units", words}};
}

struct Options {
  std::string input;
  std::string output = "-";
  const geom::ModelFormat* format = nullptr;  // null: found out
  std::string up;
  std::string units;
  geom::ModelDraftOptions draft;

  void add_to(CLI::App& app);
  void settle();  // once parsed; throws cli::UsageError
};

void Options::add_to(CLI::App& app) {
  app.add_option("file", input,
                 "OBJ, PLY, STL, glTF (.gltf, .glb), COLLADA, 3DS, or the tileset.json of 3D Tiles")
      ->required();
  cli::add_output(app, "-o,--output", output, "box map to write (default: stdout)");
  cli::add_format(app, geom::model_formats(), format);
  app.add_option("--slack", draft.slack,
                 "how far boxes may reach outside triangles and solid, metres (default 0.25)")
      ->check(CLI::Range(0.001, 100.0));
  app.add_flag("--solid", draft.solid,
               "fill what closed surfaces enclose (default: their shell alone)");
  app.add_option("--up", up, "the file's axis that is up (default: what it says, else z)")
      ->check(CLI::IsMember({"y", "z"}));
  app.add_option("--units", units, "unit of the file's numbers (default: what it says, else m)")
      ->check(CLI::IsMember(cli::kMetres));
  app.add_option_function<std::string>(
         "--origin", [this](const std::string& text) { draft.origin = cli::origin_from(text); },
         "where on Earth the map's (0, 0, 0) is, x east and y north of it: degrees, and metres "
         "above the ellipsoid (default 0)")
      ->type_name(cli::kOriginForm);
  cli::add_allow_skipped(app, draft.allow_skipped);
  cli::add_map_options(app, draft.map);
}

void Options::settle() {
  if (!up.empty()) draft.up = up == "y" ? geom::UpAxis::y : geom::UpAxis::z;
  if (!units.empty()) draft.unit = cli::kMetres.at(units);
  if (input == "-") throw cli::UsageError("models are read from a file, not from stdin");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Convert a model of triangles to a box map.", kTool};
  cli::Common common(app, true);
  Options options;
  options.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    options.settle();
    const std::string& name = options.input;
    geom::ModelSource source =
        geom::read_model(options.input, options.format,
                         [](const std::string& path) { return cli::InputFile(path).read_all(); });
    const std::string word(source.format->format->word);
    const std::string format = word + (source.on_earth ? " on Earth" : "");
    cli::require_used(app, format_options(), format, cli::read_as(name, format));
    cli::write_map(common, options.output,
                   geom::draft_model(std::move(source), name, options.draft,
                                     cli::notes_of(common, kTool), common.execution("triangles")));
    return cli::Exit::yes;
  });
}
