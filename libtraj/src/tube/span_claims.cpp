#include "tube/span_claims.h"

#include <algorithm>
#include <cmath>

#include "tube/loop_state.h"
#include "tube/prove_cell.h"

namespace traj {
namespace {

// Checkers sum otherwise, and need room. What is claimed enters the remainders, so that too much
// room makes deviations larger.
constexpr double kLeastRoom = 1.03;
constexpr double kRoom = 1.04;
constexpr int kTries = 4;
constexpr int kMostPeriods = 25;
// A span whose deviations grow or shrink by more than the first is followed by a shorter one, and
// by a longer one if it is less than the second.
constexpr double kMuchChange = 1.5;
constexpr double kLittleChange = 1.25;
constexpr double kMostGrowth = 1.5;  // taken for granted

// Beside the share: a checker flies its own middle, which is off by up to the simulator's slack.
constexpr double more_room(std::size_t row) {
  const bool spins = row >= GeometricRows::kSpin && row < GeometricRows::kPastSpins;
  return spins ? 2 * kSpinSlack : 10 * kSlack;
}

}  // namespace

const SpanClaims::Bounds& SpanClaims::taken_for(const Bounds& found) {
  if (met_ == 0) {
    first_ = least_ = most_ = found;
    if (tries_ == 0) propose(found);
  }
  ++met_;
  for (std::size_t i = 0; i < found.size(); ++i) {
    least_[i] = std::min(least_[i], found[i]);
    most_[i] = std::max(most_[i], found[i]);
  }
  return taken_;
}

void SpanClaims::propose(const Bounds& found) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double growth = spans_.empty() ? 1 : std::pow(growth_[i], periods_ - 1);
    taken_[i] = kRoom * found[i] * std::clamp(growth, 1.0, kMostGrowth) + kRoom * more_room(i);
  }
}

bool SpanClaims::has_room(std::size_t i) const {
  return !(kLeastRoom * most_[i] + more_room(i) > taken_[i]);
}

bool SpanClaims::raise() {
  bool raised = false;
  for (std::size_t i = 0; i < taken_.size(); ++i) {
    if (has_room(i)) continue;
    taken_[i] = kRoom * (kRoom * most_[i] + more_room(i));
    raised = true;
  }
  return raised;
}

bool SpanClaims::settle() {
  if (raise()) {
    met_ = 0;
    if (++tries_ == kTries) shorten();
    return false;
  }
  spans_.push_back({met_, taken_});
  for (std::size_t i = 0; i < taken_.size(); ++i) {
    const double grown = most_[i] / std::max(first_[i], more_room(i));
    growth_[i] = grown > 1 ? std::pow(grown, 1.0 / met_) : 1;
  }
  periods_ = next_periods();
  met_ = tries_ = 0;
  return true;
}

bool SpanClaims::shorten() {
  if (periods_ == 1) return false;
  periods_ /= 2;
  met_ = tries_ = 0;
  return true;
}

int SpanClaims::next_periods() const {
  double change = 1;
  for (std::size_t i = 0; i < taken_.size(); ++i) {
    change = std::max(change, taken_[i] / kRoom / (least_[i] + more_room(i)));
  }
  if (change > kMuchChange) return std::max(periods_ / 2, 1);
  return change < kLittleChange ? std::min(periods_ + 1 + periods_ / 2, kMostPeriods) : periods_;
}

}  // namespace traj
