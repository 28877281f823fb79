#include "step_filter.h"

#include <algorithm>
#include <cmath>

namespace traj {
namespace {

constexpr double kMargin = 1e-5;  // of the violation that has to go, gamma_theta there
constexpr double kTrade = 1e-8;   // barrier for violation, gamma_phi, and eta_phi of Armijo's rule
constexpr double kRounding = 1e-12;

// x^2.25 and x^1.125: near their 2.3 and 1.1, and from square roots alone.
double eighth_root(double x) { return std::sqrt(std::sqrt(std::sqrt(x))); }
double steep(double x) { return x * x * std::sqrt(std::sqrt(x)); }
double flat(double x) { return x * eighth_root(x); }

}  // namespace

StepFilter::StepFilter(double start)
    : most_(1e4 * std::max(1.0, start)), little_(1e-4 * std::max(1.0, start)) {}

bool StepFilter::accepts(const Progress& from, const Progress& to, double slope, double length) {
  if (!(to.violation <= most_) || !std::isfinite(to.barrier)) return false;
  const auto beaten_by = [&](const Progress& p) {
    return to.violation >= p.violation && to.barrier >= p.barrier;
  };
  if (std::any_of(left_.begin(), left_.end(), beaten_by)) return false;
  const bool barrier_counts =
      from.violation <= little_ && slope < 0 && length * steep(-slope) > flat(from.violation);
  if (barrier_counts) {
    const double rounding = kRounding * std::abs(from.barrier);
    return to.barrier <= from.barrier + kTrade * length * slope + rounding;
  }
  const Progress enough{(1 - kMargin) * from.violation, from.barrier - kTrade * from.violation};
  if (to.violation > enough.violation && to.barrier > enough.barrier) return false;
  left_.push_back(enough);
  return true;
}

}  // namespace traj
