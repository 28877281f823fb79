// scene_bench MAP [QUERIES [SEED]]: the collision structure beside Embree alone and a plain tree of
// eight, on the same grown boxes and questions, through the same exact predicates, in turns of a
// few hundred questions. Prints thread CPU time a question, ratios to the better peer, and how many
// answers differ. Vehicle box:1,1,1.

#include <fmt/format.h>
#include <time.h>

#include <cstdlib>
#include <functional>
#include <string>

#include "embree_peer.h"
#include "geom/base/random.h"
#include "geom/map/box_map_file.h"
#include "tree_peer.h"

namespace {

using geom::Aabb;
using geom::Vec3;

constexpr std::size_t kTurn = 256;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Question {
  Vec3 a;
  Vec3 b;
};

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Segments of 5 to 50 m, 1 to 60 m above the ground: all over the map, or within 200 m.
std::vector<Question> questions(const Aabb& bounds, bool scattered, std::size_t count,
                                std::uint64_t seed) {
  geom::SplitMix64 random(seed);
  const auto between = [&](double low, double high) { return random.uniform(low, high); };
  Vec3 low = bounds.min;
  Vec3 high = bounds.max;
  if (!scattered) {
    const Vec3 centre = 0.5 * (low + high);
    low.head<2>() = low.head<2>().cwiseMax(centre.head<2>() - Eigen::Vector2d::Constant(100));
    high.head<2>() = high.head<2>().cwiseMin(centre.head<2>() + Eigen::Vector2d::Constant(100));
  }
  std::vector<Question> out;
  while (out.size() < count) {
    const Vec3 a(between(low[0], high[0]), between(low[1], high[1]), between(1, 60));
    const Vec3 d(between(-1, 1), between(-1, 1), between(-0.3, 0.3));
    if (d.norm() > 1 || d.norm() < 0.1) continue;
    out.push_back({a, a + d.normalized() * between(5, 50)});
  }
  return out;
}

// The sum of the answers in a turn, so that they can be compared.
using Ask = std::function<double(const Question&)>;

struct Asked {
  const char* what;
  Ask ours;
  Ask embree;
  Ask tree;
};

double sum(const std::vector<std::size_t>& found) {
  double out = static_cast<double>(found.size());
  for (const std::size_t i : found) out += 1e-3 * static_cast<double>(i % 1000);
  return out;
}

void compare(const Asked& asked, const char* where, std::span<const Question> list) {
  const Ask* const all[] = {&asked.ours, &asked.embree, &asked.tree};
  double seconds[3] = {};
  std::size_t differ = 0;
  std::vector<double> answers[3];
  for (const Question& q : list.first(std::min(list.size(), kTurn))) {
    for (const Ask* ask : all) (*ask)(q);
  }
  for (std::size_t begin = 0, turn = 0; begin < list.size(); begin += kTurn, ++turn) {
    const auto some = list.subspan(begin, std::min(kTurn, list.size() - begin));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t who = (k + turn) % 3;
      answers[who].clear();
      const double start = thread_seconds();
      for (const Question& q : some) answers[who].push_back((*all[who])(q));
      seconds[who] += thread_seconds() - start;
    }
    for (std::size_t i = 0; i < some.size(); ++i) {
      differ += answers[0][i] != answers[1][i] || answers[0][i] != answers[2][i];
    }
  }
  const double each = 1e9 / static_cast<double>(list.size());
  fmt::print("{:13} {:9} | {:8.0f} {:8.0f} {:8.0f} | {:5.2f} | {}\n", asked.what, where,
             seconds[0] * each, seconds[1] * each, seconds[2] * each,
             seconds[0] / std::min(seconds[1], seconds[2]), differ);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const std::size_t count = argc > 2 ? static_cast<std::size_t>(std::atof(argv[2])) : 100000;
  const std::uint64_t seed = argc > 3 ? static_cast<std::uint64_t>(std::atoll(argv[3])) : 1;
  const geom::BoxMap map = geom::open_map(argv[1]);
  geom::CollisionOptions options;
  options.budget = std::size_t{1} << 40;
  const geom::CollisionScene scene(map, {"box:1,1,1", {1, 1, 1}}, 0, options);
  std::vector<Aabb> grown;
  for (std::size_t i = 0; i < map.size(); ++i) grown.push_back(scene.grown(i));
  const bench::EmbreePeer embree(grown);
  const bench::TreePeer tree(grown);
  const Aabb all = *geom::bounds(grown);
  const double start = thread_seconds();
  for (std::size_t i = 0; i < map.size(); ++i) {  // builds every group
    const Vec3 p = map.box(i).min;
    static_cast<void>(scene.hits(p, p));
  }
  fmt::print("{} boxes; trees {} MB, touched in {:.2f} s\n", map.size(),
             scene.counts().most_bytes >> 20, thread_seconds() - start);
  fmt::print("{:13} {:9} | {:>8} {:>8} {:>8} | ratio | differ\n", "ns", "", "Skyway", "Embree",
             "tree");
  const auto around = [](const Question& q) {
    return Aabb{q.a - Vec3(20, 20, 5), q.a + Vec3(20, 20, 5)};
  };
  const Asked kinds[] = {
      {"segment", [&](const Question& q) { return 1.0 * scene.hits(q.a, q.b); },
       [&](const Question& q) { return 1.0 * embree.hits(q.a, q.b); },
       [&](const Question& q) { return 1.0 * tree.hits(q.a, q.b); }},
      {"point", [&](const Question& q) { return 1.0 * scene.hits(q.a); },
       [&](const Question& q) { return 1.0 * embree.hits(q.a, q.a); },
       [&](const Question& q) { return 1.0 * tree.hits(q.a, q.a); }},
      {"nearest", [&](const Question& q) { return scene.nearest(q.a, kInfinity)->distance; },
       [&](const Question& q) { return embree.nearest(q.a); },
       [&](const Question& q) { return tree.nearest(q.a); }},
      {"boxes_meeting", [&](const Question& q) { return sum(scene.boxes_meeting(around(q))); },
       [&](const Question& q) { return sum(embree.boxes_meeting(around(q))); },
       [&](const Question& q) { return sum(tree.boxes_meeting(around(q))); }},
  };
  for (const bool scattered : {true, false}) {
    const auto list = questions(all, scattered, count, seed);
    for (const Asked& asked : kinds) compare(asked, scattered ? "scattered" : "local", list);
  }
}
