// skyway-footprints: building footprints, city models and height models become box maps.

#include <fmt/format.h>

#include <filesystem>

#include "cli/file/hashed_input.h"
#include "cli/option/format_options.h"
#include "cli/option/map_output.h"
#include "cli/option/numbers_option.h"
#include "cli/option/output_option.h"
#include "cli/option/skipped_option.h"
#include "cli/option/units.h"
#include "cli/run.h"
#include "cli/shard/map_shard.h"
#include "cli/tell.h"
#include "geom/base/error.h"
#include "geom/gis/place_footprints.h"
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
  return {{"--height-attribute", buildings},
          {"--storey", buildings},
          {"--default-height", buildings},
          {"--where", words({&kVector})},
          {"--height-step", words({&kRaster})},
          {"--height-units", unlike_osm, "--terrain"},
          {"--axes", words({&kCityJson, &kCityGml})},
          {"--metres", unlike_osm}};
}

struct Options {
  std::string input;
  std::string output = "-";
  const geom::gis::FootprintFormat* format = nullptr;  // null: found out
  geom::gis::ReadOptions read;
  double slack = 0.5;  // metres
  std::string terrain;
  std::string origin;
  std::string height_units;
  std::string axes;
  bool metres = false;
  CLI::Option* default_height = nullptr;
  cli::SkippedOption skipped;
  cli::MapOptions map;

  void add_to(CLI::App& app);
  std::optional<geom::Vec2> place() const;  // latitude, longitude of the origin, where given
};

void Options::add_to(CLI::App& app) {
  app.add_option(
         "file", input,
         "GeoJSON, GeoPackage, Shapefile, FlatGeobuf, OSM .pbf, CityJSON, CityGML or a GeoTIFF "
         "of heights")
      ->required();
  cli::add_output(app, "-o,--output", output, "box map to write (default: stdout)");
  cli::add_format(app, geom::gis::footprint_formats(), format);
  app.add_option("--slack", slack,
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
  app.add_option("--where", read.where, "only features for which this OGR SQL is true");
  app.add_option("--height-step", read.height_step,
                 "round the cells of a height model up to multiples of this, metres (default 0.5)")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option("--terrain", terrain, "GeoTIFF of the ground that footprints stand on");
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
  app.add_flag("--metres", metres,
               "numbers without a coordinate reference system are metres even if they look like "
               "degrees");
  skipped.add_to(app);
  map.add_to(app);
}

std::optional<geom::Vec2> Options::place() const {
  if (origin.empty()) return std::nullopt;
  const auto numbers = cli::parse_numbers(origin, 2);
  if (!numbers || std::abs((*numbers)[0]) > 90 || std::abs((*numbers)[1]) > 180) {
    throw cli::UsageError("--origin must be LATITUDE,LONGITUDE in degrees, found \"" + origin +
                          "\"");
  }
  return geom::Vec2((*numbers)[0], (*numbers)[1]);
}

std::string hash_of(const std::string& path) {
  cli::InputFile file(path);
  return cli::HashedInput(file).hash();
}

// By their names alone, which are the same in any folder.
nlohmann::ordered_json hashes_of(const std::vector<std::string>& paths) {
  nlohmann::ordered_json out;
  for (const std::string& path : paths) {
    out[std::filesystem::path(path).filename().string()] = hash_of(path);
  }
  return out;
}

nlohmann::ordered_json step_of(const std::string& hash, const Options& options,
                               const geom::gis::Source& source, const geom::MakeMapOptions& map) {
  nlohmann::ordered_json step = {{"tool", "skyway-footprints"},
                                 {"input", hash},
                                 {"format", options.format->format->word},
                                 {"slack", options.slack},
                                 {"storey", options.read.height.storey},
                                 {"default_height", options.read.height.default_height}};
  if (!source.beside.empty()) step["beside"] = hashes_of(source.beside);
  if (!options.terrain.empty()) step["terrain"] = hash_of(options.terrain);
  if (options.read.height_unit) step["height_units_m"] = *options.read.height_unit;
  step.update(cli::history_of(map));
  return step;
}

// What was read, in numbers; warns of what is worth knowing.
nlohmann::ordered_json counts_of(const geom::gis::Source& source, const Options& options,
                                 const std::string& name, const cli::Common& common) {
  nlohmann::ordered_json counts = {{"format", options.format->format->word},
                                   {"footprints", source.footprints.size()}};
  std::string report;
  for (const auto& [what, n] : source.counts) {
    counts[what] = n;
    report += fmt::format("; {}: {}", what, n);
  }
  if (!report.empty()) {
    cli::tell(common, "skyway-footprints",
              fmt::format("{}: footprints: {}{}", name, source.footprints.size(), report));
  }
  for (const std::string& warning : source.warnings) common.warn(name + ": " + warning);
  if (!source.defaults.empty()) {
    common.warn(fmt::format("{}: {} m is taken where nothing tells the height: {}", name,
                            options.read.height.default_height, source.defaults.text()));
  }
  if (!source.skipped.empty()) counts["skipped"] = source.skipped.count();
  return counts;
}

// A source in the coordinates of the map.
struct City {
  geom::gis::Source source;
  geom::Frame frame;
};

// The shard's part of the source, on the ground where there is a terrain.
City city_of(geom::gis::Source source, const Options& options,
             const std::optional<geom::Vec2>& origin, const std::string& name,
             const cli::Sharding& sharding) {
  if (options.metres && !source.crs.empty()) {
    throw cli::UsageError(
        fmt::format("--metres is for numbers without a coordinate reference "
                    "system, and {} names one: leave it out",
                    name));
  }
  const geom::gis::Projector projector(source, name, origin, options.metres);
  const geom::MakeMapOptions map = options.map.make();
  std::optional<double> floor = map.floor;
  if (map.bounds) floor = map.bounds->min.z();
  if (floor) *floor /= map.scale;
  geom::gis::sink_ground(source.footprints, floor);
  if (sharding.asked()) geom::gis::keep_shard(source.footprints, sharding.shard());
  geom::gis::project(source, projector, options.slack);
  if (!options.terrain.empty()) {
    const geom::gis::Terrain terrain(options.terrain, options.terrain, options.read);
    geom::gis::lift(source, terrain, projector.frame().crs);
  }
  geom::gis::check_sizes(source, options.slack, name);
  for (const geom::Footprint& f : source.footprints) {
    if (geom::uneven_by(f, options.slack) > options.slack / 2) ++source.counts["surfaces_uneven"];
  }
  return {std::move(source), projector.frame()};
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Convert building footprints, city models and height models to a box map.",
               "skyway-footprints"};
  cli::Common common(app, true);
  Options options;
  options.add_to(app);
  cli::Sharding sharding;
  sharding.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    const std::optional<geom::Vec2> origin = options.place();
    options.read.origin = origin;
    options.read.slack = options.slack;
    if (!options.height_units.empty()) {
      options.read.height_unit = cli::kMetres.at(options.height_units);
    }
    if (!options.axes.empty())
      options.read.axes =
          options.axes == "east-north" ? geom::gis::Axes::east_north : geom::gis::Axes::north_east;
    if (options.input == "-")
      throw cli::UsageError("footprints are read from a file, not from stdin");
    sharding.begin(app, {{"file", options.input}, {"terrain", options.terrain}},
                   {{"output", options.output}});
    if (const auto done = sharding.finished(common)) return *done;
    cli::InputFile file(options.input);
    cli::HashedInput hashed(file);
    if (hashed.head().empty()) throw geom::InputError(file.name(), {.says = "the file is empty"});
    if (!options.format) {
      options.format = &geom::gis::footprint_format_of(hashed.head(), options.input);
    }
    const std::string_view word = options.format->format->word;
    cli::require_used(app, format_options(), word, cli::read_as(file.name(), word));
    const City city =
        city_of(geom::gis::read(*options.format, {options.input, file.name(), hashed.stream()},
                                options.read),
                options, origin, file.name(), sharding);
    const geom::MakeMapOptions map = options.map.make();
    nlohmann::ordered_json stats = counts_of(city.source, options, file.name(), common);
    nlohmann::ordered_json step = step_of(hashed.hash(), options, city.source, map);
    options.skipped.settle(city.source.skipped, file.name(), common, step);
    if (options.default_height->count() == 0) {
      geom::gis::require_heights(city.source, file.name());
    }
    const std::string history = nlohmann::ordered_json::array({step}).dump();
    geom::BoxTable table =
        geom::boxes_of(city.source.footprints, options.slack, common.execution("footprints"));
    if (sharding.asked()) {
      cli::write_shard(sharding, options.output, table, {city.frame, history, map});
      common.write_stats(std::move(stats));
      return cli::Exit::yes;
    }
    const geom::MadeMap made =
        geom::make_map(std::move(table), city.frame, history, file.name(), map);
    cli::write_map(common, options.output, made, file.name(), stats);
    return cli::Exit::yes;
  });
}
