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
bool same_length(double a, double b) { return std::abs(a - b) <= 5e-7 * b; }

std::string short_name(const geom::CoordinateReference& told) { return told.name.substr(0, 80); }

[[noreturn]] void contradiction(const std::string& source, const geom::CoordinateReference& told,
                                double metres, const char* option, const std::string& units) {
  throw geom::InputError(
      source, fmt::format("its reference system \"{}\" says that a unit is {} m, but {} says {}: "
                          "leave the option out, or correct the file",
                          short_name(told), metres, option, units));
}

// Of two that both say it, the file's own; they must not differ.
std::optional<double> agreed(std::optional<double> file, std::optional<double> proj,
                             const geom::CoordinateReference& told, const std::string& source) {
  if (file && proj && !same_length(*file, *proj)) {
    throw geom::InputError(
        source, fmt::format("the file says that a unit is {} m, but in \"{}\", which it names, it "
                            "is {} m: say which system it is with --crs",
                            *file, short_name(told), *proj));
  }
  return file ? file : proj;
}

[[noreturn]] void no_metres(const std::string& source, const geom::CoordinateReference& told) {
  throw geom::InputError(
      source, fmt::format("its coordinates are not metres on the ground: \"{}\" uses degrees, or "
                          "metres whose length changes with the place; bring them to metres about "
                          "a place with --origin LATITUDE,LONGITUDE, or --origin auto",
                          short_name(told)));
}

// Further away the plane about the origin means nothing any more.
void require_near(const geom::Vec3& p, const geom::GeodeticOrigin& origin,
                  const std::string& source) {
  constexpr double kFar = 1e6;  // metres
  if (p.head<2>().cwiseAbs().maxCoeff() <= kFar) return;
  throw geom::InputError(
      source, fmt::format("a point is {:.0f} km from the origin {},{}: give the latitude first, "
                          "then the longitude, and a place near the cloud, or --origin auto",
                          p.head<2>().norm() / 1000, origin.latitude, origin.longitude));
}

}  // namespace

void Placement::add_to(CLI::App& app) {
  app.add_option("--crs", crs_,
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
      ->type_name("LAT,LON[,HEIGHT]|auto");
}

void Placement::parse_origin(const std::string& text) {
  origin_near_points_ = text == "auto";
  if (origin_near_points_) return;
  auto v = cli::parse_numbers(text, 3);
  if (!v && (v = cli::parse_numbers(text, 2))) v->push_back(0);
  if (!v || std::abs((*v)[0]) > 90 || std::abs((*v)[1]) > 180) {
    throw CLI::ValidationError(
        "--origin",
        "expected LATITUDE,LONGITUDE in degrees, and a height in metres where it is known, or "
        "auto; found \"" +
            text + '"');
  }
  origin_ = geom::GeodeticOrigin{(*v)[0], (*v)[1], (*v)[2]};
}

// What the file says, and what PROJ adds to it; --crs instead of both.
geom::CoordinateReference Placement::understood(const geom::CoordinateReference& file,
                                                const std::string& source) {
  replaced_.clear();
  reference_.reset();
  if (!crs_.empty()) {
    reference_ = ProjReference::of(crs_);
    if (!reference_ || reference_->told().kind == Kind::not_known) {
      throw cli::UsageError(
          "--crs must be a reference system that PROJ knows, as EPSG:25832 is; "
          "found \"" +
          crs_.substr(0, 80) + '"');
    }
    if (file.kind != Kind::none) replaced_ = short_name(file);
    return reference_->told();
  }
  if (file.crs.empty()) return file;
  reference_ = ProjReference::of(file.crs);
  if (!reference_) return file;
  const geom::CoordinateReference& known = reference_->told();
  geom::CoordinateReference out = file;
  if (file.kind == Kind::not_known || known.kind == Kind::no_plane) out.kind = known.kind;
  out.plane = agreed(file.plane, known.plane, known, source);
  out.up = agreed(file.up, known.up, known, source);
  out.up_unclear = !out.up && (file.up_unclear || known.up_unclear);
  return out;
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
  if (told.kind == Kind::no_plane) return 1;  // that of heights, where nothing says another
  throw geom::InputError(
      source,
      fmt::format("the file names the reference system \"{}\" without the length of its units: "
                  "give --units m, ft or us-ft, or name it with --crs",
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

void Placement::settle(const geom::CoordinateReference& file, const std::string& source) {
  source_ = source;
  const geom::CoordinateReference told = understood(file, source);
  const bool asked = origin_ || origin_near_points_;
  projects_ = asked && !told.crs.empty();
  if (told.kind == Kind::no_plane && !projects_) no_metres(source, told);
  plane_ = told.kind != Kind::no_plane;
  const double plane = plane_unit(told, source);
  metres_ = {plane, plane, upward_unit(told, plane, source)};
  up_assumed_ = !told.up && vertical_units_.empty() && told.kind != Kind::none;
  told_by_ = told.kind == Kind::none ? "" : short_name(told);
  settle_frame(told, source);
}

void Placement::settle_frame(const geom::CoordinateReference& told, const std::string& source) {
  frame_ = {};
  way_.reset();
  if (projects_) {
    if (!reference_) {
      throw geom::InputError(
          source,
          fmt::format("PROJ does not understand its reference system \"{}\", so it cannot be "
                      "brought to the origin: name the system with --crs",
                      short_name(told)));
    }
    if (origin_) lead_to(*origin_);
    return;
  }
  if (origin_near_points_) {
    throw geom::InputError(source,
                           "its coordinates have no reference system that says where on Earth they "
                           "are: name it with --crs, or give --origin LATITUDE,LONGITUDE of "
                           "(0, 0, 0)");
  }
  frame_.crs = told.crs;
  if (!told.crs.empty() && metres_ != geom::Vec3::Ones()) frame_.crs = "in metres: " + told.crs;
  frame_.origin = origin_;
}

void Placement::lead_to(const geom::GeodeticOrigin& origin) {
  origin_ = origin;
  way_ = way_to_plane(*reference_, origin, source_);
  frame_.origin = origin;
  frame_.crs = plane_about(origin);
}

std::optional<geom::Aabb> Placement::in_file(const geom::Aabb& region) const {
  if (way_) return way_->origin_of(region);
  if (projects_) return std::nullopt;
  const geom::Vec3 more = 1e-9 * (region.min.cwiseAbs() + region.max.cwiseAbs());
  return geom::Aabb{(region.min - more).cwiseQuotient(metres_),
                    (region.max + more).cwiseQuotient(metres_)};
}

std::optional<double> Placement::metres_in_file() const {
  return plane_ ? std::optional(metres_.x()) : std::nullopt;
}

void Placement::place(std::span<geom::CloudPoint> points) {
  if (points.empty()) return;
  if (!projects_) {
    if (metres_ == geom::Vec3::Ones()) return;
    for (geom::CloudPoint& p : points) p.position = p.position.cwiseProduct(metres_);
    return;
  }
  if (!way_) lead_to(origin_near(*reference_, points.front().position, source_));
  way_->project(points);
  for (geom::CloudPoint& p : points) {
    require_near(p.position, *origin_, source_);
    p.position.z() = p.position.z() * metres_.z() - origin_->height;
  }
}

void Placement::record(nlohmann::ordered_json& step) const {
  if (!crs_.empty()) step["crs"] = crs_;
  if (projects_) step["projected_from"] = reference_->told().crs;
  if (metres_.x() != 1) step["units_m"] = metres_.x();
  if (metres_.z() != 1) step["vertical_units_m"] = metres_.z();
  if (origin_) step["origin"] = {origin_->latitude, origin_->longitude, origin_->height};
}

std::string Placement::report() const {
  std::string out;
  const auto add = [&](const std::string& text) { out += (out.empty() ? "" : "; ") + text; };
  if (!replaced_.empty()) add(fmt::format("--crs stands in place of \"{}\"", replaced_));
  const std::string by = told_by_.empty() ? "" : fmt::format(", as \"{}\" says", told_by_);
  if (projects_ && origin_) {
    add(fmt::format("brought from \"{}\" to metres about {},{}", told_by_, origin_->latitude,
                    origin_->longitude));
    if (metres_.z() != 1) add(fmt::format("heights from units of {} m", metres_.z()));
  } else if (metres_.x() != 1 && metres_.x() == metres_.z()) {
    add(fmt::format("converted to metres from units of {} m{}", metres_.x(), by));
  } else if (metres_ != geom::Vec3::Ones()) {
    add(fmt::format("converted to metres from units of {} m, heights from units of {} m{}",
                    metres_.x(), metres_.z(), by));
  }
  if (up_assumed_ && metres_.z() != 1) {
    add("nothing says the unit of heights, and that of x and y is taken (--vertical-units says "
        "otherwise)");
  }
  return out;
}

}  // namespace cloud
