#include "traj/flight/tune.h"

#include <cmath>
#include <functional>
#include <vector>

#include "geom/parallel.h"

namespace traj {
namespace {

constexpr double kFirstStep = 0.7;  // of the logarithm
constexpr double kLastStep = 0.05;
constexpr int kMostRounds = 60;
constexpr double kLost = 1e9;  // the cost of a lost flight

using Parameters = std::vector<double>;  // > 0
using Apply = std::function<void(const Parameters&, Gains&)>;
using Judge = std::function<double(const Flight&, const SetpointTrack&)>;

void set_xy(Vec3& gain, double xy, double z) { gain = Vec3(xy, xy, z); }

class Search {
 public:
  Search(std::span<const SetpointTrack> tracks, const FlightOptions& base,
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
      const SetpointTrack& track = tracks_[i % tracks_.size()];
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

  std::span<const SetpointTrack> tracks_;
  FlightOptions base_;
  geom::Execution run_;
  std::size_t flights_ = 0;
};

void apply_velocity(const Parameters& v, Gains& gains) {
  set_xy(gains.velocity.p, v[0], v[1]);
  set_xy(gains.velocity.i, v[2], v[3]);
  set_xy(gains.velocity.d, v[4], v[5]);
}

Parameters velocity_start(const Gains& gains) {
  const PidGains& v = gains.velocity;
  const auto positive = [](double value, double least) { return std::max(value, least); };
  return {positive(v.p.x(), 0.1),  positive(v.p.z(), 0.1),  positive(v.i.x(), 0.05),
          positive(v.i.z(), 0.05), positive(v.d.x(), 0.01), positive(v.d.z(), 0.01)};
}

double weighed(const FlightCost& cost, const Flight& flight, const SetpointTrack& track) {
  const Tracking t = tracking(flight, track.duration());
  return cost.mean * t.mean + cost.rms * t.rms + cost.p99 * t.p99 + cost.largest * t.largest +
         cost.final_distance * t.final_distance + cost.saturated * flight.saturated;
}

}  // namespace

TuneResult tune(std::span<const SetpointTrack> tracks, const FlightOptions& base,
                const FlightCost& cost, const geom::Execution& run) {
  FlightOptions open = base;
  open.gains.position = {};
  TuneResult out;
  out.gains = base.gains;
  Search inner(tracks, open, run);
  Parameters velocity = velocity_start(base.gains);
  out.velocity_cost = inner.improve(
      velocity, apply_velocity,
      [](const Flight& flight, const SetpointTrack&) { return flight.velocity_error; });
  apply_velocity(velocity, out.gains);
  FlightOptions closed = base;
  closed.gains = out.gains;
  Search outer(tracks, closed, run);
  Parameters position = {std::max(base.gains.position.p.x(), 0.1),
                         std::max(base.gains.position.p.z(), 0.1)};
  const Apply apply = [](const Parameters& p, Gains& gains) {
    set_xy(gains.position.p, p[0], p[1]);
  };
  out.cost = outer.improve(position, apply, [&](const Flight& flight, const SetpointTrack& track) {
    return weighed(cost, flight, track);
  });
  apply(position, out.gains);
  out.flights = inner.flights() + outer.flights();
  return out;
}

}  // namespace traj
