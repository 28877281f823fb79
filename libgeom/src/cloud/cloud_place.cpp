#include "geom/cloud/cloud_place.h"

#include <fmt/format.h>

#include <cmath>

#include "geom/base/error.h"
#include "geom/earth/proj_way.h"
#include "geom/map/geographic_frame.h"

namespace geom {
namespace {

using Kind = CoordinateReference::Kind;

// To more digits than differ between the feet of the world.
bool same_length(double a, double b) { return std::abs(a - b) <= 5e-7 * b; }

std::string short_name(const CoordinateReference& told) { return told.name.substr(0, 80); }

[[noreturn]] void contradiction(const std::string& source, const CoordinateReference& told,
                                double metres, const char* option, const std::string& units) {
  throw InputError(
      source,
      {.says = fmt::format("its reference system \"{}\" says that a unit is {} m, but {} says {}",
                           short_name(told), metres, option, units),
       .advice = "leave the option out, or correct the file"});
}

// Of two that both say it, the file's own; they must not differ.
std::optional<double> agreed(std::optional<double> file, std::optional<double> proj,
                             const CoordinateReference& told, const std::string& source) {
  if (file && proj && !same_length(*file, *proj)) {
    throw InputError(
        source, {.says = fmt::format(
                     "the file says that a unit is {} m, but in \"{}\", which it names, it is {} m",
                     *file, short_name(told), *proj),
                 .advice = "say which system it is with --crs"});
  }
  return file ? file : proj;
}

[[noreturn]] void no_metres(const std::string& source, const CoordinateReference& told) {
  throw InputError(
      source,
      {.says = fmt::format("its coordinates are not metres on the ground: \"{}\" uses degrees, or "
                           "metres whose length changes with the place; bring them to metres about "
                           "a place with --origin LATITUDE,LONGITUDE, or --origin auto",
                           short_name(told))});
}

[[noreturn]] void no_way(const CoordinateReference& told, const std::string& source) {
  throw InputError(
      source,
      {.says = fmt::format("PROJ knows no way from the reference system \"{}\" to places on Earth",
                           short_name(told)),
       .advice = "say which it is with --crs, for example --crs EPSG:25832"});
}

void convert(std::span<CloudPoint> points, const ProjWay& way, const CoordinateReference& told,
             const std::string& source) {
  const Vec3 first = points.front().position;
  way.forward(&points[0].position.x(), points.size(), sizeof(CloudPoint));
  for (const CloudPoint& p : points) {
    if (p.position.allFinite()) continue;
    throw InputError(
        source,
        {.says = fmt::format("PROJ cannot tell where on Earth a point is: it, or one read with it, "
                             "is near ({}, {}) of \"{}\"; is that the right reference system?",
                             first.x(), first.y(), short_name(told))});
  }
}

// To 1e-3 degrees.
GeodeticOrigin origin_near(CloudPoint point, const ProjReference& reference,
                           const std::string& source) {
  const auto way = ProjWay::to_places(reference);
  if (!way) no_way(reference.told(), source);
  convert({&point, 1}, *way, reference.told(), source);
  return tidy_origin(point.position.head<2>(), 1e3);
}

// Further away the plane about the origin means nothing any more.
void require_near(const Vec3& p, const GeodeticOrigin& origin, const std::string& source) {
  constexpr double kFar = 1e6;  // metres
  if (p.head<2>().cwiseAbs().maxCoeff() <= kFar) return;
  throw InputError(
      source, {.says = fmt::format("a point is {:.0f} km from the origin {},{}",
                                   p.head<2>().norm() / 1000, origin.latitude, origin.longitude),
               .advice = "give the latitude first, then the longitude, and a place near the cloud, "
                         "or --origin auto"});
}

}  // namespace

bool knows_reference(const std::string& text) {
  const auto reference = ProjReference::of(text);
  return reference && reference->told().kind != Kind::not_known;
}

// What the file says, and what PROJ adds to it; --crs instead of both.
CoordinateReference CloudPlace::understood(const CoordinateReference& file,
                                           const std::string& source) {
  replaced_.clear();
  reference_.reset();
  if (!options_.crs.empty()) {
    reference_ = ProjReference::of(options_.crs);
    if (!reference_ || reference_->told().kind == Kind::not_known) {
      throw InputError(source, {.says = fmt::format("PROJ knows no reference system \"{}\"",
                                                    options_.crs.substr(0, 80))});
    }
    if (file.kind != Kind::none) replaced_ = short_name(file);
    return reference_->told();
  }
  if (file.crs.empty()) return file;
  reference_ = ProjReference::of(file.crs);
  if (!reference_) return file;
  const CoordinateReference& known = reference_->told();
  CoordinateReference out = file;
  if (file.kind == Kind::not_known || known.kind == Kind::no_plane) out.kind = known.kind;
  out.plane = agreed(file.plane, known.plane, known, source);
  out.up = agreed(file.up, known.up, known, source);
  out.up_unclear = !out.up && (file.up_unclear || known.up_unclear);
  out.depths = known.depths;
  return out;
}

double CloudPlace::plane_unit(const CoordinateReference& told, const std::string& source) const {
  if (told.plane) {
    if (options_.plane && !same_length(options_.plane->metres, *told.plane)) {
      contradiction(source, told, *told.plane, "--units", options_.plane->word);
    }
    return *told.plane;
  }
  if (options_.plane) return options_.plane->metres;
  if (told.kind == Kind::none) return 1;
  if (told.kind == Kind::no_plane) return 1;  // that of heights, where nothing says another
  throw InputError(
      source, {.says = fmt::format(
                   "the file names the reference system \"{}\" without the length of its units",
                   short_name(told)),
               .advice = "give --units m, ft or us-ft, or name it with --crs"});
}

double CloudPlace::upward_unit(const CoordinateReference& told, double plane,
                               const std::string& source) const {
  if (told.up) {
    if (options_.up && !same_length(options_.up->metres, *told.up)) {
      contradiction(source, told, *told.up, "--vertical-units", options_.up->word);
    }
    return *told.up;
  }
  if (options_.up) return options_.up->metres;
  if (!told.up_unclear) return plane;
  throw InputError(source, {.says = fmt::format("its heights have a reference system of their own, "
                                                "and \"{}\" does not say in which unit",
                                                short_name(told)),
                            .advice = "give --vertical-units m, ft or us-ft"});
}

// Local coordinates may count from anywhere; those of a reference system may not.
void CloudPlace::require_whole(const CoordinateReference& file, const std::string& source) const {
  if (file.moved.empty() || (options_.crs.empty() && (!file.scaled || options_.plane))) return;
  throw InputError(
      source,
      {.expected = file.scaled ? "coordinates that are not scaled, or --units"
                               : "coordinates that are not shifted, beside --crs",
       .found = fmt::format("a comment that says how they are: \"{}\"", file.moved),
       .advice = "write the file with its whole coordinates, in double precision; take the comment "
                 "away if they are whole"});
}

void CloudPlace::settle(const CoordinateReference& file, const std::string& source) {
  source_ = source;
  moved_ = file.moved;
  require_whole(file, source);
  const CoordinateReference told = understood(file, source);
  const bool asked = origin_ || options_.origin_near_points;
  projects_ = asked && !told.crs.empty();
  if (told.depths) {
    throw InputError(source, {.expected = "heights that count upwards",
                              .found = fmt::format("depths, as \"{}\" says", short_name(told)),
                              .advice = "turn their sign and name a system of heights, or say with "
                                        "--crs which it is if that name is wrong"});
  }
  if (told.kind == Kind::no_plane && !projects_) no_metres(source, told);
  plane_ = told.kind != Kind::no_plane;
  const double plane = plane_unit(told, source);
  metres_ = {plane, plane, upward_unit(told, plane, source)};
  up_assumed_ = !told.up && !options_.up && told.kind != Kind::none;
  told_by_ = told.kind == Kind::none ? "" : short_name(told);
  settle_frame(told, source);
}

void CloudPlace::settle_frame(const CoordinateReference& told, const std::string& source) {
  frame_ = {};
  way_.reset();
  if (projects_) {
    if (!reference_) {
      throw InputError(source, {.says = fmt::format("PROJ does not understand its reference system "
                                                    "\"{}\", so it cannot be brought to the origin",
                                                    short_name(told)),
                                .advice = "name the system with --crs"});
    }
    if (origin_) lead_to(*origin_);
    return;
  }
  if (options_.origin_near_points) {
    throw InputError(
        source,
        {.says = "its coordinates have no reference system that says where on Earth they are",
         .advice = "name it with --crs, or give --origin LATITUDE,LONGITUDE of (0, 0, 0)"});
  }
  frame_.crs = told.crs;
  if (!told.crs.empty() && metres_ != Vec3::Ones()) frame_.crs = "in metres: " + told.crs;
  frame_.origin = origin_;
}

void CloudPlace::lead_to(const GeodeticOrigin& origin) {
  origin_ = origin;
  way_ = ProjWay::to_plane(*reference_, origin);
  if (!way_) no_way(reference_->told(), source_);
  frame_.origin = origin;
  frame_.crs = plane_about(origin);
}

std::optional<Aabb> CloudPlace::in_file(const Aabb& region) const {
  if (way_) return way_->origin_of(region);
  if (projects_) return std::nullopt;
  const Vec3 more = 1e-9 * (region.min.cwiseAbs() + region.max.cwiseAbs());
  return Aabb{(region.min - more).cwiseQuotient(metres_),
              (region.max + more).cwiseQuotient(metres_)};
}

std::optional<double> CloudPlace::metres_in_file() const {
  return plane_ ? std::optional(metres_.x()) : std::nullopt;
}

void CloudPlace::place(std::span<CloudPoint> points) {
  if (points.empty() || !moves_points()) return;
  if (!projects_) {
    for (CloudPoint& p : points) p.position = p.position.cwiseProduct(metres_);
    return;
  }
  if (!way_) lead_to(origin_near(points.front(), *reference_, source_));
  convert(points, *way_, reference_->told(), source_);
  for (CloudPoint& p : points) {
    require_near(p.position, *origin_, source_);
    p.position.z() = p.position.z() * metres_.z() - origin_->height;
  }
}

std::string CloudPlace::report() const {
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
  } else if (metres_ != Vec3::Ones()) {
    add(fmt::format("converted to metres from units of {} m, heights from units of {} m{}",
                    metres_.x(), metres_.z(), by));
  }
  if (!moved_.empty()) {
    add(fmt::format("a comment says \"{}\", and the coordinates are taken as they stand", moved_));
  }
  if (up_assumed_ && metres_.z() != 1) {
    add("nothing says the unit of heights, and that of x and y is taken (--vertical-units says "
        "otherwise)");
  }
  return out;
}

}  // namespace geom
