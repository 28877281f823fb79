#include "traj/record/tube_reports.h"

#include <fmt/format.h>

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

std::optional<geom::Fault> other(std::string expected, std::string found) {
  return geom::Fault{
      .expected = std::move(expected), .found = std::move(found), .advice = kFlyAgain};
}

std::optional<geom::Fault> why_not_flown_by(const TubeRecord& tube, const geom::Vehicle& vehicle) {
  const auto& flown = tube.provenance.vehicle;
  if (flown && flown->name == vehicle.name && flown->half == vehicle.half) return std::nullopt;
  return other(fmt::format("a flight of the vehicle {}", shown(vehicle)),
               flown ? shown(*flown) : "none");
}

// A proved tube has a radius for each period; one of runs may go on longer.
std::optional<geom::Fault> why_not_whole(const TubeRecord& tube, double duration) {
  const auto has = static_cast<double>(tube.radius.size());
  const bool proved = tube.claim.kind == TubeKind::proved;
  if (proved ? tube.radius.size() == tube_periods(duration)
             : has >= duration / tube.period - kHair) {
    return std::nullopt;
  }
  return other(fmt::format("a tube for the {:.6g} s of its plan", duration),
               fmt::format("one for {:.6g} s", has * tube.period));
}

}  // namespace

std::optional<geom::Fault> why_not_of(const TubeRecord& tube, const Trajectory& trajectory,
                                      const geom::Provenance& over) {
  if (!tube.refused.empty()) {
    return geom::Fault{.expected = "a tube that is proved",
                       .found = fmt::format("a proof that was refused ({})", tube.refused),
                       .advice = "allow less wind, gusts or mass error, or fly slower"};
  }
  const std::string hash = trajectory_hash(trajectory);
  if (tube.trajectory != hash) {
    return other(fmt::format("a tube of the trajectory with hash {}", hash),
                 fmt::format("one of {}", tube.trajectory));
  }
  const geom::Axes axes = tube.provenance.frame.value_or(geom::Axes::enu);
  if (over.frame && *over.frame != axes) {
    return other(fmt::format("a flight in axes {}", geom::name(*over.frame)),
                 std::string(geom::name(axes)));
  }
  if (over.vehicle) {
    if (auto why = why_not_flown_by(tube, *over.vehicle)) return why;
  }
  return why_not_whole(tube, duration(trajectory));
}

TubeReports TubeReports::read(std::istream& in, const std::string& source) {
  TubeReports out;
  out.source_ = source;
  geom::for_each_line(in, source, [&](const std::string& text, std::size_t line) {
    auto tube = parse_tube(text, source, line);
    if (!tube) return;
    const std::string id = tube->id;
    const auto [at, is_new] = out.tubes_.try_emplace(id, Entry{line, *std::move(tube)});
    if (is_new) return;
    throw geom::InputError(source, line,
                           {.expected = "one tube of each flight",
                            .found = fmt::format("a second one of {}, after line {}",
                                                 geom::in_quotes(id), at->second.line)});
  });
  return out;
}

const TubeRecord* TubeReports::tube_of(std::string_view id, const Trajectory& trajectory,
                                       const geom::Provenance& over) const {
  const auto at = tubes_.find(id);
  if (at == tubes_.end()) return nullptr;
  const Entry& entry = at->second;
  if (auto why = why_not_of(entry.tube, trajectory, over)) {
    throw geom::InputError(source_, entry.line, *std::move(why));
  }
  return &entry.tube;
}

const TubeRecord& TubeReports::require_tube(std::string_view id, const Trajectory& trajectory,
                                            const geom::Provenance& over) const {
  if (const TubeRecord* tube = tube_of(id, trajectory, over)) return *tube;
  throw geom::InputError(source_, {.expected = "a tube of each trajectory",
                                   .found = "none of " + geom::in_quotes(id),
                                   .advice = "skyway-fly --proved-tube or --runs writes it"});
}

}  // namespace traj
