#include "traj/flight/tune.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "geom/base/parallel.h"

namespace traj {
namespace {

constexpr double kFirstStep = 0.7;  // of the logarithm
constexpr double kLastStep = 0.05;
constexpr int kMostRounds = 60;
constexpr double kLost = 1e9;  // the cost of a lost flight

using Parameters = std::vector<double>;  // > 0
using Apply = std::function<void(const Parameters&, Gains&)>;
using Judge = std::function<double(const Flight&, const ReferenceTrack&)>;

void set_xy(Vec3& gain, double xy, double z) { gain = Vec3(xy, xy, z); }

class Search {
 public:
  Search(std::span<const ReferenceTrack> tracks, const FlightOptions& base,
         const geom::Execution& run)
      : tracks_(tracks), base_(base), run_(run) {}

  // The best parameters from `at` on, and their cost.
  double improve(Parameters& at, const Apply& apply, const Judge& judge) {
    double best = costs({at}, apply, judge).front();
    double step = kFirstStep;
    for (int round = 0; round < kMostRounds && step > kLastStep; ++round) {
      std::vector<Parameters> around;
      for (std::size_t k = 0; k < at.size(); ++k) {
        for (const double sign : {1.0, -1.0}) {
          around.push_back(at);
          around.back()[k] *= std::exp(sign * step);
        }
      }
      const std::vector<double> found = costs(around, apply, judge);
      const auto least = std::min_element(found.begin(), found.end());
      if (*least < best) {
        best = *least;
        at = around[static_cast<std::size_t>(least - found.begin())];
      } else {
        step /= 2;
      }
    }
    return best;
  }

  std::size_t flights() const { return flights_; }

 private:
  std::vector<double> costs(const std::vector<Parameters>& points, const Apply& apply,
                            const Judge& judge) {
    std::vector<double> each(points.size() * tracks_.size());
    geom::parallel_for(each.size(), run_, [&](std::size_t i) {
      FlightOptions options = base_;
      apply(points[i / tracks_.size()], options.gains);
      const ReferenceTrack& track = tracks_[i % tracks_.size()];
      const Flight flight = simulate(track, options, {});
      each[i] = flight.lost ? kLost : judge(flight, track);
    });
    flights_ += each.size();
    std::vector<double> out(points.size(), 0);
    for (std::size_t i = 0; i < each.size(); ++i) {
      out[i / tracks_.size()] += each[i] / static_cast<double>(tracks_.size());
    }
    return out;
  }

  std::span<const ReferenceTrack> tracks_;
  FlightOptions base_;
  geom::Execution run_;
  std::size_t flights_ = 0;
};

void apply_velocity(ControlLaw law, const Parameters& v, Gains& gains) {
  if (law == ControlLaw::geometric) return set_xy(gains.geometric.velocity, v[0], v[1]);
  set_xy(gains.velocity.p, v[0], v[1]);
  set_xy(gains.velocity.i, v[2], v[3]);
  set_xy(gains.velocity.d, v[4], v[5]);
}

void apply_position(ControlLaw law, const Parameters& p, Gains& gains) {
  set_xy(law == ControlLaw::geometric ? gains.geometric.position : gains.position.p, p[0], p[1]);
}

// The gains across and up, at least `least`: a search on logarithms cannot start at 0.
Parameters across_and_up(const Vec3& gain, double least) {
  return {std::max(gain.x(), least), std::max(gain.z(), least)};
}

Parameters velocity_start(ControlLaw law, const Gains& gains) {
  if (law == ControlLaw::geometric) return across_and_up(gains.geometric.velocity, 0.1);
  Parameters out = across_and_up(gains.velocity.p, 0.1);
  for (const Parameters& more :
       {across_and_up(gains.velocity.i, 0.05), across_and_up(gains.velocity.d, 0.01)}) {
    out.insert(out.end(), more.begin(), more.end());
  }
  return out;
}

Parameters position_start(ControlLaw law, const Gains& gains) {
  return across_and_up(law == ControlLaw::geometric ? gains.geometric.position : gains.position.p,
                       0.1);
}

double weighed(const FlightCost& cost, const Flight& flight, const ReferenceTrack& track) {
  const Tracking t = tracking(flight, track.duration());
  return cost.mean * t.mean + cost.rms * t.rms + cost.p99 * t.p99 + cost.largest * t.largest +
         cost.final_distance * t.final_distance + cost.saturated * flight.saturated;
}

}  // namespace

TuneResult tune(std::span<const ReferenceTrack> tracks, const FlightOptions& base,
                const FlightCost& cost, const geom::Execution& run) {
  const ControlLaw law = base.law;
  FlightOptions open = base;
  open.gains.position = {};
  open.gains.geometric.position.setZero();
  Search inner(tracks, open, run);
  Parameters velocity = velocity_start(law, base.gains);
  const auto set_velocity = [&](const Parameters& v, Gains& g) { apply_velocity(law, v, g); };
  TuneResult out;
  out.velocity_cost = inner.improve(
      velocity, set_velocity,
      [](const Flight& flight, const ReferenceTrack&) { return flight.velocity_error; });
  FlightOptions closed = base;
  set_velocity(velocity, closed.gains);
  Search outer(tracks, closed, run);
  Parameters position = position_start(law, base.gains);
  const auto set_position = [&](const Parameters& p, Gains& g) { apply_position(law, p, g); };
  out.cost =
      outer.improve(position, set_position, [&](const Flight& flight, const ReferenceTrack& track) {
        return weighed(cost, flight, track);
      });
  out.gains = closed.gains;
  set_position(position, out.gains);
  out.flights = inner.flights() + outer.flights();
  return out;
}

}  // namespace traj
