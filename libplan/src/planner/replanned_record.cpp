#include "plan/planner/replanned_record.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "plan/planner/path_record.h"

namespace plan {
namespace {

using geom::LegRange;
using geom::Polyline;

// Where each old point is in the new path, and whether the leg from it on is kept.
struct Kept {
  std::vector<std::optional<std::size_t>> at;
  std::vector<bool> leg;
};

// Kept ranges are the old path's bit for bit, and in its order.
Kept kept_points(const Polyline& old, const Polyline& path, const std::vector<LegRange>& ranges) {
  Kept kept{std::vector<std::optional<std::size_t>>(old.size()),
            std::vector<bool>(old.size(), false)};
  kept.at.front() = 0;
  kept.at.back() = path.size() - 1;
  auto from = old.begin();
  for (const LegRange& range : ranges) {
    const auto begin = path.begin() + static_cast<std::ptrdiff_t>(range.first);
    const auto end = path.begin() + static_cast<std::ptrdiff_t>(range.last) + 1;
    from = std::search(from, old.end(), begin, end);
    if (from == old.end()) break;
    const auto first = static_cast<std::size_t>(from - old.begin());
    for (std::size_t i = range.first; i <= range.last; ++i) {
      kept.at[first + i - range.first] = i;
      if (i < range.last) kept.leg[first + i - range.first] = true;
    }
    from += static_cast<std::ptrdiff_t>(range.last - range.first);
  }
  return kept;
}

bool keeps_hold(const geom::PathRecord& old, const Kept& kept, std::size_t i) {
  return old.hold.empty() || old.hold[i] == 0 || kept.at[i];
}

bool keeps_velocity(const geom::PathRecord& old, const Kept& kept, std::size_t i) {
  if (old.velocity.empty() || !old.velocity[i]) return true;
  const bool before = i == 0 || kept.leg[i - 1];
  const bool after = i + 1 == old.points.size() || kept.leg[i];
  return kept.at[i] && before && after;
}

}  // namespace

ReplannedRecord replanned_record(const geom::CollisionScene& scene, const geom::PathRecord& old,
                                 const ReplanResult& result) {
  ReplannedRecord out{path_record(scene, old.id, result.plan), {}};
  geom::PathRecord& record = out.record;
  record.time = old.time;
  if (record.points.empty()) return out;
  record.origin = result.origin;
  const Kept kept = kept_points(old.points, record.points, result.origin.kept);
  if (!old.hold.empty()) record.hold.assign(record.points.size(), 0);
  if (!old.velocity.empty()) record.velocity.assign(record.points.size(), std::nullopt);
  for (std::size_t i = 0; i < old.points.size(); ++i) {
    const bool hold = keeps_hold(old, kept, i);
    const bool velocity = keeps_velocity(old, kept, i);
    if (!hold || !velocity) out.lost.push_back(i);
    if (!kept.at[i]) continue;
    if (!old.hold.empty()) record.hold[*kept.at[i]] += old.hold[i];
    if (!old.velocity.empty() && velocity) record.velocity[*kept.at[i]] = old.velocity[i];
  }
  return out;
}

geom::PathRecord replanned(const geom::CollisionScene& scene, Planner& planner,
                           const geom::PathRecord& old, Quality quality) {
  if (old.status != PathStatus::found) return passed_on(old, scene.map());
  ReplannedRecord out = replanned_record(scene, old, replan(scene, planner, old.points, quality));
  if (!out.lost.empty()) {
    out.record.message =
        fmt::format("the way leaves points {} of the old path, whose holds and velocities are lost",
                    fmt::join(out.lost, ", "));
  }
  return std::move(out.record);
}

geom::PathRecord passed_on(const geom::PathRecord& record, const geom::BoxMap& map) {
  geom::PathRecord out{.id = record.id, .status = PathStatus::stopped, .time = record.time};
  out.provenance = record.provenance;
  out.provenance.map = map.hash();
  out.provenance.frame = map.spec().frame.axes;
  out.message = fmt::format("no path to replan: the record before says {}{}{}", name(record.status),
                            record.message.empty() ? "" : ": ", record.message);
  return out;
}

}  // namespace plan
