#include "traj/tube/tune_tube.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geom/base/parallel.h"

namespace traj {
namespace {

constexpr double kFirstStep = 0.4;  // of the logarithm
constexpr double kLastStep = 0.1;
constexpr double kNoProof = 1e6;  // above every radius; less where the loop damps more
constexpr std::size_t kParameters = 6;

using Factors = std::array<double, kParameters>;  // of the gains that the search began with

GeometricGains scaled(GeometricGains gains, const Factors& by) {
  const auto across_and_up = [](Vec3& gain, double across, double up) {
    gain = gain.cwiseProduct(Vec3(across, across, up));
  };
  across_and_up(gains.position, by[0], by[1]);
  across_and_up(gains.velocity, by[2], by[3]);
  across_and_up(gains.attitude, by[4], 1);
  across_and_up(gains.rates, by[5], 1);
  return gains;
}

class Search {
 public:
  Search(std::span<const ReferenceTrack> tracks, const FlightOptions& base,
         const Disturbances& disturbances, const geom::Execution& run, int rounds)
      : tracks_(tracks), base_(base), disturbances_(disturbances), run_(run), rounds_(rounds) {}

  TuneResult result() {
    Factors at;
    at.fill(1);
    const double before = costs({at}).front();
    double best = before;
    double step = kFirstStep;
    for (int round = 0; round < rounds_ && step >= kLastStep; ++round) {
      if (run_.progress) {
        run_.progress(static_cast<std::size_t>(round), static_cast<std::size_t>(rounds_));
      }
      const std::vector<Factors> around = neighbours(at, step);
      const std::vector<double> found = costs(around);
      const auto least = std::min_element(found.begin(), found.end());
      if (*least < best) {
        best = *least;
        at = around[static_cast<std::size_t>(least - found.begin())];
      } else {
        step /= 2;
      }
    }
    TuneResult out{.gains = base_.gains, .improved = best < before, .flights = proofs_};
    if (out.improved) out.gains.geometric = scaled(base_.gains.geometric, at);
    if (is_proved(before)) out.before = before;
    if (is_proved(best)) out.cost = best;
    return out;
  }

 private:
  // The mean is above this as soon as one track has no proof.
  bool is_proved(double cost) const {
    return cost < 0.5 * kNoProof / static_cast<double>(tracks_.size());
  }

  static std::vector<Factors> neighbours(const Factors& at, double step) {
    std::vector<Factors> out;
    for (std::size_t k = 0; k < kParameters; ++k) {
      for (const double sign : {1.0, -1.0}) {
        Factors next = at;
        next[k] *= std::exp(sign * step);
        if (std::abs(std::log(next[k])) <= std::log(kMostTubeTuneFactor)) out.push_back(next);
      }
    }
    return out;
  }

  double cost(const Factors& factors, const ReferenceTrack& track) const {
    FlightOptions options = base_;
    options.gains.geometric = scaled(base_.gains.geometric, factors);
    const ProvedTube tube =
        prove_tube(track, options, disturbances_, {}, {.most_cells = kMostTubeTuneCells});
    if (!tube.trouble) return tube.largest;
    const double damping = std::isfinite(tube.damping) ? std::clamp(tube.damping, -1.0, 1.0) : -1;
    return kNoProof * (1 - 0.25 * damping);
  }

  std::vector<double> costs(const std::vector<Factors>& points) {
    std::vector<double> each(points.size() * tracks_.size());
    geom::parallel_for(each.size(), {run_.threads, {}}, [&](std::size_t i) {
      each[i] = cost(points[i / tracks_.size()], tracks_[i % tracks_.size()]);
    });
    proofs_ += each.size();
    std::vector<double> out(points.size(), 0);
    for (std::size_t i = 0; i < each.size(); ++i) {
      out[i / tracks_.size()] += each[i] / static_cast<double>(tracks_.size());
    }
    return out;
  }

  std::span<const ReferenceTrack> tracks_;
  const FlightOptions& base_;
  const Disturbances& disturbances_;
  const geom::Execution& run_;
  int rounds_;
  std::size_t proofs_ = 0;
};

}  // namespace

TuneResult tune_tube(std::span<const ReferenceTrack> tracks, const FlightOptions& base,
                     const Disturbances& disturbances, const geom::Execution& run, int rounds) {
  return Search(tracks, base, disturbances, run, rounds).result();
}

}  // namespace traj
