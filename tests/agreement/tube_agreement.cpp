// tube_agreement CASES FLIGHTS [SEED] [TRAJECTORIES.jsonl or -] [geometric|cascade] [HOP]: proves
// tubes of CASES random flights (vehicle, trajectory, winds, gusts, masses, noise), or of the
// file's trajectories with random disturbances of quad2kg, and flies each FLIGHTS times under
// disturbances that are allowed: by chance, from one end to the other, and fitted to the vehicle's
// response. HOP is how far a random trajectory goes to each side (default 6 m): short ones allow
// many flights. Where there is no proof, a calmer flight is tried, up to kCalmer times.
// Exit 1 if a flight leaves its tube or saturates a motor. Also says how near to the
// tube's edge the flights came: 1 over that bounds how far too wide the tube is.

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <string>

#include "geom/base/parallel.h"
#include "geom/base/percentile.h"
#include "geom/base/thread_seconds.h"
#include "geom/text/json_fields.h"
#include "traj/disturbed_flight.h"
#include "traj/flight/vehicle_profile.h"
#include "traj/record/disturbance_record.h"
#include "traj/record/trajectory_record.h"

namespace {

using support::Random;
using traj::Vec3;

struct Case {
  std::string vehicle;
  traj::Trajectory trajectory;
  traj::FlightOptions options = {};
  traj::Disturbances disturbances = {};
};

struct Outcome {
  std::string none;     // why no tube is proved for all of what was asked for
  int calmer = 0;       // flights that were tried before there was one; kCalmer + 1: none
  double largest = 0;   // m
  double duration = 0;  // s
  double seconds = 0;   // of CPU
  std::size_t cells = 0;
  double share[3] = {0, 0, 0};  // of the radius that flights of each kind came to
  bool saturated = false;
};

// A hop over one or two bends, `far` metres to each side.
traj::Trajectory hop(Random& random, double speed, double far) {
  const auto somewhere = [&]() -> Vec3 {
    return far * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1) / 3);
  };
  traj::Trajectory out;
  traj::State from;
  for (int left = 1 + random.below(2); left >= 0; --left) {
    traj::State to;
    to.position = somewhere();
    if (left > 0) to.velocity = 0.4 * speed * traj::testing::direction(random);
    const double leg = (to.position - from.position).norm();
    out.segments.push_back(traj::hermite(from, to, std::max(1.0, 2.2 * leg / speed)));
    from = to;
  }
  return out;
}

traj::FlightOptions options_of(const std::string& vehicle, traj::ControlLaw law) {
  const auto profile = traj::vehicle_named(vehicle);
  traj::FlightOptions out{.quadrotor = *traj::quadrotor_of(profile->airframe)};
  out.gains = *profile->airframe.gains;
  out.law = law;
  return out;
}

Case random_case(std::uint64_t seed, traj::ControlLaw law, double far) {
  Random random(seed);
  Case c;
  c.vehicle = seed % 3 == 0 ? "crazyflie" : seed % 3 == 1 ? "quad2kg" : "tello";
  const bool large = c.vehicle == "quad2kg";
  const bool cascade = law == traj::ControlLaw::cascade;
  c.trajectory =
      hop(random, large ? random.uniform(2, cascade ? 5 : 8) : random.uniform(0.5, cascade ? 1 : 2),
          far);
  c.options = options_of(c.vehicle, law);
  c.options.hover = 1;
  c.options.settle = 0.5;
  // What has proofs: the cascade strays further, and Tello's geometric gains hardly damp.
  const double scale = c.vehicle == "tello" ? (cascade ? 0.1 : 0.05) : cascade ? 0.4 : 1;
  traj::Disturbances& d = c.disturbances;
  d.wind = random.uniform(0, large ? 4 : 1) * scale * traj::testing::direction(random);
  d.wind_spread = random.uniform(0, 0.4) * scale;
  d.gust_most = random.uniform(0, large ? 1.4 : 0.7) * scale;
  d.gust_lag = random.uniform(0.3, 3);
  d.mass_error = random.uniform(0, 0.01) * scale;
  const double noise = random.uniform(-1, 1) * scale;  // in half of the cases
  if (noise > 0) {
    d.gust_most *= 0.5;
    d.place_noise = (cascade ? 2e-3 : 5e-5) * noise;
    d.velocity_noise = (cascade ? 2e-3 : 2e-4) * noise;
    d.attitude_noise = (cascade ? 2e-3 : 1e-4) * noise;
    d.rate_noise = (cascade ? 4e-3 : 1e-3) * noise;
  }
  if (random.uniform(0, 1) < 0.5) return c;
  d.gust_most *= 0.3;
  d.drag_error = random.uniform(0, 0.05) * scale;
  d.motor_lag_error = random.uniform(0, 0.02) * scale;
  d.inertia_error = random.uniform(0, 0.02) * scale;
  d.gain_error = random.uniform(0, 0.01) * scale;
  d.start_error = random.uniform(0, cascade ? 0.02 : 0.0005) * scale;
  d.start_speed = random.uniform(0, cascade ? 0.02 : 0.0005) * scale;
  return c;
}

std::vector<Case> cases_of(const std::string& file, int count, std::uint64_t seed,
                           traj::ControlLaw law, double far) {
  std::vector<Case> out;
  if (file.empty()) {
    for (int i = 0; i < count; ++i) out.push_back(random_case(seed * 1000003 + i, law, far));
    return out;
  }
  std::ifstream in(file);
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    const auto record = traj::read_trajectory_record(geom::JsonFields(line, file, ++number));
    if (record.status != traj::TrajectoryStatus::solved) continue;
    if (static_cast<int>(out.size()) == count) break;
    Random random(seed * 1000003 + out.size());
    Case c{"quad2kg", record.trajectory, options_of("quad2kg", law)};
    c.disturbances = {.wind = random.uniform(0, 2) * traj::testing::direction(random),
                      .wind_spread = 0.2,
                      .gust_most = 0.5,
                      .mass_error = 0.005};
    out.push_back(std::move(c));
  }
  return out;
}

constexpr int kCalmer = 4;

// Half of all disturbances, and a flight that takes half as long again.
void calm(Case& c) {
  for (traj::Segment& segment : c.trajectory.segments) segment.duration *= 1.5;
  traj::Disturbances& d = c.disturbances;
  d.wind *= 0.5;
  for (const traj::DisturbanceRange& range : traj::kDisturbanceRanges) {
    if (range.value != &traj::Disturbances::gust_lag) d.*range.value *= 0.5;
  }
}

Outcome outcome(Case c, int flights, std::uint64_t seed) {
  Outcome out;
  traj::ProvedTube tube;
  for (; out.calmer <= kCalmer; ++out.calmer) {
    const traj::ReferenceTrack track(c.trajectory);
    out.duration = track.duration() + c.options.hover + c.options.settle;
    const double begin = geom::thread_seconds();
    tube = traj::prove_tube(track, c.options, c.disturbances, {.threads = 1}, {.most_cells = 8});
    out.seconds = geom::thread_seconds() - begin;
    if (!tube.trouble) break;
    if (out.none.empty()) {
      out.none =
          fmt::format("{} (damping {})", geom::word_of(traj::kTubeTroubleWords, tube.trouble->kind),
                      tube.damping < 0.1 ? "below 0.1" : "0.1 or more");
    }
    calm(c);
  }
  if (tube.trouble) return out;
  const traj::ReferenceTrack track(c.trajectory);
  out.largest = tube.largest;
  out.cells = tube.cells;
  Random random(seed);
  const traj::testing::References references(track, c.options);
  traj::testing::Fates fates(c.options, c.disturbances, track.duration());
  for (int k = 0; k < flights; ++k) {
    double& share = out.share[k % 3];
    std::size_t step = 0;
    out.saturated |= traj::testing::fly_seen(
        references, c.options, c.disturbances, fates.drawn(random, k % 3),
        [&](const traj::QuadrotorState& state, const traj::Reference& reference) {
          const double error = (state.position - reference.position).norm();
          share = std::max(share, traj::testing::share_of(tube, step++, error));
        });
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 100;
  const int flights = argc > 2 ? std::atoi(argv[2]) : 30;
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  const std::string file = argc > 4 && std::string(argv[4]) != "-" ? argv[4] : "";
  const auto law = argc > 5 ? geom::value_of(traj::kControlLawWords, argv[5])
                            : std::optional(traj::ControlLaw::geometric);
  const double far = argc > 6 ? std::atof(argv[6]) : 6;
  if (!law || !(far > 0)) return 2;
  const std::vector<Case> cases = cases_of(file, count, seed, *law, far);
  std::vector<Outcome> outcomes(cases.size());
  geom::parallel_for(cases.size(), {}, [&](std::size_t i) {
    outcomes[i] = outcome(cases[i], flights, seed * 7919 + i);
  });
  std::map<std::string, std::vector<double>> ratios;
  std::map<std::string, std::map<std::string, int>> none;
  std::map<std::string, int> never;
  int outside = 0;
  double cpu = 0, flown = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Outcome& o = outcomes[i];
    cpu += o.seconds, flown += o.duration;
    if (!o.none.empty()) ++none[cases[i].vehicle][o.none];
    if (o.calmer > kCalmer) {
      ++never[cases[i].vehicle];
      continue;
    }
    const double share = std::max({o.share[0], o.share[1], o.share[2]});
    if (share > 1 || o.saturated) {
      ++outside;
      fmt::print("case {}: {} leaves its tube: {:.6f} of the radius{}\n", i, cases[i].vehicle,
                 share, o.saturated ? ", a motor saturated" : "");
    }
    if (share > 0) ratios[cases[i].vehicle].push_back(1 / share);
  }
  for (auto& [vehicle, values] : ratios) {
    fmt::print("{}: {} tubes, proved over worst flown: median {:.3f}, most {:.3f}\n", vehicle,
               values.size(), geom::percentile(values, 0.5), geom::percentile(values, 1));
  }
  for (const auto& [vehicle, reasons] : none) {
    for (const auto& [reason, number] : reasons) {
      fmt::print("{}: {} without a proof at first: {}\n", vehicle, number, reason);
    }
  }
  for (const auto& [vehicle, number] : never) {
    fmt::print("{}: {} without a proof for the calmest flight\n", vehicle, number);
  }
  fmt::print("{} flights of each, {} cases outside; {:.3f} s of CPU a second of flight\n", flights,
             outside, cpu / flown);
  return outside ? 1 : 0;
}
