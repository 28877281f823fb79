#include "cloud_source.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/base/error.h"
#include "geom/base/sha256.h"
#include "geom/base/usage_error.h"
#include "geom/cloud/las_class.h"

namespace geom {
namespace {

bool is_in_reach(const Vec3& metres) { return (metres.array().abs() <= kLargestCoordinate).all(); }

[[noreturn]] void refuse_reach(const Vec3& metres, const std::string& name) {
  throw InputError(
      name, {.key = "a point",
             .expected = "within 1e8 m of the origin",
             .found = fmt::format("[{}, {}, {}] in metres", metres.x(), metres.y(), metres.z())});
}

}  // namespace

bool CloudSource::wants(const CloudPoint& p) {
  if (is_noise_class(p.cls)) {
    ++noise_;
    if (options_.drop_noise) return false;
  }
  if (options_.classes.none() || options_.classes[p.cls]) return true;
  ++other_class_;
  return false;
}

std::span<const CloudPoint> CloudSource::place_wanted(std::span<const CloudPoint> chunk) {
  std::span<const CloudPoint> placed = chunk;
  const bool all = !options_.drop_noise && options_.classes.none();
  if (all) {
    noise_ += static_cast<std::size_t>(std::count_if(
        chunk.begin(), chunk.end(), [](const CloudPoint& p) { return is_noise_class(p.cls); }));
  }
  if (!all || place_.moves_points()) {
    wanted_.assign(chunk.begin(), chunk.end());
    if (!all) std::erase_if(wanted_, [&](const CloudPoint& p) { return !wants(p); });
    place_.place(wanted_);
    placed = wanted_;
  }
  if (place_.moves_points()) {  // readers refuse points out of reach themselves
    for (const CloudPoint& p : placed) {
      if (!is_in_reach(p.position)) refuse_reach(p.position, file_.name);
    }
  }
  return placed;
}

void CloudSource::settle(const CoordinateReference& told) {
  says_nothing_ = told.kind == CoordinateReference::Kind::none;
  place_.settle(told, file_.name);
}

void CloudSource::for_each(const std::function<void(const CloudPoint&)>& f) {
  for_each_chunk([&](std::span<const CloudPoint> points) {
    for (const CloudPoint& p : points) f(p);
  });
}

void CloudSource::for_each_chunk(const PointSink& f) {
  other_class_ = 0;
  noise_ = 0;
  part_.reset();
  const auto points = [&](std::span<const CloudPoint> chunk) { f(place_wanted(chunk)); };
  if (!read_before_) {
    read_before_ = true;
    return read(file_.first, points);
  }
  const auto in = file_.again(file_.name);
  HashedStream bytes(*in);
  read(bytes, points);
}

// All of it, unless a part is enough and can be had.
void CloudSource::read(HashedStream& bytes, const PointSink& sink) {
  if (reads_part(bytes.head())) return read_part(sink);
  if (options_.resolution > 0) {
    throw InputError(file_.name, {.expected = "a COPC file for --resolution",
                                  .found = "another",
                                  .advice = "leave the option out, or make one, for example with "
                                            "`pdal translate in.laz out.copc.laz`"});
  }
  counts_ = options_.format->read(
      bytes.stream(), file_.name, sink, [&](const CoordinateReference& told) { settle(told); },
      reading());
  input_ = {{"input", bytes.hash()}};
}

LasReading CloudSource::reading() const {
  return {run_, [this](std::uint64_t at, std::span<unsigned char> to) -> std::size_t {
            return file_.random ? file_.random->read(at, to) : 0;  // a pipe has one way only
          }};
}

bool CloudSource::reads_part(std::string_view head) const {
  const bool asked = options_.map.bounds || options_.resolution > 0;
  return asked && file_.random && options_.format == &kLasCloud && options_.each_point_alone() &&
         is_copc(head);
}

// In the file's units, once these are settled.
CopcPart CloudSource::part() const {
  CopcPart part;
  const auto metres = place_.metres_in_file();
  if (options_.resolution > 0 && !metres) {
    throw UsageError("--resolution needs a file whose coordinates are lengths");
  }
  if (options_.resolution > 0) part.resolution = options_.resolution / *metres;
  if (!options_.map.bounds) return part;
  // What reaches into the bounds from beside them.
  const double more = options_.columns.cell + options_.resolution + options_.map.inflate;
  part.region = place_.in_file(grow(*options_.map.bounds, Vec3::Constant(1.001 * more)));
  return part;
}

void CloudSource::read_part(const PointSink& sink) {
  Sha256 sum;  // of what is read, in the order in which it is
  const auto choose = [&](const CoordinateReference& told) {
    settle(told);
    return part();
  };
  const auto read = [&](std::uint64_t at, std::span<unsigned char> to) {
    const std::size_t done = file_.random->read(at, to);
    sum.update(std::as_bytes(to.first(done)));
    return done;
  };
  const CopcCounts counts = read_copc(read, file_.name, choose, sink, run_);
  counts_ = counts.cloud;
  part_ = counts;
  if (counts.finer > 0) {
    counts_.skipped.add("detail finer than --resolution",
                        fmt::format("{} of {} points; what was read is grown by {} m", counts.finer,
                                    counts.all - counts.outside, options_.resolution));
  }
  input_ = {{"input_part", "sha256:" + sum.hex()},
            {"bytes_read", counts.bytes},
            {"bytes", file_.random->size()},
            {"points_not_read", counts.outside + counts.finer}};
}

std::vector<Fact> CloudSource::facts() const {
  std::vector<Fact> out = {{"points", part_ ? std::size_t{part_->all} : counts_.read}};
  if (part_) out.emplace_back("outside_bounds", std::size_t{part_->outside});
  if (part_ && part_->finer > 0) out.emplace_back("not_read_finer", std::size_t{part_->finer});
  out.emplace_back("dropped_not_finite", counts_.not_finite);
  if (noise_ > 0) {
    out.emplace_back(options_.drop_noise ? "dropped_as_noise" : "kept_noise", noise_);
  }
  if (options_.classes.any()) out.emplace_back("dropped_by_class", other_class_);
  return out;
}

}  // namespace geom
