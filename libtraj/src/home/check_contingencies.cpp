#include "traj/home/check_contingencies.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/text/rounded.h"
#include "home/braking.h"
#include "home/clear_region.h"
#include "home/way_room.h"
#include "home/way_time.h"
#include "traj/home/contingency_proof.h"
#include "traj/home/landing_site.h"

namespace traj {
namespace {

constexpr double kSameInstant = 1e-6;  // s, for the rounding of sums of times

// Why a record is refused, and when.
struct Refusal {
  Reason reason = Reason::none;
  double time = 0;
  Vec3 place = Vec3::Zero();
  std::string detail;
  double worst = 0;
};

using Refused = std::optional<Refusal>;

class Prover {
 public:
  Prover(const geom::CollisionScene& scene, std::span<const FlightStage> stages,
         const ContingencyRules& rules)
      : scene_(scene),
        stages_(stages),
        rules_(rules),
        room_(scene, rules.models),
        time_(rules.models, scene.vehicle().limits, rules.energy) {}

  Refused refusal(const ContingencyRecord& record) {
    if (auto refused = way_refused(record)) return refused;
    if (auto refused = energy_claim_refused(record)) return refused;
    for (const FlightStage& stage : stages_) {
      if (stage.until < record.from || stage.from > record.until) continue;
      if (auto refused = stage_refused(record, stage)) return refused;
    }
    return std::nullopt;
  }

  // The same with what was found clear; nothing for a record that is refused.
  std::optional<ProvedWay> proved(const ContingencyRecord& record) {
    joins_.emplace();
    ProvedWay out{record, {}, {}};
    if (refusal(record)) return std::nullopt;
    for (std::size_t i = 0; i + 2 < record.points.size(); ++i) {
      out.beyond.push_back(room_.beyond(record.points[i], record.points[i + 1]));
    }
    out.joins = *std::move(joins_);
    return out;
  }

 private:
  Refused way_refused(const ContingencyRecord& record) const {
    const geom::Polyline& points = record.points;
    for (std::size_t i = 0; i + 2 < points.size(); ++i) {
      if (room_.leg(points[i], points[i + 1])) continue;
      return Refusal{Reason::collision, record.from, points[i],
                     fmt::format("leg {} of the way to {} is not clear", i, record.site)};
    }
    const Vec3& above = points[points.size() - 2];
    const std::string fault = landing_fault(scene_, above, points.back());
    if (fault.empty()) return std::nullopt;
    return Refusal{Reason::landing, record.from, points.back(),
                   fmt::format("{}: {}", record.site, fault)};
  }

  Refused energy_claim_refused(const ContingencyRecord& record) const {
    const bool bounded = rules_.energy || record.bounds_energy;
    if (!bounded || record.latest_departure == record.until) return std::nullopt;
    return Refusal{Reason::endurance, record.latest_departure.value_or(record.from),
                   record.points.front(),
                   fmt::format("not enough energy for the way to {}", record.site)};
  }

  // A stage that is partly outside of the record's time is halved as far as it can be, and then
  // taken as a whole.
  Refused stage_refused(const ContingencyRecord& record, const FlightStage& stage) {
    if (stage.until < record.from || stage.from > record.until) return std::nullopt;
    const bool ends = stage.until == record.from || stage.from == record.until;
    if (ends && stage.from < stage.until) return std::nullopt;  // the neighbour has that instant
    const bool inside = record.from <= stage.from && stage.until <= record.until;
    Refused refused = inside ? part_refused(record, stage) : Refused(Refusal{});
    if (!refused) return std::nullopt;
    const auto parts = extent(stage) > rules_.finest ? halves(stage) : std::nullopt;
    if (!parts) return inside ? refused : part_refused(record, stage);
    if (auto early = stage_refused(record, parts->first)) return early;
    return stage_refused(record, parts->second);
  }

  Refused part_refused(const ContingencyRecord& record, const FlightStage& stage) {
    const Braking from = braking_of(rules_.models, stage);
    const auto refuse = [&](Reason reason, const char* what) {
      return Refusal{
          reason, stage.from, stage.where.front(),
          fmt::format("the way to {} from {:.6g} s on: {}", record.site, stage.from, what)};
    };
    if (!clear_region(scene_, from.region, stage.stands_on)) {
      return refuse(Reason::collision, "the vehicle may touch something while it brakes");
    }
    if (!room_.joins(from, record.points.front())) {
      return refuse(Reason::collision, "the straight way to its first point is not clear");
    }
    const double seconds = rules_.energy || joins_ ? time_.at_most(from, record.points) : 0;
    if (rules_.energy && stage.until + seconds > flying_time(*rules_.energy) + kSameInstant) {
      return refuse(Reason::endurance, "there is not enough energy");
    }
    if (joins_) {
      joins_->push_back({stage.from, stage.until, stage.where, from.region,
                         room_.beyond(from, record.points.front()), seconds});
    }
    return std::nullopt;
  }

  const geom::CollisionScene& scene_;
  std::span<const FlightStage> stages_;
  const ContingencyRules& rules_;
  WayRoom room_;
  WayTime time_;
  std::optional<std::vector<ProvedJoin>> joins_ = {};  // where they are kept
};

constexpr const char* kEnergyNotChecked =
    "whether the battery is enough was not checked (--vehicle with an energy)";

// The times of the flight that no record covers.
struct Uncovered {
  std::optional<std::pair<double, double>> first = {};
  double seconds = 0;  // of all

  void add(double from, double until) {
    if (!(from < until)) return;
    if (!first) first = {from, until};
    seconds += until - from;
  }
};

Uncovered uncovered(std::span<const FlightStage> stages,
                    std::span<const ContingencyRecord> records) {
  std::vector<std::pair<double, double>> times;
  for (const ContingencyRecord& record : records) {
    if (record.found()) times.emplace_back(record.from, record.until);
  }
  std::sort(times.begin(), times.end());
  Uncovered out;
  double covered = stages.front().from;
  const double end = stages.back().until;
  for (const auto& [from, until] : times) {
    out.add(covered, std::min(from, end));
    covered = std::max(covered, until);
  }
  out.add(covered, end);
  if (times.empty() && !out.first) out.first = {covered, end};  // of an instant
  return out;
}

Refused without_way(std::span<const FlightStage> stages,
                    std::span<const ContingencyRecord> records) {
  const Uncovered gaps = uncovered(stages, records);
  if (!gaps.first) return std::nullopt;
  const auto [from, until] = *gaps.first;
  const auto at =
      std::find_if(stages.begin(), stages.end(),
                   [from = from](const FlightStage& stage) { return stage.until > from; });
  const double lasts = stages.back().until - stages.front().from;
  const double share = lasts > 0 ? 1 - gaps.seconds / lasts : 0;
  return Refusal{Reason::return_home, from,
                 (at == stages.end() ? stages.back() : *at).where.front(),
                 fmt::format("no way home from {:.6g} to {:.6g} s; ways home hold for {:.4g} % of "
                             "the time",
                             from, until, geom::rounded_down(100 * share)),
                 gaps.seconds};
}

}  // namespace

ReportRecord check_contingencies(const geom::CollisionScene& scene, const std::string& id,
                                 std::span<const FlightStage> stages,
                                 std::span<const ContingencyRecord> records,
                                 const ContingencyRules& rules) {
  ReportRecord report{.id = id, .checked = std::string(kCheckedContingency)};
  report.provenance = geom::provenance_of(scene);
  if (stages.empty()) {
    report.result.reason = Reason::no_path;
    report.detail = "it has no flight, and so no way home";
    return report;
  }
  report.result.duration = stages.back().until - stages.front().from;
  Prover prover(scene, stages, rules);
  Refused first;
  for (const ContingencyRecord& record : records) {
    if (!record.found()) continue;
    auto refused = prover.refusal(record);
    if (refused && (!first || refused->time < first->time)) first = std::move(refused);
  }
  if (!first) first = without_way(stages, records);
  report.result.looked = true;
  report.result.ok = !first;
  if (!first) {
    if (!rules.energy) report.detail = kEnergyNotChecked;
    return report;
  }
  report.result.reason = first->reason;
  report.result.time = first->time;
  report.result.place = first->place;
  report.result.worst = first->worst;
  report.detail = std::move(first->detail);
  return report;
}

std::vector<ProvedWay> proved_ways(const geom::CollisionScene& scene,
                                   std::span<const FlightStage> stages,
                                   std::span<const ContingencyRecord> records,
                                   const ContingencyRules& rules) {
  Prover prover(scene, stages, rules);
  std::vector<ProvedWay> out;
  for (const ContingencyRecord& record : records) {
    if (!record.found()) continue;
    if (auto way = prover.proved(record)) out.push_back(*std::move(way));
  }
  return out;
}

}  // namespace traj
