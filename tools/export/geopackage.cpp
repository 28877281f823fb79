#include "geopackage.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/file/files.h"
#include "cli/file/made_elsewhere.h"
#include "geom/base/text_stream.h"
#include "geom/record/volume4d.h"
#include "geom/text/counted.h"
#include "geom/text/parse_json.h"
#ifdef SKYWAY_FOOTPRINTS
#include "geom/gis/geopackage.h"
#endif

namespace exporting {

#ifdef SKYWAY_FOOTPRINTS
namespace {

using geom::gis::GeoRow;
using geom::gis::GeoTable;

constexpr const char* kWritten = "what was written";

// The one line of a GeoJSON text, with its note, which an unchecked one has.
GeoRow row_of(const std::string& id, const std::string& text) {
  const nlohmann::json json = geom::parse_json(text, kWritten);
  const nlohmann::json& feature = json.contains("features") ? json["features"].at(0) : json;
  GeoRow out{.id = id, .note = feature.at("properties").value("note", "")};
  for (const nlohmann::json& p : feature.at("geometry").at("coordinates")) {
    out.places.push_back({p.at(1).get<double>(), p.at(0).get<double>(), p.at(2).get<double>()});
  }
  return out;
}

GeoTable volumes_table() {
  return {.name = "volumes",
          .polygons = true,
          .numbers = {"lower_m", "upper_m"},
          .texts = {"begins", "ends"}};
}

// At their lower altitudes.
void add_volumes(const std::string& id, const std::string& text, GeoTable& table) {
  geom::TextInput in(text);
  for (const geom::Volume4d& volume : geom::read_volumes_4d(in, kWritten)) {
    GeoRow row{.id = id, .places = volume.outline.ring};
    for (geom::GeodeticPlace& p : row.places) p.height = *volume.lower;
    row.numbers = {*volume.lower, *volume.upper};
    row.texts = {*volume.start, *volume.end};
    table.rows.push_back(std::move(row));
  }
}

bool has_times(const Flight& flight) {
  return flight.way.path.empty() && flight.way.time.start && flight.way.time.epoch;
}

}  // namespace

cli::Exit export_geopackage(const cli::Common& common, const Options& options, Exporter& exporter,
                            std::span<const Flight> flights) {
  Options volume_options = options;
  volume_options.word = traj::kVolume4d.format.word;
  std::optional<Exporter> volumes_exporter;
  std::vector<GeoTable> tables{
      {.name = "trajectories", .numbers = {"duration_s"}}, {.name = "paths"}, volumes_table()};
  std::size_t refused = 0;
  std::size_t without_volumes = 0;
  for (const Flight& flight : flights) {
    const auto made = exporter.make(flight);
    refused += !made;
    if (!made) continue;
    const bool path = !flight.way.path.empty();
    GeoRow row = row_of(flight.way.id, made->text);
    if (!path) row.numbers = {traj::duration(flight.way.trajectory)};
    tables[path ? 1 : 0].rows.push_back(std::move(row));
    if (!has_times(flight)) continue;
    without_volumes += options.unchecked;
    if (options.unchecked) continue;
    if (!volumes_exporter) volumes_exporter.emplace(common, volume_options);
    const auto volumes = volumes_exporter->make(flight);
    refused += !volumes;
    if (volumes) add_volumes(flight.way.id, volumes->text, tables[2]);
  }
  if (refused > 0) {
    cli::complain("skyway-export", fmt::format("{} refused: no file was written", refused));
    return cli::Exit::no;
  }
  if (without_volumes > 0) {
    cli::complain("skyway-export", fmt::format("{} without volumes, because nothing was checked",
                                               geom::counted(without_volumes, "flight")));
  }
  std::erase_if(tables, [](const GeoTable& one) { return one.rows.empty(); });
  cli::OutputFile out(options.output, cli::OutputKind::artefact);
  out.stream() << cli::made_elsewhere(
      ".gpkg", [&](const std::string& path) { geom::gis::write_geopackage(path, tables); });
  out.commit();
  return cli::Exit::yes;
}

#else

cli::Exit export_geopackage(const cli::Common&, const Options&, Exporter&,
                            std::span<const Flight>) {
  throw std::runtime_error(
      "--format gpkg needs GDAL, and this build of Skyway is without it (SKYWAY_FOOTPRINTS)");
}

#endif

}  // namespace exporting
