// moving_ai MAP.boxmap SCENARIOS: the optimal lengths of a Moving AI voxel scene against A* on the
// unit lattice of its voxels' centres (26 neighbours, a vehicle without extent). MAP is what
// skyway-import makes of the .3dmap. Wall time a query, after one that warms up.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <sstream>

#include "geom/map/box_map_file.h"
#include "plan/lattice/astar.h"
#include "plan/lattice/build_lattice.h"

namespace {

struct Scenario {
  plan::Index3 from;
  plan::Index3 to;
  double length = 0;
};

std::vector<Scenario> read(const char* file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);  // version
  std::getline(in, line);  // map
  std::vector<Scenario> out;
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    Scenario s;
    for (auto& v : s.from) fields >> v;
    for (auto& v : s.to) fields >> v;
    if (fields >> s.length) out.push_back(s);
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const geom::CollisionScene scene(geom::read_box_map(geom::ArrayArchive::map(argv[1])),
                                   {"box", geom::Vec3::Zero()}, 0);
  const plan::LatticeSpec spec{1, plan::Connectivity::twenty_six, geom::Vec3::Constant(0.5)};
  const plan::Lattice lattice = plan::build_lattice(scene, spec, {2, {}});
  plan::AstarSearch search(lattice);
  const auto scenarios = read(argv[2]);
  std::vector<double> times;
  std::size_t wrong = 0;
  double worst = 0;
  for (const Scenario& s : scenarios) {
    const auto node = [&](plan::Index3 i) {
      for (std::size_t k = 0; k < 3; ++k) i[k] -= lattice.first()[k];
      return lattice.node(i).value();
    };
    const plan::Terminal from[] = {{node(s.from), 0}};
    const plan::Terminal to[] = {{node(s.to), 0}};
    if (times.empty()) search.search(from, to);
    const auto begin = std::chrono::steady_clock::now();
    const plan::SearchResult result = search.search(from, to);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    times.push_back(took.count());
    const double off = result.found ? std::abs(result.cost - s.length) : HUGE_VAL;
    worst = std::max(worst, off);
    wrong += off > 1e-4;
  }
  if (times.empty()) return 2;
  double mean = 0;
  for (const double t : times) mean += t / static_cast<double>(times.size());
  std::sort(times.begin(), times.end());
  fmt::print(
      "scenarios {}, lengths off by more than 1e-4: {} (largest {:.1e}); ms mean {:.3f} p50 {:.3f} "
      "p99 {:.3f} max {:.3f}\n",
      times.size(), wrong, worst, mean, times[times.size() / 2], times[times.size() * 99 / 100],
      times.back());
  return wrong > 0;
}
