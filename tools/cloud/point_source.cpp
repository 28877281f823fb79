#include "point_source.h"

#include <fmt/format.h>

#include "cli/file/files.h"
#include "cli/file/hashed_input.h"
#include "geom/base/error.h"
#include "geom/cloud/las_class.h"

namespace cloud {
namespace {

using geom::CloudPoint;

std::string detect(std::string_view head, const std::string& name) {
  if (head.starts_with("LASF")) return "las";
  if (head.starts_with("ply")) return "ply";
  const std::size_t pcd = head.substr(0, 2000).find("FIELDS");
  if (pcd != std::string_view::npos && head.find("DATA") != std::string_view::npos) return "pcd";
  if (head.empty()) throw geom::InputError(name, "the file is empty");
  return "xyz";
}

geom::CloudCounts read(std::istream& in, const std::string& name, const std::string& format,
                       const geom::PointSink& sink, const geom::ReferenceSink& reference) {
  if (format == "las") return geom::read_las(in, name, sink, reference);
  reference({});  // the others have no place for it
  if (format == "ply") return geom::read_ply(in, name, sink);
  if (format == "pcd") return geom::read_pcd(in, name, sink);
  return geom::read_xyz(in, name, sink);
}

void require_in_reach(const geom::Vec3& metres, const std::string& name) {
  if (metres.cwiseAbs().maxCoeff() <= geom::kLargestCoordinate) return;
  throw geom::InputError(
      name, fmt::format("a point must be within 1e8 m of the origin, found [{}, {}, {}] in metres",
                        metres.x(), metres.y(), metres.z()));
}

}  // namespace

bool PointSource::wants(const CloudPoint& p) {
  if (geom::is_noise_class(p.cls)) {
    ++noise_;
    if (options_.noise == "drop") return false;
  }
  if (options_.classes.none() || options_.classes[p.cls]) return true;
  ++other_class_;
  return false;
}

void PointSource::place_wanted(std::span<const CloudPoint> chunk, const std::string& name) {
  wanted_.clear();
  for (const CloudPoint& p : chunk) {
    if (wants(p)) wanted_.push_back(p);
  }
  options_.placement.place(wanted_);
  for (const CloudPoint& p : wanted_) require_in_reach(p.position, name);
}

void PointSource::for_each(const std::function<void(const CloudPoint&)>& f) {
  cli::InputFile file(path_);
  cli::HashedInput hashed(file);
  if (options_.format == "auto") options_.format = detect(hashed.head(), file.name());
  other_class_ = 0;
  noise_ = 0;
  const auto points = [&](std::span<const CloudPoint> chunk) {
    place_wanted(chunk, file.name());
    for (const CloudPoint& p : wanted_) f(p);
  };
  const auto reference = [&](const geom::CoordinateReference& told) {
    says_nothing_ = told.kind == geom::CoordinateReference::Kind::none;
    options_.placement.settle(told, file.name());
  };
  counts_ = read(hashed.stream(), file.name(), options_.format, points, reference);
  hash_ = hashed.hash();
}

void PointSource::report(nlohmann::ordered_json& out) const {
  out["points"] = counts_.read;
  out["dropped_not_finite"] = counts_.not_finite;
  if (noise_ > 0) out[options_.noise == "drop" ? "dropped_as_noise" : "kept_noise"] = noise_;
  if (options_.classes.any()) out["dropped_by_class"] = other_class_;
}

}  // namespace cloud
