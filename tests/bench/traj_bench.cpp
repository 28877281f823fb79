// traj_bench MAP PATHS RHO...: trajectories (8 m/s, 6 m/s2) along path records, for each weight of
// snap: rungs, duration over length / v + v / a of the given path, CPU time of the solve and of the
// proof, and snap, by the prefix of the ids ("street-local-17").

#include <fmt/format.h>

#include <fstream>
#include <map>

#include "geom/base/percentile.h"
#include "geom/base/thread_seconds.h"
#include "geom/map/box_map_file.h"
#include "geom/record/record.h"
#include "traj/proof/check.h"
#include "traj/solve/solve.h"

namespace {

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

struct Set {
  std::size_t proved = 0;
  std::map<std::string, std::size_t> rungs;
  std::vector<double> ratio, seconds, check, snap;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  const geom::CollisionScene scene(geom::read_box_map(geom::ArrayArchive::map(argv[1])),
                                   {"box", {1, 1, 1}}, 0);
  std::vector<geom::PathRecord> paths;
  std::ifstream in(argv[2]);
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    paths.push_back(geom::parse_path_record(line, argv[2], ++number));
  }
  for (int k = 3; k < argc; ++k) {
    traj::SolveOptions options;
    options.limits[geom::Limit::speed] = 8;
    options.limits[geom::Limit::acceleration] = 6;
    options.rho = std::stod(argv[k]);
    std::map<std::string, Set> sets;
    for (const geom::PathRecord& path : paths) {
      if (path.status != geom::PathStatus::found) continue;
      Set& set = sets[path.id.substr(0, path.id.rfind('-'))];
      double start = geom::thread_seconds();
      const traj::SolveResult result = traj::solve(scene, path.points, options);
      set.seconds.push_back(geom::thread_seconds() - start);
      start = geom::thread_seconds();
      const bool ok = result.status == traj::SolveStatus::solved &&
                      traj::check(scene, result.trajectory, options.limits).ok;
      set.check.push_back(1e3 * (geom::thread_seconds() - start));
      set.proved += ok;
      if (result.rung) ++set.rungs[std::string(name(*result.rung))];
      set.ratio.push_back(traj::duration(result.trajectory) /
                          (geom::length(path.points) / 8 + 8.0 / 6));
      set.snap.push_back(result.snap);
    }
    for (const auto& [name, set] : sets) {
      std::string rungs;
      for (const auto& [rung, count] : set.rungs) rungs += fmt::format(" {} {}", rung, count);
      fmt::print(
          "rho {} {}: proved {} of {} ({}); duration ratio mean {:.4f} p90 {:.4f} max {:.4f}; "
          "seconds median {:.3f} p95 {:.3f} p99 {:.3f} max {:.3f}; proof ms median {:.2f} max "
          "{:.2f}; snap mean {:.0f}\n",
          argv[k], name, set.proved, set.ratio.size(), rungs, mean(set.ratio),
          geom::percentile(set.ratio, 0.9), geom::percentile(set.ratio, 1),
          geom::percentile(set.seconds, 0.5), geom::percentile(set.seconds, 0.95),
          geom::percentile(set.seconds, 0.99), geom::percentile(set.seconds, 1),
          geom::percentile(set.check, 0.5), geom::percentile(set.check, 1), mean(set.snap));
      std::fflush(stdout);
    }
  }
  return 0;
}
