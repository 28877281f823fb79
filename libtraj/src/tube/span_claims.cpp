#include "tube/span_claims.h"

#include <algorithm>
#include <cmath>

namespace traj {
namespace {

// Checkers sum otherwise, and need room. What is claimed enters the remainders, so that too much
// room makes deviations larger.
constexpr double kLeastRoom = 1.05;
constexpr double kRoom = 1.06;
constexpr int kTries = 4;
constexpr int kMostPeriods = 25;
// A span whose deviations grow or shrink by more than the first is followed by a shorter one, and
// by a longer one if it is less than the second.
constexpr double kMuchChange = 1.5;
constexpr double kLittleChange = 1.25;
constexpr double kMostGrowth = 1.5;  // taken for granted

}  // namespace

SpanClaims::Bounds SpanClaims::level() const {
  Bounds out = last_.back();
  for (const Bounds& found : last_) {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::max(out[i], found[i]);
  }
  return out;
}

const SpanClaims::Bounds& SpanClaims::taken_for(const Bounds& found) {
  if (met_ == 0) last_ = before_;
  last_.push_back(found);
  if (last_.size() > order_) last_.pop_front();
  const Bounds now = level();
  if (met_ == 0) {
    first_ = least_ = now;
    most_ = found;
    if (tries_ == 0) propose(now);
  }
  ++met_;
  for (std::size_t i = 0; i < found.size(); ++i) {
    least_[i] = std::min(least_[i], now[i]);
    most_[i] = std::max(most_[i], found[i]);
  }
  return taken_;
}

void SpanClaims::propose(const Bounds& found) {
  taken_.resize(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double growth = spans_.empty() ? 1 : std::pow(growth_[i], periods_ - 1);
    taken_[i] = kRoom * found[i] * std::clamp(growth, 1.0, kMostGrowth) + kRoom * room_[i];
  }
}

bool SpanClaims::has_room(std::size_t i) const {
  return !(kLeastRoom * most_[i] + room_[i] > taken_[i]);
}

bool SpanClaims::raise() {
  bool raised = false;
  for (std::size_t i = 0; i < taken_.size(); ++i) {
    if (has_room(i)) continue;
    taken_[i] = kRoom * (kRoom * most_[i] + room_[i]);
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
  before_ = last_;
  growth_.resize(taken_.size());
  for (std::size_t i = 0; i < taken_.size(); ++i) {
    const double grown = most_[i] / std::max(first_[i], room_[i]);
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
    change = std::max(change, taken_[i] / kRoom / (least_[i] + room_[i]));
  }
  if (change > kMuchChange) return std::max(periods_ / 2, 1);
  return change < kLittleChange ? std::min(periods_ + 1 + periods_ / 2, kMostPeriods) : periods_;
}

}  // namespace traj
