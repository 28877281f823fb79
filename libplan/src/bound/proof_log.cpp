#include "proof_log.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace plan {

void ProofLog::begin(const Level& level) {
  LengthProof::Level& now = proof_.levels.emplace_back();
  for (std::size_t i = 0; i < level.parts.size(); ++i) {
    const EdgePart& part = level.parts[i];
    const std::uint32_t parent = level.parents.empty() ? 0 : level.parents[i];
    now.parts.push_back({part.low, part.high, part.axis, part.outward, parent});
  }
}

void ProofLog::hide(std::uint32_t from, std::uint32_t to, std::uint32_t occluder) {
  proof_.levels.back().hidden.push_back({from, to, occluder});
}

std::vector<LengthProof::Lines> ProofLog::lines(const std::vector<LineLabel>& labels) {
  std::vector<LengthProof::Lines> out;
  for (std::size_t s = 0; s < labels.size(); s += 2) {
    out.push_back({labels[s].low, labels[s].high, labels[s + 1].low, labels[s + 1].high});
  }
  return out;
}

LengthProof ProofLog::take(const Occluders& occluders) && {
  if (!proof_.levels.empty() && proof_.levels.back().come.empty()) proof_.levels.pop_back();
  std::map<std::uint32_t, std::uint32_t> numbers;
  for (LengthProof::Level& level : proof_.levels) {
    const auto pair = [](const LengthProof::Hidden& h) { return std::tie(h.from, h.to); };
    std::sort(level.hidden.begin(), level.hidden.end(),
              [&](const auto& a, const auto& b) { return pair(a) < pair(b); });
    level.hidden.erase(
        std::unique(level.hidden.begin(), level.hidden.end(),
                    [&](const auto& a, const auto& b) { return pair(a) == pair(b); }),
        level.hidden.end());
    for (LengthProof::Hidden& h : level.hidden) {
      const auto [at, fresh] =
          numbers.emplace(h.occluder, static_cast<std::uint32_t>(proof_.occluders.size()));
      if (fresh) proof_.occluders.push_back(occluders.box(h.occluder));
      h.occluder = at->second;
    }
  }
  return std::move(proof_);
}

}  // namespace plan
