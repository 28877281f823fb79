// composition MAP METRES COUNT SEED: answers of the planner beside paths that are composed of three
// answers of its own: climb over 300 to 2,000 m, go level just above all boxes on the straight
// line, descend over as much; the shortest of these. For box:1,1,1, nothing prepared. Queries are
// drawn with street-level ends so far apart that do not see each other. For each quality: thread
// CPU milliseconds (median, 99th percentile and most), the length over the straight line and over
// the composed path (mean, 99th percentile and most), and how many paths are not free; the first
// twenty queries' also by brute force, on maps of up to two million boxes.

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <vector>

#include "geom/base/percentile.h"
#include "geom/base/thread_seconds.h"
#include "geom/map/box_map_file.h"
#include "geom/record/query_record.h"
#include "geom/shape/polyline.h"
#include "plan/bench/query_set.h"
#include "plan/planner/plan.h"

namespace {

using geom::Polyline;
using geom::Vec3;

std::vector<geom::PlanQuery> queries_of(const geom::CollisionScene& scene, char** argv) {
  const double length = std::atof(argv[2]);
  plan::bench::QuerySet drawn(scene, {.ends = plan::bench::Ends::street_blocked,
                                      .length = std::pair(length, length + 1),
                                      .seed = static_cast<std::uint64_t>(std::atoll(argv[4]))});
  std::vector<geom::PlanQuery> out;
  for (int i = 0; i < std::atoi(argv[3]); ++i) {
    out.push_back(drawn.at(static_cast<std::size_t>(i)));
  }
  return out;
}

// The least height at which the segment between two places, both taken there, is free.
std::optional<double> level_height(const geom::CollisionScene& scene, Vec3 a, Vec3 b) {
  a.z() = b.z() = scene.free_bounds()->min.z();
  while (const auto box = scene.blocker(a, b)) a.z() = b.z() = box->max.z() + 1e-3;
  if (!scene.free(a, b)) return std::nullopt;
  return a.z();
}

Polyline composed(const geom::CollisionScene& scene, plan::Planner& planner, const Vec3& from,
                  const Vec3& to, double climb) {
  const double share = climb / (to - from).norm();
  if (share > 0.45) return {};
  Vec3 up = from + share * (to - from);
  Vec3 down = to + share * (from - to);
  const auto height = level_height(scene, up, down);
  if (!height) return {};
  up.z() = down.z() = *height;
  Polyline path = planner.plan(from, up).path;
  const Polyline rest = planner.plan(down, to).path;
  if (path.empty() || rest.empty()) return {};
  path.insert(path.end(), rest.begin(), rest.end());
  return path;
}

bool is_free(const geom::CollisionScene& scene, const Polyline& path) {
  for (std::size_t leg = 1; leg < path.size(); ++leg) {
    if (!scene.inside_bounds(path[leg - 1]) || !scene.inside_bounds(path[leg])) return false;
    for (std::size_t i = 0; i < scene.map().size(); ++i) {
      if (geom::segment_hits(path[leg - 1], path[leg], scene.grown(i))) return false;
    }
  }
  return true;
}

struct Column {
  std::vector<double> ms, straight, composed;
  std::size_t missing = 0;
  std::size_t wrong = 0;
};

std::string spread(const std::vector<double>& ratios) {
  if (ratios.empty()) return "-";
  const double sum = std::accumulate(ratios.begin(), ratios.end(), 0.0);
  return fmt::format("{:.5f} {:.4f} {:.4f}", sum / static_cast<double>(ratios.size()),
                     geom::percentile(ratios, 0.99), geom::percentile(ratios, 1));
}

void print(const std::string& name, const Column& column) {
  if (column.ms.empty()) return;
  fmt::print("{:8} ms {:8.3f} {:8.3f} {:8.3f}  straight {}  composed {}{}{}\n", name,
             geom::percentile(column.ms, 0.5), geom::percentile(column.ms, 0.99),
             geom::percentile(column.ms, 1), spread(column.straight), spread(column.composed),
             column.missing ? fmt::format("  {} MISSING", column.missing) : "",
             column.wrong ? fmt::format("  {} NOT FREE", column.wrong) : "");
}

constexpr std::array kClimbs = {300.0, 600.0, 1000.0, 2000.0};  // metres
constexpr std::size_t kBrute = 20;                              // queries
constexpr std::size_t kBruteBoxes = 2'000'000;

void add(Column& column, const geom::CollisionScene& scene, const geom::PlanQuery& query,
         const Polyline& path, double ms, double composed) {
  column.ms.push_back(ms);
  if (path.empty()) {
    ++column.missing;
    return;
  }
  column.wrong += path.front() != query.from || path.back() != query.to;
  for (std::size_t i = 1; i < path.size(); ++i) column.wrong += !scene.free(path[i - 1], path[i]);
  if (column.ms.size() <= kBrute && scene.map().size() <= kBruteBoxes)
    column.wrong += !is_free(scene, path);
  const double length = geom::length(path);
  column.straight.push_back(length / (query.to - query.from).norm());
  if (composed > 0) column.composed.push_back(length / composed);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const auto map = geom::read_box_map(geom::ArrayArchive::map(argv[1]));
  const geom::CollisionScene scene(map, {"box:1,1,1", {1, 1, 1}}, 0);
  plan::Planner planner(scene);
  Column put_together;
  std::array<Column, 3> by_quality;
  for (const geom::PlanQuery& query : queries_of(scene, argv)) {
    Polyline best;
    double composing = 0;
    for (const double climb : kClimbs) {
      const double begin = geom::thread_seconds();
      Polyline path = composed(scene, planner, query.from, query.to, climb);
      const double seconds = geom::thread_seconds() - begin;
      if (path.empty()) continue;
      if (!best.empty() && geom::length(best) <= geom::length(path)) continue;
      best = std::move(path);
      composing = seconds;
    }
    const double shortest = best.empty() ? 0 : geom::length(best);
    if (!best.empty()) add(put_together, scene, query, best, 1e3 * composing, shortest);
    for (std::size_t i = 0; i < 3; ++i) {
      plan::PlanOptions options;
      options.quality = plan::kQualityWords[i].value;
      const double begin = geom::thread_seconds();
      const Polyline path = planner.plan(query.from, query.to, options).path;
      const double seconds = geom::thread_seconds() - begin;
      add(by_quality[i], scene, query, path, 1e3 * seconds, shortest);
    }
  }
  print("composed", put_together);
  for (std::size_t i = 0; i < 3; ++i) {
    print(std::string(plan::kQualityWords[i].word), by_quality[i]);
  }
}
