// grid_agents INSTANCE.yaml: the agents of one of libMultiRobotPlanning's benchmarks (a grid, a
// step a second, along the axes), by two means in one run. An agent waits outside until it enters,
// and is gone once it arrives, so that both have the same model.
//   prioritised   A* in space and time, one agent after another, who may wait or turn off anywhere:
//                 no two in a cell at once, none changing places
//   departures    each its shortest path at constant speed, later where it must, at any instant
// Two agents of a plan without conflicts are sqrt(1/2) cells apart or more, and of one with a
// conflict meet; so a cylinder of 0.7 asks the same of the curves. Both plans are proved by
// check_together().

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <deque>
#include <fstream>
#include <map>
#include <queue>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "traj/fleet/departures.h"
#include "traj/together/check_together.h"

namespace {

using Cell = std::array<int, 2>;
using Way = std::vector<Cell>;  // a cell a second, from when the agent enters

constexpr double kReach = 0.7;
constexpr int kHorizon = 10000;  // seconds

double cpu_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Grid {
  Cell size{};
  std::set<Cell> blocked;
  std::vector<Cell> from;
  std::vector<Cell> to;

  bool free(const Cell& c) const {
    return c[0] >= 0 && c[1] >= 0 && c[0] < size[0] && c[1] < size[1] && !blocked.contains(c);
  }
};

Grid read(const std::string& file) {
  std::ifstream in(file);
  const std::regex cell(R"((\w+|-):? *\[(\d+), *(\d+)\])");
  Grid grid;
  for (std::string line; std::getline(in, line);) {
    std::smatch found;
    if (!std::regex_search(line, found, cell)) continue;
    const Cell at{std::stoi(found[2]), std::stoi(found[3])};
    if (found[1] == "goal") grid.to.push_back(at);
    if (found[1] == "start") grid.from.push_back(at);
    if (found[1] == "dimensions") grid.size = at;
    if (found[1] == "-") grid.blocked.insert(at);
  }
  return grid;
}

std::array<Cell, 4> beside(const Cell& c) {
  return {{{c[0] + 1, c[1]}, {c[0] - 1, c[1]}, {c[0], c[1] + 1}, {c[0], c[1] - 1}}};
}

// Steps to the goal, of every cell that has a way.
std::map<Cell, int> steps_to(const Grid& grid, const Cell& goal) {
  std::map<Cell, int> steps{{goal, 0}};
  std::queue<Cell> open({goal});
  for (; !open.empty(); open.pop()) {
    for (const Cell& next : beside(open.front())) {
      if (grid.free(next) && steps.try_emplace(next, steps[open.front()] + 1).second) {
        open.push(next);
      }
    }
  }
  return steps;
}

Way shortest(const std::map<Cell, int>& steps, Cell at) {
  Way way{at};
  while (steps.at(at) > 0) {
    for (const Cell& next : beside(at)) {
      const auto found = steps.find(next);
      if (found == steps.end() || found->second >= steps.at(at)) continue;
      at = next;
      break;
    }
    way.push_back(at);
  }
  return way;
}

struct Plan {
  int enters = 0;
  Way way;

  double arrives() const { return enters + static_cast<double>(way.size()) - 1; }
};

// What agents before have taken.
class Taken {
 public:
  void add(const Plan& plan) {
    for (std::size_t i = 0; i < plan.way.size(); ++i) {
      const int t = plan.enters + static_cast<int>(i);
      cells_.insert({plan.way[i], t});
      if (i > 0) moves_.insert({plan.way[i - 1], plan.way[i], t});
    }
  }
  bool free(const Cell& c, int t) const { return !cells_.contains({c, t}); }
  bool free(const Cell& a, const Cell& b, int t) const {  // from a, at b at time t
    return free(b, t) && !moves_.contains({b, a, t});
  }

 private:
  std::set<std::pair<Cell, int>> cells_;
  std::set<std::tuple<Cell, Cell, int>> moves_;
};

// The earliest arrival.
Plan earliest(const Grid& grid, const std::map<Cell, int>& steps, const Cell& from,
              const Taken& taken) {
  struct Node {
    Cell cell;
    int time;
    int before;  // a node; -1: enters
  };
  std::vector<Node> nodes;
  using Open = std::tuple<int, int, int>;  // bound, less the time, node
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  std::set<std::pair<Cell, int>> seen;
  const auto push = [&](const Cell& cell, int time, int before) {
    if (!seen.insert({cell, time}).second) return;
    nodes.push_back({cell, time, before});
    open.push({time + steps.at(cell), -time, static_cast<int>(nodes.size()) - 1});
  };
  for (int entry = 0; entry < kHorizon; ++entry) {  // as long as nothing else is earlier
    if (taken.free(from, entry)) push(from, entry, -1);
    while (!open.empty() && std::get<0>(open.top()) <= entry + steps.at(from)) {
      const int at = std::get<2>(open.top());
      open.pop();
      const Node node = nodes[static_cast<std::size_t>(at)];
      if (steps.at(node.cell) == 0) {
        Plan plan;
        for (int i = at; i >= 0; i = nodes[static_cast<std::size_t>(i)].before) {
          plan.way.insert(plan.way.begin(), nodes[static_cast<std::size_t>(i)].cell);
          plan.enters = nodes[static_cast<std::size_t>(i)].time;
        }
        return plan;
      }
      if (taken.free(node.cell, node.time + 1)) push(node.cell, node.time + 1, at);
      for (const Cell& next : beside(node.cell)) {
        if (grid.free(next) && taken.free(node.cell, next, node.time + 1)) {
          push(next, node.time + 1, at);
        }
      }
    }
  }
  return {};
}

traj::Trajectory curve(const Way& way) {
  traj::Trajectory out;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const traj::Vec3 a(way[i - 1][0], way[i - 1][1], 0);
    const traj::Vec3 b(way[i][0], way[i][1], 0);
    traj::Segment& segment = out.segments.emplace_back();
    segment.duration = 1;
    for (int k = 0; k < traj::kPoints; ++k) segment.point[k] = a + (b - a) * (k / 7.0);
  }
  return out;
}

bool conflict(const Plan& a, const Plan& b) {
  const int from = std::max(a.enters, b.enters);
  const int to = static_cast<int>(std::min(a.arrives(), b.arrives()));
  for (int t = from; t <= to; ++t) {
    const auto at = [&](const Plan& p, int when) {
      return p.way[static_cast<std::size_t>(when - p.enters)];
    };
    if (at(a, t) == at(b, t)) return true;
    if (t > from && at(a, t) == at(b, t - 1) && at(b, t) == at(a, t - 1)) return true;
  }
  return false;
}

std::size_t conflicts(const std::vector<Plan>& plans) {
  std::size_t out = 0;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) out += conflict(plans[i], plans[k]);
  }
  return out;
}

traj::TogetherResult proved(const std::vector<traj::Trajectory>& curves,
                            const std::vector<double>& starts) {
  std::vector<traj::TimedFlight> flights;
  for (std::size_t i = 0; i < curves.size(); ++i)
    flights.push_back({&curves[i], starts[i], traj::Vec3::Zero()});
  return traj::check_together(flights, {{traj::cylinder(kReach, 1), {}}, traj::Parked::gone});
}

traj::TogetherResult proved(const std::vector<Plan>& plans) {
  std::vector<traj::Trajectory> curves;
  std::vector<double> starts;
  for (const Plan& plan : plans) {
    curves.push_back(curve(plan.way));
    starts.push_back(plan.enters);
  }
  return proved(curves, starts);
}

void by_departures(const std::vector<Plan>& plans, int rounds) {
  std::vector<traj::Trajectory> curves;
  for (const Plan& plan : plans) curves.push_back(curve(plan.way));
  std::vector<traj::FleetFlight> flights;
  for (std::uint32_t i = 0; i < curves.size(); ++i) {
    flights.push_back({&curves[i], traj::Vec3::Zero(), 0, kHorizon, 0, i});
  }
  const traj::Spacing spacing{traj::cylinder(kReach, 1), {}};
  const double begin = cpu_seconds();
  const auto forbidden = traj::fleet_conflicts(flights, spacing, traj::Parked::gone);
  const auto chosen = traj::choose_departures(flights, forbidden, {rounds, 0});
  const double took = cpu_seconds() - begin;
  double sum = 0;
  double last = 0;
  std::vector<double> starts;
  std::size_t refused = 0;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    refused += !chosen.of[i].start;
    starts.push_back(chosen.of[i].start.value_or(0));
    const double arrives = starts.back() + static_cast<double>(curves[i].segments.size());
    sum += arrives;
    last = std::max(last, arrives);
  }
  const double before = cpu_seconds();
  const auto proof = proved(curves, starts);
  fmt::print(
      "departures, {} rounds: {} refused, sum of arrivals {:.3f} s, last {:.3f} s, {:.2f} ms; {} "
      "of "
      "{} pairs refused by the proof, {:.2f} ms\n",
      rounds, refused, sum, last, 1e3 * took, proof.refused.size(), proof.pairs,
      1e3 * (cpu_seconds() - before));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const Grid grid = read(argv[1]);
  std::vector<Plan> alone;
  std::vector<Plan> prioritised;
  Taken taken;
  double took = 0;
  for (std::size_t i = 0; i < grid.from.size(); ++i) {
    const double begin = cpu_seconds();
    const auto steps = steps_to(grid, grid.to[i]);
    if (!steps.contains(grid.from[i])) return 1;
    prioritised.push_back(earliest(grid, steps, grid.from[i], taken));
    if (prioritised.back().way.empty()) return 1;
    taken.add(prioritised.back());
    took += cpu_seconds() - begin;
    alone.push_back({0, shortest(steps, grid.from[i])});
  }
  double sum = 0;
  double last = 0;
  double least = 0;
  for (const Plan& plan : prioritised) {
    sum += plan.arrives();
    last = std::max(last, plan.arrives());
  }
  for (const Plan& plan : alone) least += plan.arrives();
  fmt::print(
      "{} agents; alone the arrivals sum up to {} s, and {} pairs conflict; of the curves {}\n",
      alone.size(), least, conflicts(alone), proved(alone).refused.size());
  fmt::print(
      "prioritised: sum of arrivals {} s, last {} s, {:.2f} ms; {} pairs conflict, of the curves "
      "{}\n",
      sum, last, 1e3 * took, conflicts(prioritised), proved(prioritised).refused.size());
  for (const int rounds : {0, 20}) by_departures(alone, rounds);
  return 0;
}
