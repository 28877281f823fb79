// skyway-footprints: building footprints, city models and height models become box maps.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/file/files.h"
#include "cli/option/format_options.h"
#include "cli/option/map_output.h"
#include "cli/option/numbers_option.h"
#include "cli/option/option_check.h"
#include "cli/option/origin_option.h"
#include "cli/option/output_option.h"
#include "cli/option/units.h"
#include "cli/run.h"
#include "cli/tell.h"
#include "geom/base/error.h"
#include "geom/gis/draft_footprints.h"
#include "geom/gis/ground_of_map.h"
#include "geom/gis/read_footprints.h"

namespace {

std::vector<cli::FormatOption> format_options() {
  using geom::gis::kCityGml, geom::gis::kCityJson, geom::gis::kOsm, geom::gis::kRaster,
      geom::gis::kVector;
  const auto words = [](std::vector<const geom::gis::FootprintFormat*> formats) {
    return geom::words_of<geom::gis::FootprintFormat>(formats);
  };
  const auto buildings = words({&kVector, &kOsm, &kCityJson, &kCityGml});
  const auto unlike_osm = words({&kVector, &kCityJson, &kCityGml, &kRaster});
  return {{"--types", words({&kOsm, &kCityJson, &kCityGml})},
          {"--label-by", words({&kOsm, &kCityJson, &kCityGml})},
          {"--height-attribute", buildings},
          {"--storey", buildings},
          {"--default-height", buildings},
          {"--where", words({&kVector})},
          {"--height-step", words({&kRaster})},
          {"--height-units", unlike_osm, {"--terrain"}},
          {"--axes", words({&kCityJson, &kCityGml})},
          {"--metres", unlike_osm}};
}

struct Options {
  std::string input;
  std::string output = "-";
  geom::gis::FootprintDraftOptions draft;
  std::string origin;
  std::string height_units;
  std::string label_by;
  std::string axes;
  std::string ground_of;  // a map; empty: a map is made
  double cell = 10;
  double vertical_error = 0;
  CLI::Option* default_height = nullptr;

  void add_to(CLI::App& app);
  void settle();  // once parsed; throws cli::UsageError
};

void Options::add_to(CLI::App& app) {
  geom::gis::ReadOptions& read = draft.read;
  app.add_option(
         "file", input,
         "GeoJSON, GeoPackage, Shapefile, FlatGeobuf, OSM .pbf, CityJSON, CityGML or a GeoTIFF "
         "of heights")
      ->required();
  cli::add_output(app, "-o,--output", output, "box map to write (default: stdout)");
  cli::add_format(app, geom::gis::footprint_formats(), draft.format);
  app.add_option("--slack", read.slack,
                 "how far boxes may reach outside a footprint, metres (default 0.5)")
      ->check(CLI::Range(0.01, 100.0));
  app.add_option("--height-attribute", read.height.attribute,
                 "attribute that holds heights; it is looked at before the usual ones");
  app.add_option("--storey", read.height.storey, "height of a storey, metres (default 3)")
      ->check(CLI::Range(1.0, 20.0));
  default_height =
      app.add_option("--default-height", read.height.default_height,
                     "height of buildings whose height the file does not tell, metres (default 10, "
                     "for at most a tenth of them)");
  default_height->check(CLI::Range(0.1, 2000.0));
  app.add_option("--types", read.types,
                 "of city models and OpenStreetMap data: build only these types, such as "
                 "Building,Bridge or building,tower; what is left out is counted (default: all but "
                 "roads, land use and the like on the ground)")
      ->delimiter(',')
      ->type_name("TYPE,…");
  app.add_option("--label-by", label_by,
                 "label boxes by the type of their object (default), or by its type and its own "
                 "name in the file: type or object")
      ->check(CLI::IsMember({"type", "object"}));
  app.add_option("--where", read.where, "only features for which this OGR SQL is true");
  app.add_option("--height-step", read.height_step,
                 "round the cells of a height model up to multiples of this, metres (default 0.5)")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option("--terrain", draft.terrain, "GeoTIFF of the ground that footprints stand on");
  app.add_option("--origin", origin,
                 "LATITUDE,LONGITUDE of the map's origin (default: the middle)");
  app.add_option("--height-units", height_units,
                 "unit of heights that name none (default: what the coordinate reference system "
                 "says, else m)")
      ->check(CLI::IsMember(cli::kMetres));
  app.add_option("--axes", axes,
                 "which coordinate of a city model comes first (default: what its coordinate "
                 "reference system says)")
      ->check(CLI::IsMember({"east-north", "north-east"}));
  app.add_flag("--metres", draft.metres,
               "numbers without a coordinate reference system are metres even if they look like "
               "degrees");
  cli::add_allow_skipped(app, draft.allow_skipped);
  cli::add_map_options(app, draft.map);
  app.add_option(
      "--ground-of", ground_of,
      "write the ground of this map, from a GeoTIFF of heights, for patch --ground-model");
  app.add_option("--cell", cell, "side of a cell of the ground, metres (default 10)")
      ->check(CLI::Range(0.1, 100.0));
  app.add_option("--vertical-error", vertical_error,
                 "how far the ground may be above or below the GeoTIFF, metres (default 0)")
      ->check(CLI::Range(0.0, 1000.0));
}

// The ground of a map that there is, in place of a map.
void write_ground(const Options& options, const cli::Common& common) {
  const geom::BoxMap map = cli::open_map(options.ground_of, geom::Verified::contents);
  geom::gis::GroundOptions ground{.cell = options.cell, .error = options.vertical_error};
  ground.read = options.draft.read;
  ground.open = cli::open_input;
  const geom::GroundModel model = geom::gis::ground_of_map(options.input, map.spec(), ground);
  const auto holes = static_cast<std::size_t>(std::count_if(
      model.lows().begin(), model.lows().end(), [](double z) { return std::isnan(z); }));
  if (holes > 0) {
    common.warn(fmt::format("{}: it does not know the ground of {} of {} cells of the map",
                            options.input, holes, model.lows().size()));
  }
  cli::OutputFile out(options.output, cli::OutputKind::artefact);
  geom::write_ground(out.stream(), model);
  out.commit();
  common.write_stats({{"cells", model.lows().size()}, {"cells_without_ground", holes}});
}

std::optional<geom::Vec2> place_of(const std::string& origin) {
  if (origin.empty()) return std::nullopt;
  const geom::GeodeticOrigin at = cli::origin_from(origin);
  if (cli::parse_numbers(origin, 3)) {
    throw cli::UsageError("--origin: expected no height, found \"" + origin +
                          "\": heights of footprints are those of the file");
  }
  return geom::Vec2(at.latitude, at.longitude);
}

void Options::settle() {
  draft.read.origin = place_of(origin);
  if (!height_units.empty()) draft.read.height_unit = cli::kMetres.at(height_units);
  if (!label_by.empty()) {
    draft.read.label_by = *geom::value_of(geom::gis::kLabelWords, label_by);
  }
  if (!axes.empty()) {
    draft.read.axes =
        axes == "east-north" ? geom::gis::Axes::east_north : geom::gis::Axes::north_east;
  }
  draft.default_height_chosen = default_height->count() > 0;
  draft.open = cli::open_input;
  if (input == "-") throw cli::UsageError("footprints are read from a file, not from stdin");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Convert building footprints, city models and height models to a box map.",
               "skyway-footprints"};
  cli::Common common(app, true);
  Options options;
  options.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    options.settle();
    cli::only_for(app, !options.ground_of.empty(), {"--cell", "--vertical-error"}, "--ground-of");
    if (!options.ground_of.empty()) {
      write_ground(options, common);
      return cli::Exit::yes;
    }
    cli::InputFile file(options.input);
    geom::HashedStream hashed(file.stream());
    if (hashed.head().empty()) throw geom::InputError(file.name(), {.says = "the file is empty"});
    if (!options.draft.format) {
      options.draft.format = &geom::gis::footprint_format_of(hashed.head(), options.input);
    }
    const std::string_view word = options.draft.format->format->word;
    cli::require_used(app, format_options(), word, cli::read_as(file.name(), word));
    cli::write_map(common, options.output,
                   geom::gis::draft_footprints(options.input, hashed, options.draft,
                                               cli::notes_of(common, "skyway-footprints"),
                                               common.execution("footprints")));
    return cli::Exit::yes;
  });
}
