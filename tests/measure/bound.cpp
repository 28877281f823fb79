// bound MAP QUERIES GAP: lower bounds on the lengths of the paths that the planner finds without a
// roadmap, for box:1,1,1. For each set of queries (their ids
// without the number): how many closed, how many paths became shorter on the way, how many bounds
// lie above a best known length (none may), the largest gap, and thread CPU milliseconds of asking,
// the path not included, the least of 3 times: median, 95th percentile and the most. The first
// question, which looks at the whole map, stands alone.

#include "plan/bound/bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <numeric>
#include <vector>

#include "geom/base/thread_seconds.h"
#include "geom/map/box_map_file.h"
#include "geom/record/query_record.h"
#include "geom/shape/polyline.h"
#include "plan/planner/plan.h"

namespace {

struct Set {
  std::vector<double> ms;
  std::size_t closed = 0;
  std::size_t above = 0;
  std::size_t shortened = 0;
  double largest = 0;

  double rank(double share) const {
    const auto n = static_cast<std::size_t>(std::ceil(share * static_cast<double>(ms.size())));
    return ms[std::max<std::size_t>(n, 1) - 1];
  }
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const auto map = geom::read_box_map(geom::ArrayArchive::map(argv[1]));
  const geom::CollisionScene scene(map, {"box:1,1,1", {1, 1, 1}}, 0);
  std::ifstream in(argv[2]);
  const auto queries = geom::read_plan_queries(in, argv[2]);
  plan::BoundOptions options;
  options.gap = std::atof(argv[3]);
  plan::Planner planner(scene);
  plan::Bounder bounder(scene);
  std::map<std::string, Set> sets;
  bool first = true;
  for (const geom::PlanQuery& query : queries) {
    const double length = geom::length(planner.plan(query.from, query.to).path);
    if (length == 0) continue;
    const double begin = geom::thread_seconds();
    if (first) {
      bounder.ask(query.from, query.to, 2 * length, {options.gap, 1});
      fmt::print("first {:.3f} s\n", geom::thread_seconds() - begin);
      first = false;
    }
    plan::LengthBound found;
    double least = 1e9;
    for (int repeat = 0; repeat < 3; ++repeat) {
      const double asked = geom::thread_seconds();
      found = bounder.ask(query.from, query.to, length, options);
      least = std::min(least, geom::thread_seconds() - asked);
    }
    Set& set = sets[query.id.substr(0, query.id.rfind('-'))];
    set.ms.push_back(1e3 * least);
    set.closed += found.closed;
    set.shortened += !found.path.empty();
    set.above += query.best_known && found.bound > *query.best_known;
    set.largest = std::max(
        set.largest, (found.path.empty() ? length : geom::length(found.path)) / found.bound - 1);
  }
  for (auto& [name, set] : sets) {
    std::sort(set.ms.begin(), set.ms.end());
    fmt::print(
        "{}: {} of {} closed, {} after a shorter path, {} above the best known, largest gap "
        "{:.2e}, ms {:.2f} median, {:.2f} mean, {:.1f} p95, {:.0f} most\n",
        name, set.closed, set.ms.size(), set.shortened, set.above, set.largest, set.rank(0.5),
        std::accumulate(set.ms.begin(), set.ms.end(), 0.0) / static_cast<double>(set.ms.size()),
        set.rank(0.95), set.ms.back());
  }
}
