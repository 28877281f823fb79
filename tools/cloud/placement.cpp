#include "placement.h"

#include <fmt/format.h>

#include <cmath>

#include "cli/option/numbers_option.h"
#include "cli/option/units.h"
#include "cli/run.h"
#include "geom/base/error.h"

namespace cloud {
namespace {

using Kind = geom::CoordinateReference::Kind;

// To more digits than differ between the feet of the world.
bool same_length(double a, double b) { return std::abs(a - b) <= 1e-9 * b; }

std::string short_name(const geom::CoordinateReference& told) { return told.name.substr(0, 80); }

[[noreturn]] void contradiction(const std::string& source, const geom::CoordinateReference& told,
                                double metres, const char* option, const std::string& units) {
  throw geom::InputError(
      source, fmt::format("its reference system \"{}\" says that a unit is {} m, but {} says {}: "
                          "leave the option out, or correct the file",
                          short_name(told), metres, option, units));
}

}  // namespace

void Placement::add_to(CLI::App& app) {
  app.add_option("--units", units_,
                 "unit of the file's x and y, and of its z unless --vertical-units says another "
                 "(default: what the file says, else m)")
      ->check(CLI::IsMember(cli::kMetres));
  app.add_option("--vertical-units", vertical_units_, "unit of the file's z")
      ->check(CLI::IsMember(cli::kMetres));
  app.add_option_function<std::string>(
         "--origin",
         [this](const std::string& text) {
           auto v = cli::parse_numbers(text, 3);
           if (!v && (v = cli::parse_numbers(text, 2))) v->push_back(0);
           if (!v || std::abs((*v)[0]) > 90 || std::abs((*v)[1]) > 180) {
             throw CLI::ValidationError(
                 "--origin",
                 "expected LATITUDE,LONGITUDE in degrees, and a height in metres where "
                 "it is known, found \"" +
                     text + '"');
           }
           origin_ = geom::GeodeticOrigin{(*v)[0], (*v)[1], (*v)[2]};
         },
         "where on Earth the cloud's (0, 0, 0) is, x east and y north of it: degrees, and metres "
         "above the ellipsoid (default 0)")
      ->type_name("LAT,LON[,HEIGHT]");
}

double Placement::plane_unit(const geom::CoordinateReference& told,
                             const std::string& source) const {
  if (told.plane) {
    if (!units_.empty() && !same_length(cli::kMetres.at(units_), *told.plane)) {
      contradiction(source, told, *told.plane, "--units", units_);
    }
    return *told.plane;
  }
  if (!units_.empty()) return cli::kMetres.at(units_);
  if (told.kind == Kind::none) return 1;
  throw geom::InputError(
      source,
      fmt::format("the file names the reference system \"{}\" without the length of its units: "
                  "give --units m, ft or us-ft",
                  short_name(told)));
}

double Placement::upward_unit(const geom::CoordinateReference& told, double plane,
                              const std::string& source) const {
  const bool given = !vertical_units_.empty();
  if (told.up) {
    if (given && !same_length(cli::kMetres.at(vertical_units_), *told.up)) {
      contradiction(source, told, *told.up, "--vertical-units", vertical_units_);
    }
    return *told.up;
  }
  if (given) return cli::kMetres.at(vertical_units_);
  if (!told.up_unclear) return plane;
  throw geom::InputError(
      source,
      fmt::format("its heights have a reference system of their own, and \"{}\" does not say in "
                  "which unit: give --vertical-units m, ft or us-ft",
                  short_name(told)));
}

void Placement::settle(const geom::CoordinateReference& told, const std::string& source) {
  if (told.kind == Kind::no_plane) {
    throw geom::InputError(
        source,
        fmt::format(
            "its coordinates are not metres on the ground: \"{}\" uses degrees, or metres "
            "whose length changes with the place; project them first, for example with `pdal "
            "translate in.las out.las reprojection "
            "--filters.reprojection.out_srs=EPSG:32633`",
            short_name(told)));
  }
  const double plane = plane_unit(told, source);
  metres_ = {plane, plane, upward_unit(told, plane, source)};
  const bool metric = metres_ == geom::Vec3::Ones();
  frame_ = {};
  frame_.crs = told.crs;
  if (!told.crs.empty() && !metric) frame_.crs = "in metres: " + told.crs;
  if (origin_ && !told.crs.empty()) {
    throw cli::UsageError(fmt::format(
        "--origin is for coordinates that count from that place, and those of this cloud are of "
        "\"{}\": project the cloud to metres about that place first, for example with "
        "`pdal translate in.las out.las reprojection --filters.reprojection.out_srs=\"+proj=tmerc "
        "+lat_0={} +lon_0={} +k=1 +ellps=WGS84\"`, then write it without a reference system",
        short_name(told), origin_->latitude, origin_->longitude));
  }
  frame_.origin = origin_;
  told_by_ = told.kind == Kind::none ? "" : short_name(told);
}

void Placement::record(nlohmann::ordered_json& step) const {
  if (metres_.x() != 1) step["units_m"] = metres_.x();
  if (metres_.z() != 1) step["vertical_units_m"] = metres_.z();
  if (origin_) step["origin"] = {origin_->latitude, origin_->longitude, origin_->height};
}

std::string Placement::report() const {
  const std::string by = told_by_.empty() ? "" : fmt::format(", as \"{}\" says", told_by_);
  if (metres_ == geom::Vec3::Ones()) return "";
  if (metres_.x() == metres_.z()) {
    return fmt::format("converted to metres from units of {} m{}", metres_.x(), by);
  }
  return fmt::format("converted to metres from units of {} m, heights from units of {} m{}",
                     metres_.x(), metres_.z(), by);
}

}  // namespace cloud
