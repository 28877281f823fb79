#include "point_source.h"

#include <fmt/format.h>

#include <filesystem>

#include "cli/file/files.h"
#include "cli/file/hashed_input.h"
#include "cli/file/random_input.h"
#include "cli/run.h"
#include "geom/base/error.h"
#include "geom/cloud/las_class.h"

namespace cloud {
namespace {

using geom::CloudPoint;

const geom::CloudFormat& format_of(std::string_view head, const std::string& name) {
  if (head.empty()) throw geom::InputError(name, {.says = "the file is empty"});
  return *geom::row_recognised(head, geom::cloud_formats());
}

void require_in_reach(const geom::Vec3& metres, const std::string& name) {
  if (metres.cwiseAbs().maxCoeff() <= geom::kLargestCoordinate) return;
  throw geom::InputError(
      name, {.key = "a point",
             .expected = "within 1e8 m of the origin",
             .found = fmt::format("[{}, {}, {}] in metres", metres.x(), metres.y(), metres.z())});
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

void PointSource::settle(const geom::CoordinateReference& told, const std::string& name) {
  says_nothing_ = told.kind == geom::CoordinateReference::Kind::none;
  options_.placement.settle(told, name);
}

void PointSource::for_each(const std::function<void(const CloudPoint&)>& f) {
  other_class_ = 0;
  noise_ = 0;
  part_.reset();
  const std::string name = path_ == "-" ? "stdin" : path_;
  const auto points = [&](std::span<const CloudPoint> chunk) {
    place_wanted(chunk, name);
    for (const CloudPoint& p : wanted_) f(p);
  };
  read_whole(points, name);
}

// All of it, unless a part is enough and can be had.
void PointSource::read_whole(const geom::PointSink& sink, const std::string& name) {
  cli::InputFile file(path_);
  cli::HashedInput hashed(file);
  options_.settle_format(options_.format ? *options_.format : format_of(hashed.head(), name), name);
  if (reads_part(hashed.head())) return read_part(sink, name);
  if (options_.resolution > 0) {
    throw geom::InputError(name, {.expected = "a COPC file for --resolution",
                                  .found = "another",
                                  .advice = "leave the option out, or make one, for example with "
                                            "`pdal translate in.laz out.copc.laz`"});
  }
  counts_ = options_.format->read(
      hashed.stream(), name, sink,
      [&](const geom::CoordinateReference& told) { settle(told, name); }, reading());
  input_ = {{"input", hashed.hash()}};
}

geom::LasReading PointSource::reading() const {
  return {run_, [this](std::uint64_t at, std::span<unsigned char> to) -> std::size_t {
            if (!std::filesystem::is_regular_file(path_)) return 0;  // a pipe has one way only
            return cli::RandomInput(path_).read(at, to);
          }};
}

bool PointSource::reads_part(std::string_view head) const {
  const bool asked = options_.map.map.bounds || options_.resolution > 0;
  return asked && path_ != "-" && options_.format == &geom::kLasCloud &&
         options_.each_point_alone() && geom::is_copc(head);
}

// In the file's units, once these are settled.
geom::CopcPart PointSource::part() const {
  geom::CopcPart part;
  const auto metres = options_.placement.metres_in_file();
  if (options_.resolution > 0 && !metres) {
    throw cli::UsageError("--resolution needs a file whose coordinates are lengths");
  }
  if (options_.resolution > 0) part.resolution = options_.resolution / *metres;
  if (!options_.map.map.bounds) return part;
  // What reaches into the bounds from beside them.
  const double more = options_.columns.cell + options_.resolution + options_.map.map.inflate;
  part.region = options_.placement.in_file(
      geom::grow(*options_.map.map.bounds, geom::Vec3::Constant(1.001 * more)));
  return part;
}

void PointSource::read_part(const geom::PointSink& sink, const std::string& name) {
  cli::RandomInput file(path_);
  const auto choose = [&](const geom::CoordinateReference& told) {
    settle(told, name);
    return part();
  };
  const auto read = [&](std::uint64_t at, std::span<unsigned char> to) {
    return file.read(at, to);
  };
  const geom::CopcCounts counts = geom::read_copc(read, name, choose, sink, run_);
  counts_ = counts.cloud;
  part_ = counts;
  if (counts.finer > 0) {
    counts_.skipped.add("detail finer than --resolution",
                        fmt::format("{} of {} points; what was read is grown by {} m", counts.finer,
                                    counts.all - counts.outside, options_.resolution));
  }
  input_ = {{"input_part", file.hash_of_read()},
            {"bytes_read", counts.bytes},
            {"bytes", file.size()},
            {"points_not_read", counts.outside + counts.finer}};
}

void PointSource::report(nlohmann::ordered_json& out) const {
  out["points"] = part_ ? part_->all : counts_.read;
  if (part_) out["outside_bounds"] = part_->outside;
  if (part_ && part_->finer > 0) out["not_read_finer"] = part_->finer;
  out["dropped_not_finite"] = counts_.not_finite;
  if (noise_ > 0) out[options_.noise == "drop" ? "dropped_as_noise" : "kept_noise"] = noise_;
  if (options_.classes.any()) out["dropped_by_class"] = other_class_;
}

}  // namespace cloud
