#include "traj/together/check_together.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "geom/base/parallel.h"
#include "pair_search.h"

namespace traj {
namespace {

constexpr std::size_t kBlock = 64;  // pairs that a thread takes at once

struct Looked {
  std::size_t pieces = 0;
  std::vector<RefusedPair> refused;
  std::vector<ProvedPair> proved;
};

// Of all flights.
class Sky {
 public:
  Sky(std::span<const TimedFlight> flights, const TogetherRule& rule)
      : flights_(flights), rule_(rule) {
    for (const TimedFlight& flight : flights) lines_.emplace_back(flight);
  }

  void look(const FlightPair& pair, Looked& out) const {
    const auto [a, b] = pair;
    auto zones = zones_between(rule_.spacing, flights_[a].room, flights_[b].room);
    PairResult result = check_pair(lines_[a], lines_[b], zones, rule_.parked);
    out.pieces += result.pieces;
    bool apart = result.apart;
    if (apart && rule_.exact) {
      ExactPair proof = check_pair_exactly(flights_[a], flights_[b], zones, rule_.parked);
      apart = proof.apart;
      if (apart) out.proved.push_back({pair, std::move(proof)});
    }
    if (!apart) out.refused.push_back({pair, std::move(zones), std::move(result)});
  }

 private:
  std::span<const TimedFlight> flights_;
  const TogetherRule& rule_;
  std::vector<Timeline> lines_;
};

template <class T>
void move_to_end(std::vector<T>& from, std::vector<T>& to) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

}  // namespace

TogetherResult check_together(std::span<const TimedFlight> flights, const TogetherRule& rule,
                              const geom::Execution& run) {
  const std::vector<FlightPair> near = near_pairs(flights, rule.spacing, rule.parked, run);
  const Sky sky(flights, rule);
  std::vector<Looked> blocks((near.size() + kBlock - 1) / kBlock);
  geom::parallel_for(blocks.size(), run, [&](std::size_t i) {
    const std::size_t end = std::min(near.size(), (i + 1) * kBlock);
    for (std::size_t k = i * kBlock; k < end; ++k) sky.look(near[k], blocks[i]);
  });
  TogetherResult out;
  out.pairs = flights.empty() ? 0 : flights.size() * (flights.size() - 1) / 2;
  out.near = near.size();
  for (Looked& block : blocks) {
    out.pieces += block.pieces;
    move_to_end(block.refused, out.refused);
    move_to_end(block.proved, out.proved);
  }
  return out;
}

}  // namespace traj
