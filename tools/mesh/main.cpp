// skyway-mesh: models of triangles become box maps.

#include <fmt/format.h>

#include <cmath>

#include "cli/file/files.h"
#include "cli/option/format_options.h"
#include "cli/option/map_output.h"
#include "cli/option/numbers_option.h"
#include "cli/option/output_option.h"
#include "cli/option/skipped_option.h"
#include "cli/option/units.h"
#include "cli/run.h"
#include "cli/tell.h"
#include "geom/base/error.h"
#include "geom/model/model_polygons.h"
#include "geom/model/read_model.h"
#include "geom/text/counted.h"

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
  double slack = 0.25;                        // metres
  bool solid = false;
  std::string up;
  std::string units;
  std::optional<geom::GeodeticOrigin> origin;
  cli::SkippedOption skipped;
  cli::MapOptions map;

  void add_to(CLI::App& app);
};

void Options::add_to(CLI::App& app) {
  app.add_option("file", input,
                 "OBJ, PLY, STL, glTF (.gltf, .glb), COLLADA, 3DS, or the tileset.json of 3D Tiles")
      ->required();
  cli::add_output(app, "-o,--output", output, "box map to write (default: stdout)");
  cli::add_format(app, geom::model_formats(), format);
  app.add_option("--slack", slack,
                 "how far boxes may reach outside triangles and solid, metres (default 0.25)")
      ->check(CLI::Range(0.001, 100.0));
  app.add_flag("--solid", solid, "fill what closed surfaces enclose (default: their shell alone)");
  app.add_option("--up", up, "the file's axis that is up (default: what it says, else z)")
      ->check(CLI::IsMember({"y", "z"}));
  app.add_option("--units", units, "unit of the file's numbers (default: what it says, else m)")
      ->check(CLI::IsMember(cli::kMetres));
  app.add_option_function<std::string>(
         "--origin",
         [this](const std::string& text) {
           auto v = cli::parse_numbers(text, 3);
           if (!v && (v = cli::parse_numbers(text, 2))) v->push_back(0);
           if (!v || std::abs((*v)[0]) > 90 || std::abs((*v)[1]) > 180) {
             throw cli::UsageError(
                 "--origin: expected LATITUDE,LONGITUDE in degrees, and a height in metres where "
                 "it is known, found \"" +
                 text + '"');
           }
           origin = geom::GeodeticOrigin{(*v)[0], (*v)[1], (*v)[2]};
         },
         "where on Earth the map's (0, 0, 0) is, x east and y north of it: degrees, and metres "
         "above the ellipsoid (default 0)")
      ->type_name("LAT,LON[,HEIGHT]");
  skipped.add_to(app);
  map.add_to(app);
}

// What the model's coordinates are in the map.
struct Place {
  geom::Frame frame;
  double unit = 1;  // metres
  double off = 0;   // metres that the map's triangles may be beside the model's flat ones
};

Place earth_place(geom::ModelSource& source, const Options& options, const std::string& name) {
  const geom::PlacedModel placed = geom::place_on_map(source.model, options.origin, name);
  return {placed.frame, 1, placed.bend + 2 * source.model.blur};
}

// Local coordinates, by what the file and the options say.
Place local_place(geom::ModelSource& source, const Options& options, const std::string& name,
                  const cli::Common& common) {
  geom::Model& model = source.model;
  Place place;
  place.frame.origin = options.origin;
  place.unit = options.units.empty() ? model.unit.value_or(1) : cli::kMetres.at(options.units);
  place.off = model.blur * place.unit * options.map.map.scale;
  const bool y_up = options.up.empty() ? model.up == geom::UpAxis::y : options.up == "y";
  if (y_up) {
    for (geom::Vec3& v : model.mesh.vertices) v = geom::z_up_of_y_up(v);
  }
  std::string assumed;
  if (options.up.empty() && !model.up) assumed = "z is up (--up y says otherwise)";
  if (options.units.empty() && !model.unit) {
    assumed += std::string(assumed.empty() ? "" : ", and ") +
               "its numbers are metres (--units says otherwise)";
  }
  if (!assumed.empty()) {
    cli::tell(common, kTool, name + ": the file does not say so, and it is taken that " + assumed);
  }
  if (source.tiles) {
    cli::tell(common, kTool, name + ": the tiles are not on Earth: x is taken as east, y as north");
  }
  return place;
}

// Boxes in the units of the model.
geom::TriangleCover covered(const geom::Model& model, const Options& options, const Place& place,
                            double scale, const std::string& name, const cli::Common& common) {
  geom::TriangleCoverOptions cover;
  cover.fill = options.solid ? geom::SolidFill::inside : geom::SolidFill::none;
  // A vertex may be off by so much along each axis, and boxes grow by as much: so far over a
  // corner.
  const double grown = 2 * 1.7321 * place.off;
  cover.slack = (options.slack - grown) / scale;
  if (grown > options.slack / 2) {
    throw geom::InputError(
        name, {.says = fmt::format("its triangles are known to {:.3g} m only, once they are "
                                   "projected on a map and rounded",
                                   place.off),
               .advice = fmt::format("give a slack of at least {:.3g} m", 2.01 * grown)});
  }
  geom::TriangleCover made;
  try {
    made = geom::cover_model(model, cover, common.execution("triangles"));
  } catch (const geom::InputError& error) {
    throw geom::InputError(name, error.as_item());
  }
  if (place.off > 0) {
    const geom::Vec3 by = geom::Vec3::Constant(place.off / scale);
    for (geom::Aabb& box : made.boxes) box = geom::grow(box, by);
  }
  return made;
}

geom::BoxTable table_of(geom::TriangleCover made, const std::vector<std::string>& parts) {
  geom::BoxTable table;
  std::vector<std::uint32_t> label;
  for (const std::string& part : parts) label.push_back(table.label_of(part));
  table.boxes = std::move(made.boxes);
  for (const std::uint32_t part : made.part) {
    table.ids.push_back(part + 1u);
    table.label.push_back(label.at(part));
  }
  return table;
}

nlohmann::ordered_json stats_of(const geom::ModelSource& source, const geom::TriangleCover& made,
                                bool solid) {
  nlohmann::ordered_json stats = {{"format", source.format->format->word},
                                  {"files", source.files},
                                  {"triangles", source.model.mesh.triangles.size()},
                                  {"parts", source.model.parts.size()}};
  if (source.tiles) {
    stats["tiles_read"] = *source.tiles;
    stats["coarser_contents"] = source.coarser;
  }
  if (source.model.bent > 0) stats["bent_polygons"] = source.model.bent;
  if (solid) {
    stats["closed_surfaces"] = made.closed;
    stats["open_surfaces"] = made.open;
  }
  if (!source.model.skipped.empty()) stats["skipped"] = source.model.skipped.count();
  return stats;
}

void report(const geom::ModelSource& source, const geom::TriangleCover& made,
            const Options& options, const std::string& name, const cli::Common& common) {
  std::string line = geom::counted(source.model.mesh.triangles.size(), "triangle", "triangles");
  if (source.tiles) {
    line += " of " + geom::counted(*source.tiles, "tile", "tiles");
    if (source.coarser > 0) line += fmt::format(", {} coarser ones left out", source.coarser);
  }
  line += ", " + geom::counted(made.boxes.size(), "box", "boxes");
  if (source.model.bent > 0) {
    line += fmt::format("; {} bent, and solid between the ways to cut {} into triangles",
                        geom::counted(source.model.bent, "polygon is", "polygons are"),
                        source.model.bent == 1 ? "it" : "them");
  }
  if (options.solid) {
    line += fmt::format("; filled: {}", geom::counted(made.closed, "surface", "surfaces"));
    if (made.open > 0) line += fmt::format("; not closed, a shell only: {}", made.open);
  }
  cli::tell(common, kTool, name + ": " + line);
}

nlohmann::ordered_json step_of(const geom::ModelSource& source, const Options& options,
                               const Place& place, const geom::MakeMapOptions& map) {
  nlohmann::ordered_json step = {{"tool", kTool},
                                 {"input", source.hash},
                                 {"format", source.format->format->word},
                                 {"slack", options.slack},
                                 {"solid", options.solid}};
  if (place.unit != 1) step["units_m"] = place.unit;
  if (!options.up.empty()) step["up"] = options.up;
  if (options.origin) {
    step["origin"] = {options.origin->latitude, options.origin->longitude, options.origin->height};
  }
  step.update(cli::history_of(map));
  return step;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Convert a model of triangles to a box map.", kTool};
  cli::Common common(app, true);
  Options options;
  options.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    if (options.input == "-") throw cli::UsageError("models are read from a file, not from stdin");
    const std::string& name = options.input;
    geom::ModelSource source =
        geom::read_model(options.input, options.format,
                         [](const std::string& path) { return cli::InputFile(path).read_all(); });
    const std::string word(source.format->format->word);
    const std::string format = word + (source.on_earth ? " on Earth" : "");
    cli::require_used(app, format_options(), format, cli::read_as(name, format));
    const bool none = source.model.mesh.triangles.empty();
    if (none) {
      const std::string skipped = source.model.skipped.text();
      throw geom::InputError(
          name, {.expected = "triangles", .found = "none", .advice = source.model.skipped.text()});
    }
    const Place place = source.on_earth ? earth_place(source, options, name)
                                        : local_place(source, options, name, common);
    geom::MakeMapOptions map = options.map.make();
    nlohmann::ordered_json step = step_of(source, options, place, map);
    options.skipped.settle(source.model.skipped, name, common, step);
    map.scale *= place.unit;
    geom::TriangleCover made = covered(source.model, options, place, map.scale, name, common);
    const nlohmann::ordered_json stats = stats_of(source, made, options.solid);
    report(source, made, options, name, common);
    const geom::MadeMap box_map =
        geom::make_map(table_of(std::move(made), source.model.parts), place.frame,
                       nlohmann::ordered_json::array({step}).dump(), name, map);
    cli::write_map(common, options.output, box_map, name, stats);
    return cli::Exit::yes;
  });
}
