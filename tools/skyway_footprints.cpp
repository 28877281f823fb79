// skyway-footprints: building footprints, city models and height models become box maps.

#include <fmt/format.h>

#include <fstream>

#include "cli/files.h"
#include "cli/hashed_input.h"
#include "cli/map_output.h"
#include "cli/map_shard.h"
#include "cli/numbers_option.h"
#include "cli/run.h"
#include "footprints/source.h"
#include "geom/error.h"
#include "geom/io/city_json.h"

namespace {

struct Options {
  std::string format = "auto";
  footprints::ReadOptions read;
  double slack = 0.5;
  std::string terrain;
  std::string origin;
  cli::MapOptions map;
};

// Whether a file's text says so; the word may stand at its very end.
bool says(const std::string& path, std::string_view word) {
  cli::InputFile file(path);
  return file.read_all().find(word) != std::string::npos;
}

// CityJSON by what it says, OSM by its name, height models by what GDAL makes of them.
std::string detect(std::string_view head, const std::string& path) {
  for (const char* end : {".pbf", ".osm", ".osm.bz2", ".osm.gz"}) {
    if (path.ends_with(end)) return "osm";
  }
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && head[first] == '{') {
    return says(path, "\"CityJSON\"") ? "cityjson" : "vector";
  }
  return footprints::is_raster(path) ? "raster" : "vector";
}

footprints::Source read_city_json(std::istream& in, const std::string& name) {
  geom::CityJson city = geom::read_city_json(in, name);
  footprints::Source source;
  source.footprints = std::move(city.footprints);
  source.crs = city.crs;
  source.counts["objects"] = city.objects;
  for (const auto& [what, count] : city.skipped) source.counts["skipped_" + what] = count;
  return source;
}

void project(footprints::Source& source, const footprints::Projector& projector) {
  for (geom::Footprint& f : source.footprints) {
    for (geom::Vec2& p : f.polygon.outer) p = projector(p);
    for (auto& hole : f.polygon.holes) {
      for (geom::Vec2& p : hole) p = projector(p);
    }
  }
}

// What geom::cover asks of its numbers, and that it ends: a footprint is cut into slabs no lower
// than the slack.
void check_sizes(const footprints::Source& source, double slack, const std::string& name) {
  constexpr double kMostSlabs = 1e6;
  const double reach = std::min(geom::kLargestCoordinate, 1e9 * slack);
  for (const geom::Footprint& f : source.footprints) {
    geom::Vec2 low = f.polygon.outer.front();
    geom::Vec2 high = low;
    const auto look = [&](const std::vector<geom::Vec2>& ring) {
      for (const geom::Vec2& p : ring) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
    };
    look(f.polygon.outer);
    for (const auto& hole : f.polygon.holes) look(hole);
    const double size = (high - low).maxCoeff();
    if (low.minCoeff() < -reach || high.maxCoeff() > reach || size > kMostSlabs * slack) {
      throw geom::InputError(
          name, fmt::format("feature {}: expected a footprint within {} m of the origin and no "
                            "longer than {} m (1e6 times --slack), found [{}, {}] to [{}, {}]",
                            f.id, reach, kMostSlabs * slack, low.x(), low.y(), high.x(), high.y()));
    }
  }
}

// The shard's features, each with all its footprints.
void keep_shard(std::vector<geom::Footprint>& footprints, const geom::Shard& shard) {
  std::vector<std::size_t> first;  // of each feature
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    if (i == 0 || footprints[i].id != footprints[i - 1].id) first.push_back(i);
  }
  const std::size_t features = first.size();
  first.push_back(footprints.size());
  const auto at = [&](std::size_t feature) {
    return footprints.begin() + static_cast<std::ptrdiff_t>(first[feature]);
  };
  footprints.erase(at(shard.end(features)), footprints.end());
  footprints.erase(footprints.begin(), at(shard.begin(features)));
}

// Footprints stand on the ground: down to its lowest point, and as high above its highest.
void lift(footprints::Source& source, const footprints::Terrain& terrain, const std::string& crs) {
  for (geom::Footprint& f : source.footprints) {
    geom::Vec2 low = f.polygon.outer.front();
    geom::Vec2 high = low;
    for (const geom::Vec2& p : f.polygon.outer) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const auto ground = terrain.range(low, high, crs);
    if (!ground) {
      ++source.counts["footprints_without_terrain"];
      continue;
    }
    f.bottom += ground->low;
    f.top += ground->high;
  }
}

std::string history_of(const std::string& hash, const Options& options,
                       const geom::MakeMapOptions& map) {
  nlohmann::ordered_json step = {{"tool", "skyway-footprints"},
                                 {"input", hash},
                                 {"format", options.format},
                                 {"slack", options.slack},
                                 {"storey", options.read.height.storey},
                                 {"default_height", options.read.height.default_height}};
  step.update(cli::history_of(map));
  return nlohmann::ordered_json::array({step}).dump();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Convert building footprints, city models and height models to a box map.",
               "skyway-footprints"};
  cli::Common common(app, true);
  Options options;
  std::string input;
  std::string output = "-";
  std::optional<std::vector<double>> origin;
  app.add_option("file", input,
                 "GeoJSON, GeoPackage, Shapefile, FlatGeobuf, OSM .pbf, CityJSON or a GeoTIFF of "
                 "heights")
      ->required();
  app.add_option("-o,--output", output, "box map to write (default: stdout)");
  app.add_option("--format", options.format, "what the file is (default: auto)")
      ->check(CLI::IsMember({"auto", "vector", "osm", "cityjson", "raster"}));
  app.add_option("--slack", options.slack,
                 "how far boxes may reach outside a footprint, metres (default 0.5)")
      ->check(CLI::Range(0.01, 100.0));
  app.add_option("--height-attribute", options.read.height.attribute,
                 "attribute that holds heights, before the usual ones");
  app.add_option("--storey", options.read.height.storey, "height of a storey, metres (default 3)")
      ->check(CLI::Range(1.0, 20.0));
  app.add_option("--default-height", options.read.height.default_height,
                 "height of buildings that tell none, metres (default 10)")
      ->check(CLI::Range(0.1, 2000.0));
  app.add_option("--where", options.read.where, "only features for which this OGR SQL is true");
  app.add_option("--height-step", options.read.height_step,
                 "round the cells of a height model up to multiples of this, metres (default 0.5)")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option("--terrain", options.terrain, "GeoTIFF of the ground that footprints stand on");
  app.add_option("--origin", options.origin,
                 "LATITUDE,LONGITUDE of the map's origin (default: the middle)");
  options.map.add_to(app);
  cli::Sharding sharding;
  sharding.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    std::optional<geom::Vec2> at;
    if (!options.origin.empty()) {
      const auto numbers = cli::parse_numbers(options.origin, 2);
      if (!numbers || std::abs((*numbers)[0]) > 90 || std::abs((*numbers)[1]) > 180) {
        throw cli::UsageError("--origin must be LATITUDE,LONGITUDE in degrees, found \"" +
                              options.origin + "\"");
      }
      at = geom::Vec2((*numbers)[0], (*numbers)[1]);
    }
    if (input == "-") throw cli::UsageError("footprints are read from a file, not from stdin");
    sharding.begin(app, {{"file", input}, {"terrain", options.terrain}}, {{"output", output}});
    if (const auto done = sharding.finished(common)) return *done;
    cli::InputFile file(input);
    cli::HashedInput hashed(file);
    if (hashed.head().empty()) throw geom::InputError(file.name(), "the file is empty");
    if (options.format == "auto") options.format = detect(hashed.head(), input);
    footprints::Source source;
    if (options.format == "cityjson") source = read_city_json(hashed.stream(), file.name());
    if (options.format == "osm") source = footprints::read_osm(input, file.name(), options.read);
    if (options.format == "vector")
      source = footprints::read_vector(input, file.name(), options.read);
    if (options.format == "raster")
      source = footprints::read_raster(input, file.name(), options.read);
    if (source.footprints.empty()) {
      throw geom::InputError(file.name(), "expected at least one footprint, found none");
    }
    const footprints::Projector projector(source, file.name(), at);
    if (sharding.asked()) keep_shard(source.footprints, sharding.shard());
    project(source, projector);
    if (!options.terrain.empty()) {
      lift(source, footprints::Terrain(options.terrain, options.terrain), projector.frame().crs);
    }
    check_sizes(source, options.slack, file.name());
    const std::size_t count = source.footprints.size();
    geom::BoxTable table =
        geom::boxes_of(source.footprints, options.slack, common.execution("footprints"));
    geom::MakeMapOptions map = options.map.make();
    const std::string history = history_of(hashed.hash(), options, map);
    nlohmann::ordered_json stats = {{"format", options.format}, {"footprints", count}};
    std::string report;
    for (const auto& [what, n] : source.counts) {
      stats[what] = n;
      report += fmt::format("; {}: {}", what, n);
    }
    if (!report.empty())
      common.warn(fmt::format("{}: footprints: {}{}", file.name(), count, report));
    if (sharding.asked()) {
      cli::write_shard(sharding, output, table, {projector.frame(), history, map});
      common.write_stats(std::move(stats));
      return cli::Exit::yes;
    }
    const geom::MadeMap made =
        geom::make_map(std::move(table), projector.frame(), history, file.name(), map);
    cli::write_map(common, output, made, file.name(), stats);
    return cli::Exit::yes;
  });
}
