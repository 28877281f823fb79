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
    double best = cost(at, apply, judge);
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

  double cost(const Parameters& at, const Apply& apply, const Judge& judge) {
    return costs({at}, apply, judge).front();
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

// The position loop around the velocity loop of `gains`, and what the flights then cost.
struct Closed {
  Gains gains;
  double cost = 0;
  std::size_t flights = 0;
};

class ClosedLoops {
 public:
  ClosedLoops(std::span<const ReferenceTrack> tracks, const FlightOptions& base,
              const FlightCost& cost, const geom::Execution& run)
      : tracks_(tracks), base_(base), cost_(cost), run_(run) {}

  // As they are.
  Closed flown() const {
    Search search(tracks_, base_, run_);
    const double cost = search.cost(
        {}, [](const Parameters&, Gains&) {}, judge());
    return {base_.gains, cost, search.flights()};
  }

  Closed improved(const Gains& gains) const {
    FlightOptions options = base_;
    options.gains = gains;
    const auto apply = [&](const Parameters& p, Gains& g) { apply_position(base_.law, p, g); };
    Search search(tracks_, options, run_);
    Parameters position = position_start(base_.law, gains);
    Closed out{gains, search.improve(position, apply, judge()), search.flights()};
    apply(position, out.gains);
    return out;
  }

 private:
  Judge judge() const {
    return [this](const Flight& flight, const ReferenceTrack& track) {
      return weighed(cost_, flight, track);
    };
  }

  std::span<const ReferenceTrack> tracks_;
  const FlightOptions& base_;
  const FlightCost& cost_;
  const geom::Execution& run_;
};

}  // namespace

TuneResult tune(std::span<const ReferenceTrack> tracks, const FlightOptions& base,
                const FlightCost& cost, const geom::Execution& run) {
  const ControlLaw law = base.law;
  FlightOptions open = base;
  open.gains.position = {};
  open.gains.geometric.position.setZero();
  Search inner(tracks, open, run);
  Parameters velocity = velocity_start(law, base.gains);
  TuneResult out;
  out.velocity_cost = inner.improve(
      velocity, [&](const Parameters& v, Gains& g) { apply_velocity(law, v, g); },
      [](const Flight& flight, const ReferenceTrack&) { return flight.velocity_error; });
  out.flights = inner.flights();

  const ClosedLoops closed(tracks, base, cost, run);
  const Closed before = closed.flown();
  Closed best = before;
  const auto take = [&](const Closed& found) {
    out.flights += found.flights;
    if (found.cost < best.cost) best = found;
    out.improved = best.cost < before.cost;
  };
  take(before);
  Gains gains = base.gains;
  apply_velocity(law, velocity, gains);
  take(closed.improved(gains));
  if (!out.improved) take(closed.improved(base.gains));

  const double lost = kLost / static_cast<double>(tracks.size());
  if (before.cost < lost) out.before = before.cost;
  if (best.cost < lost) out.cost = best.cost;
  out.gains = best.gains;
  return out;
}

}  // namespace traj
