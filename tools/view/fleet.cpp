#include "fleet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "geom/base/error.h"
#include "layers.h"
#include "traj/proof/domain.h"
#include "traj/together/flights_hash.h"

namespace view {
namespace {

constexpr std::size_t kMostPairs = 500;  // in the page
constexpr double kFarthest = 200;        // metres: what is farther apart is not near
constexpr std::size_t kPairsAFlight = 2;

double across(const traj::Approach& approach) {
  return (approach.place - approach.other).head<2>().norm();
}

double up(const traj::Approach& approach) {
  return std::abs(approach.place.z() - approach.other.z());
}

// [across, up] of a cylinder, [x, y, up] of a box.
Json asked(const traj::Zone& zone) {
  const geom::Vec3& reach = zone.reach;
  return zone.round ? Json{reach.x(), reach.z()} : as_json(reach);
}

// Of each flight the approach to the flight that comes nearest; null where none is near.
std::vector<const traj::Approach*> nearest_of(const traj::Approaches& approaches,
                                              std::size_t flights) {
  std::vector<const traj::Approach*> out(flights, nullptr);
  for (const traj::Approach& approach : approaches.list) {  // the nearest first
    for (const std::uint32_t i : {approach.flights.first, approach.flights.second}) {
      if (!out[i]) out[i] = &approach;
    }
  }
  return out;
}

// distance, across, up of each flight's nearest approach; NaN where none is near.
Json nearest_array(const traj::Approaches& approaches, std::size_t flights, Bundle& bundle) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> out;
  for (const traj::Approach* near : nearest_of(approaches, flights)) {
    out.push_back(near ? static_cast<float>(near->distance) : kNone);
    out.push_back(near ? static_cast<float>(across(*near)) : kNone);
    out.push_back(near ? static_cast<float>(up(*near)) : kNone);
  }
  return bundle.add(std::span<const float>(out));
}

Json check_json(const traj::TogetherSummary& check) {
  Json out = {
      {"ok", check.ok},           {"flights", check.flights},   {"pairs", check.pairs},
      {"refused", check.refused}, {"left_out", check.left_out}, {"overridden", check.overridden}};
  if (check.separation) out["asked"] = asked(*check.separation);
  return out;
}

}  // namespace

Fleet::Fleet(const cli::Contents& contents, const geom::Execution& run) : contents_(contents) {
  bool timed = false;
  const auto& all = contents.trajectories;
  for (const auto& [record, source, line] : all) {
    geom::require_epoch_agrees(record.time.epoch, all.front().record.time.epoch, source, line);
    if (record.status != traj::TrajectoryStatus::solved) continue;
    timed = timed || record.time.any();
    const double start = record.time.starts();
    begin_ = flights_.empty() ? start : std::min(begin_, start);
    flights_.push_back(&record);
  }
  together_ = !flights_.empty() && (timed || !contents.pairs.empty() ||
                                    !contents.together.empty() || flights_.size() > kMostAlone);
  if (!together_) return;
  if (!contents.together.empty()) hash_ = hash();
  measure(run);
}

std::string Fleet::hash() const {
  std::vector<std::string> ids;
  std::vector<traj::TimedFlight> flights;
  for (const traj::TrajectoryRecord* record : flights_) {
    ids.push_back(record->id);
    flights.push_back({&record->trajectory, record->time.starts(), geom::Vec3::Zero()});
  }
  return traj::flights_hash(ids, flights, flights_.front()->time.epoch);
}

void Fleet::measure(const geom::Execution& run) {
  std::vector<traj::TimedFlight> timed;
  std::vector<std::uint32_t> of;
  for (std::size_t i = 0; i < flights_.size(); ++i) {
    if (traj::outside_domain(flights_[i]->trajectory, {})) continue;
    timed.push_back({&flights_[i]->trajectory, flights_[i]->time.starts(), geom::Vec3::Zero()});
    of.push_back(static_cast<std::uint32_t>(i));
  }
  if (timed.size() < 2) return;
  approaches_ = traj::nearest_approaches(timed, kPairsAFlight * timed.size(), kFarthest, run);
  for (traj::Approach& approach : approaches_.list) {
    auto& [a, b] = approach.flights;
    a = of[a];
    b = of[b];
  }
}

void Fleet::add_times(const traj::TrajectoryRecord& record, Json& motion) const {
  if (!together_) return;
  motion["start"] = record.time.starts() - begin_;
  if (record.time.start && record.time.earliest) {
    motion["delay"] = *record.time.start - *record.time.earliest;
  }
}

// Those that the check refused, as near as it says; then the nearest of the others.
std::vector<Fleet::Pair> Fleet::pairs() const {
  std::map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < flights_.size(); ++i) index.emplace(flights_[i]->id, i);
  std::vector<Pair> out;
  std::vector<traj::PairSummary> refused;
  for (const auto& read : contents_.pairs) refused.push_back(read.record);
  std::stable_sort(refused.begin(), refused.end(),
                   [](const auto& a, const auto& b) { return a.share < b.share; });
  std::set<std::pair<std::size_t, std::size_t>> told;
  for (const traj::PairSummary& pair : refused) {
    const auto a = index.find(pair.first);
    const auto b = index.find(pair.second);
    if (a == index.end() || b == index.end()) continue;
    told.insert(std::minmax(a->second, b->second));
    out.push_back(
        {a->second, b->second, pair.time - begin_, pair.across, pair.up, pair.reason, pair.zone});
  }
  for (const traj::Approach& approach : approaches_.list) {
    if (out.size() >= kMostPairs) break;
    const auto [a, b] = approach.flights;
    if (told.count({a, b})) continue;
    out.push_back({a, b, approach.time - begin_, across(approach), up(approach), "", {}});
  }
  if (out.size() > kMostPairs) out.resize(kMostPairs);
  return out;
}

const traj::TogetherSummary* Fleet::verdict() const {
  const traj::TogetherSummary* out = nullptr;
  for (const auto& [check, source, line] : contents_.together) {
    if (!check.ok) return &check;
    if (check.flights_hash == hash_) out = &check;
  }
  return out;
}

Json Fleet::json(Bundle& bundle) const {
  Json out = {{"begin", begin_}};
  if (const auto& epoch = flights_.front()->time.epoch) out["epoch"] = *epoch;
  out["within"] = approaches_.within;
  out["near"] = approaches_.list.size();
  out["nearest"] = nearest_array(approaches_, flights_.size(), bundle);
  out["pairs"] = Json::array();
  for (const Pair& pair : pairs()) {
    Json row = {{"of", {pair.first, pair.second}},
                {"time", pair.time},
                {"distance", std::hypot(pair.across, pair.up)},
                {"across", pair.across},
                {"up", pair.up}};
    if (!pair.reason.empty()) row["reason"] = pair.reason;
    if (pair.zone) row["asked"] = asked(*pair.zone);
    out["pairs"].push_back(std::move(row));
  }
  if (const traj::TogetherSummary* check = verdict()) out["check"] = check_json(*check);
  return out;
}

}  // namespace view
