// together TRAJECTORIES H V [HZ]: every pair of flights (gone before and after) proved or refused,
// beside positions sampled HZ times a second (default 10), compared by a grid of H metres. Prints
// thread CPU times of one thread, the pairs that each finds, and those that the samples miss.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <deque>
#include <fstream>
#include <set>
#include <string>
#include <unordered_map>

#include "traj/record/trajectory_record.h"
#include "traj/together/check_together.h"

namespace {

using traj::FlightPair;
using traj::Vec3;

double cpu_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Sky {
  std::deque<traj::Trajectory> trajectories;
  std::vector<traj::TimedFlight> flights;
};

Sky read(const std::string& file) {
  std::ifstream in(file);
  Sky sky;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    const auto record = traj::parse_trajectory_record(line, file, number);
    if (record.status != traj::TrajectoryStatus::solved) continue;
    sky.trajectories.push_back(record.trajectory);
    sky.flights.push_back({&sky.trajectories.back(), record.time.starts(), Vec3::Zero()});
  }
  return sky;
}

struct Sample {
  std::uint32_t flight;
  Vec3 place;
};

// At one instant: pairs within the zone, by a grid.
class Instant {
 public:
  explicit Instant(const traj::Zone& zone) : zone_(zone) {}

  void compare(const std::vector<Sample>& samples, std::set<FlightPair>& found) {
    cells_.clear();
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto x = cell(samples[i].place.x());
      const auto y = cell(samples[i].place.y());
      for (long dx = -1; dx <= 1; ++dx) {
        for (long dy = -1; dy <= 1; ++dy) look(samples, i, key(x + dx, y + dy), found);
      }
      cells_[key(x, y)].push_back(i);
    }
  }

 private:
  long cell(double x) const { return static_cast<long>(std::floor(x / zone_.reach.x())); }
  static long key(long x, long y) { return x * 2000003 + y; }

  void look(const std::vector<Sample>& samples, std::size_t i, long at,
            std::set<FlightPair>& found) const {
    const auto others = cells_.find(at);
    if (others == cells_.end()) return;
    for (const std::size_t k : others->second) {
      if (traj::share_of(zone_, samples[i].place - samples[k].place) > 1) continue;
      found.insert(std::minmax(samples[i].flight, samples[k].flight));
    }
  }

  traj::Zone zone_;
  std::unordered_map<long, std::vector<std::size_t>> cells_;
};

std::set<FlightPair> sampled(const Sky& sky, const traj::Zone& zone, double rate) {
  struct Active {
    std::uint32_t flight;
    double end;
  };
  std::vector<std::uint32_t> order(sky.flights.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto starts = [&](std::uint32_t i) { return sky.flights[i].start; };
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return starts(a) < starts(b); });
  std::set<FlightPair> found;
  std::vector<Active> active;
  std::vector<Sample> samples;
  Instant instant(zone);
  std::size_t next = 0;
  auto step = static_cast<long>(std::ceil(starts(order[0]) * rate));
  for (; next < order.size() || !active.empty(); ++step) {
    const double t = static_cast<double>(step) / rate;
    for (; next < order.size() && starts(order[next]) <= t; ++next) {
      const std::uint32_t i = order[next];
      active.push_back({i, starts(i) + duration(*sky.flights[i].trajectory)});
    }
    std::erase_if(active, [&](const Active& one) { return one.end < t; });
    samples.clear();
    for (const Active& one : active) {
      const auto& flight = sky.flights[one.flight];
      samples.push_back({one.flight, evaluate(*flight.trajectory, t - flight.start).position});
    }
    instant.compare(samples, found);
  }
  return found;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  const Sky sky = read(argv[1]);
  const traj::TogetherRule rule{{traj::cylinder(std::stod(argv[2]), std::stod(argv[3])), {}},
                                traj::Parked::gone};
  const double rate = argc > 4 ? std::stod(argv[4]) : 10;
  double begin = cpu_seconds();
  const auto near = traj::near_pairs(sky.flights, rule.spacing, rule.parked);
  const double boxes = cpu_seconds() - begin;
  begin = cpu_seconds();
  const auto proved = traj::check_together(sky.flights, rule);
  const double all = cpu_seconds() - begin;
  begin = cpu_seconds();
  const auto found = sampled(sky, *rule.spacing.zone, rate);
  const double peer = cpu_seconds() - begin;
  std::set<FlightPair> refused;
  for (const auto& pair : proved.refused) refused.insert(pair.flights);
  std::size_t missed = 0;
  double deepest = 0;
  for (const auto& pair : proved.refused) {
    if (found.contains(pair.flights)) continue;
    ++missed;
    deepest = std::max(deepest, 1 - pair.result.share);
  }
  const auto more = std::count_if(found.begin(), found.end(),
                                  [&](const FlightPair& pair) { return !refused.contains(pair); });
  fmt::print(
      "{} flights, {} pairs: {} near by boxes ({:.2f} s), {} refused, all proved in {:.2f} s\n",
      sky.flights.size(), proved.pairs, near.size(), boxes, refused.size(), all);
  fmt::print(
      "{} Hz: {:.2f} s, {} pairs; misses {} (the deepest at {:.3f} of the separation), {} more\n",
      rate, peer, found.size(), missed, 1 - deepest, more);
  return more == 0 ? 0 : 1;
}
