// roadmap_bench QUERIES.csv: planning with and without a roadmap, a query at a time on one thread:
// path length over the best known of the table, and thread CPU time, the least of 3, per set.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <map>
#include <sstream>

#include "geom/base/percentile.h"
#include "geom/base/thread_seconds.h"
#include "plan/planner/plan.h"
#include "support/bench_scene.h"

namespace {

using geom::Vec3;

struct Query {
  std::string set;
  Vec3 from;
  Vec3 to;
  double best = 0;
};

std::vector<Query> read(const char* file) {
  std::ifstream in(file);
  std::vector<Query> out;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    std::vector<std::string> f;
    for (std::string field; std::getline(fields, field, ',');) f.push_back(field);
    const auto at = [&](std::size_t i) { return std::stod(f[i]); };
    out.push_back({f[0], {at(2), at(3), at(4)}, {at(5), at(6), at(7)}, at(9)});
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const geom::CollisionScene& scene = support::scene();
  const auto begin = std::chrono::steady_clock::now();
  const plan::Roadmap roadmap = plan::build_roadmap(scene, {}, {2, {}});
  const std::chrono::duration<double> built = std::chrono::steady_clock::now() - begin;
  const double bytes = static_cast<double>(4 * roadmap.edge_to.size() + 34 * roadmap.bends());
  double brute = geom::thread_seconds();
  for (const auto& [a, b] : support::segments()) {
    if (support::brute_force(a, b) && !scene.hits(a, b)) return 1;
  }
  brute = (geom::thread_seconds() - brute) / static_cast<double>(support::segments().size());
  fmt::print("bends {} edges {} built in {:.2f} s, {:.0f} MB; a segment by brute force {:.1f} us\n",
             roadmap.bends(), roadmap.edges(), built.count(), bytes / 1e6, brute * 1e6);
  const auto queries = read(argv[1]);
  struct Kind {
    const char* name;
    plan::Quality quality;
    const plan::Roadmap* roadmap;
  };
  for (const auto& [name, quality, given] : {Kind{"fast", plan::Quality::fast, &roadmap},
                                             {"normal", plan::Quality::normal, &roadmap},
                                             {"best", plan::Quality::best, &roadmap},
                                             {"normal without", plan::Quality::normal, nullptr}}) {
    plan::Planner planner(scene, nullptr, given);
    plan::PlanOptions options;
    options.quality = quality;
    std::map<std::string, std::vector<double>> ratio;
    std::map<std::string, std::vector<double>> milliseconds;
    std::size_t missing = 0;
    for (const Query& q : queries) {
      double least = 1e9;
      for (int i = 0; i < 3; ++i) {
        const double start = geom::thread_seconds();
        const plan::PlanResult result = planner.plan(q.from, q.to, options);
        least = std::min(least, geom::thread_seconds() - start);
        if (i == 0) ratio[q.set].push_back(geom::length(result.path) / q.best);
        missing += result.status != geom::PathStatus::found;
      }
      milliseconds[q.set].push_back(1e3 * least);
    }
    if (missing) fmt::print("{}: {} plans found nothing\n", name, missing);
    for (const auto& [set, r] : ratio) {
      double mean = 0;
      for (const double x : r) mean += x / static_cast<double>(r.size());
      const auto& t = milliseconds[set];
      fmt::print(
          "{} {}: length mean {:.5f} p99 {:.4f} max {:.4f}; ms median {:.3f} p99 {:.3f} max "
          "{:.3f}\n",
          name, set, mean, geom::percentile(r, 0.99), geom::percentile(r, 1),
          geom::percentile(t, 0.5), geom::percentile(t, 0.99), geom::percentile(t, 1));
    }
  }
  return 0;
}
