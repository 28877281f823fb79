#include "place_options.h"

#include "cli/option/origin_option.h"
#include "cli/option/units.h"
#include "cli/run.h"

namespace cloud {
namespace {

std::optional<geom::CloudPlaceOptions::Unit> unit_of(const std::string& word) {
  if (word.empty()) return std::nullopt;
  return geom::CloudPlaceOptions::Unit{word, cli::kMetres.at(word)};
}

}  // namespace

void PlaceOptions::add_to(CLI::App& app) {
  app.add_option("--crs", options_.crs,
                 "reference system of the file's coordinates, in place of what the file says: "
                 "EPSG:25832, EPSG:2994+6360 (with heights), well-known text")
      ->type_name("CRS");
  app.add_option("--units", units_,
                 "unit of the file's x and y, and of its z unless --vertical-units says another "
                 "(default: what the file says, else m)")
      ->check(CLI::IsMember(cli::kMetres));
  app.add_option("--vertical-units", vertical_units_, "unit of the file's z")
      ->check(CLI::IsMember(cli::kMetres));
  app.add_option_function<std::string>(
         "--origin", [this](const std::string& text) { parse_origin(text); },
         "where on Earth the map's (0, 0, 0) is, x east and y north of it: degrees, and metres of "
         "height (default 0). Coordinates of a reference system are brought there; auto: near the "
         "first point")
      ->type_name(std::string(cli::kOriginForm) + "|auto");
}

void PlaceOptions::parse_origin(const std::string& text) {
  options_.origin_near_points = text == "auto";
  if (options_.origin_near_points) return;
  options_.origin = cli::origin_from(text, "auto");
}

geom::CloudPlaceOptions PlaceOptions::options() const {
  if (!options_.crs.empty() && !geom::knows_reference(options_.crs)) {
    throw cli::UsageError(
        "--crs must be a reference system that PROJ knows, as EPSG:25832 is; found \"" +
        options_.crs.substr(0, 80) + '"');
  }
  geom::CloudPlaceOptions out = options_;
  out.plane = unit_of(units_);
  out.up = unit_of(vertical_units_);
  return out;
}

}  // namespace cloud
