#include "traj/record/tube_reports.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "geom/text/json_fields.h"
#include "geom/text/record_lines.h"
#include "traj/curve/trajectory_hash.h"
#include "traj/flight/monte_carlo.h"

namespace traj {
namespace {

constexpr double kHair = 1e-6;  // of a period, for rounding
constexpr const char* kFlyAgain = "fly this trajectory again (skyway-fly)";

std::string shown(const geom::Vehicle& vehicle) {
  return fmt::format("{} of half sizes [{}, {}, {}]", geom::in_quotes(vehicle.name),
                     vehicle.half.x(), vehicle.half.y(), vehicle.half.z());
}

}  // namespace

TubeReports TubeReports::read(std::istream& in, const std::string& source) {
  TubeReports out;
  out.source_ = source;
  geom::for_each_line(in, source, [&](const std::string& text, std::size_t line) {
    auto tube = parse_tube(text, source, line);
    if (!tube) return;
    const std::string id = geom::JsonFields(text, source, line).text("id");
    const auto [at, is_new] = out.tubes_.try_emplace(id, Entry{line, *std::move(tube)});
    if (is_new) return;
    throw geom::InputError(source, line,
                           {.expected = "one tube of each flight",
                            .found = fmt::format("a second one of {}, after line {}",
                                                 geom::in_quotes(id), at->second.line)});
  });
  return out;
}

void TubeReports::require_whole(const Entry& entry, double duration) const {
  const TubeRecord& tube = entry.tube;
  const double periods = duration / tube.period;
  const auto has = static_cast<double>(tube.radius.size());
  const bool proved = tube.claim.kind == TubeKind::proved;
  if (proved ? tube.radius.size() == tube_periods(duration) : has >= periods - kHair) return;
  throw geom::InputError(source_, entry.line,
                         {.expected = fmt::format("a tube for the {:.6g} s of its plan", duration),
                          .found = fmt::format("one for {:.6g} s", has * tube.period),
                          .advice = kFlyAgain});
}

void TubeReports::require_same(const Entry& entry, const TrajectoryRecord& record,
                               const geom::Provenance& over) const {
  const TubeRecord& tube = entry.tube;
  const auto refuse = [&](std::string expected, std::string found) {
    throw geom::InputError(
        source_, entry.line,
        {.expected = std::move(expected), .found = std::move(found), .advice = kFlyAgain});
  };
  if (!tube.refused.empty()) {
    throw geom::InputError(source_, entry.line,
                           {.expected = "a tube that is proved",
                            .found = fmt::format("a proof that was refused ({})", tube.refused),
                            .advice = "allow less wind, gusts or mass error, or fly slower"});
  }
  const std::string hash = trajectory_hash(record.trajectory);
  if (!tube.trajectory.empty() && tube.trajectory != hash) {
    refuse(fmt::format("a tube of the trajectory with hash {}", hash),
           fmt::format("one of {}", tube.trajectory));
  }
  const geom::Axes axes = tube.provenance.frame.value_or(geom::Axes::enu);
  if (over.frame && *over.frame != axes) {
    refuse(fmt::format("a flight in axes {}", geom::name(*over.frame)),
           std::string(geom::name(axes)));
  }
  const auto& flown = tube.provenance.vehicle;
  if (!over.vehicle ||
      (flown && flown->name == over.vehicle->name && flown->half == over.vehicle->half)) {
    return;
  }
  if (tube.claim.kind == TubeKind::statistics && !flown) return;
  refuse(fmt::format("a flight of the vehicle {}", shown(*over.vehicle)),
         flown ? shown(*flown) : "none");
}

const TubeRecord* TubeReports::tube_of(const TrajectoryRecord& record,
                                       const geom::Provenance& over) const {
  const auto at = tubes_.find(record.id);
  if (at == tubes_.end()) return nullptr;
  require_same(at->second, record, over);
  require_whole(at->second, duration(record.trajectory));
  return &at->second.tube;
}

}  // namespace traj
