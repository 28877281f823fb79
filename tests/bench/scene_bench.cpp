// scene_bench MAP [QUERIES [SEED]]: the collision structure beside a tree of eight and Embree
// alone, on the same grown boxes and questions, through the same exact predicates, in turns of a
// few hundred questions. Prints thread CPU time a question, the ratio to the best peer,
// and how many answers differ. Vehicle box:1,1,1.

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "embree_peer.h"
#include "geom/base/random.h"
#include "geom/base/thread_seconds.h"
#include "geom/collision/collision.h"
#include "geom/map/box_map_file.h"
#include "tree_peer.h"

namespace {

using geom::Aabb;
using geom::Vec3;

constexpr std::size_t kTurn = 256;
constexpr std::size_t kAtOnePlace = 2048;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Question {
  Vec3 a;
  Vec3 b;
};

// Segments of 5 to 50 m, 1 to 60 m above the ground: all over the map, or so many after each other
// within 100 m of a place.
std::vector<Question> questions(const Aabb& bounds, bool scattered, std::size_t count,
                                std::uint64_t seed) {
  geom::SplitMix64 random(seed);
  const auto between = [&](double low, double high) { return random.uniform(low, high); };
  Aabb around = bounds;
  std::vector<Question> out;
  while (out.size() < count) {
    if (!scattered && out.size() % kAtOnePlace == 0) {
      const Vec3 place(between(bounds.min[0], bounds.max[0]), between(bounds.min[1], bounds.max[1]),
                       0);
      around = {(place - Vec3::Constant(100)).cwiseMax(bounds.min),
                (place + Vec3::Constant(100)).cwiseMin(bounds.max)};
    }
    const Vec3 a(between(around.min[0], around.max[0]), between(around.min[1], around.max[1]),
                 between(1, 60));
    Vec3 d;
    do {
      d = {between(-1, 1), between(-1, 1), between(-0.3, 0.3)};
    } while (d.norm() > 1 || d.norm() < 0.1);
    out.push_back({a, a + d.normalized() * between(5, 50)});
  }
  return out;
}

// The sum of the answers in a turn, so that they can be compared.
using Ask = std::function<double(const Question&)>;

constexpr std::size_t kAsked = 3;

struct Asked {
  const char* what;
  std::array<Ask, kAsked> who;  // ourselves first
};

double sum(const std::vector<std::size_t>& found) {
  double out = static_cast<double>(found.size());
  for (const std::size_t i : found) out += 1e-3 * static_cast<double>(i % 1000);
  return out;
}

void compare(const Asked& asked, const char* where, std::span<const Question> list) {
  std::array<double, kAsked> seconds{};
  std::array<std::vector<double>, kAsked> answers;
  std::size_t differ = 0;
  for (const Question& q : list.first(std::min(list.size(), kTurn))) {
    for (const Ask& ask : asked.who) ask(q);
  }
  for (std::size_t begin = 0, turn = 0; begin < list.size(); begin += kTurn, ++turn) {
    const auto some = list.subspan(begin, std::min(kTurn, list.size() - begin));
    for (std::size_t k = 0; k < kAsked; ++k) {
      const std::size_t who = (k + turn) % kAsked;
      answers[who].clear();
      const double start = geom::thread_seconds();
      for (const Question& q : some) answers[who].push_back(asked.who[who](q));
      seconds[who] += geom::thread_seconds() - start;
    }
    for (std::size_t i = 0; i < some.size(); ++i) {
      const auto other = [&](const std::vector<double>& a) { return a[i] != answers[0][i]; };
      differ += std::any_of(answers.begin(), answers.end(), other) ? 1 : 0;
    }
  }
  fmt::print("{:13} {:9} |", asked.what, where);
  for (const double s : seconds) fmt::print(" {:7.0f}", 1e9 * s / static_cast<double>(list.size()));
  fmt::print(" | {:5.2f} | {}\n",
             seconds[0] / *std::min_element(seconds.begin() + 1, seconds.end()), differ);
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
  const Vec3 half(20, 20, 5);  // of a region
  const bench::TreePeer eight(grown);
  const bench::EmbreePeer embree(grown, half);
  const Aabb all = *geom::bounds(grown);
  const double start = geom::thread_seconds();
  for (std::size_t i = 0; i < map.size(); ++i) {  // builds every group
    const Vec3 p = map.box(i).min;
    static_cast<void>(scene.hits(p, p));
  }
  fmt::print("{} boxes; trees {} MB, touched in {:.2f} s\n", map.size(),
             scene.counts().most_bytes >> 20, geom::thread_seconds() - start);
  fmt::print("{:13} {:9} | {:>7} {:>7} {:>7} | ratio | differ\n", "ns", "", "Skyway", "eight",
             "Embree");
  const auto around = [&](const Question& q) { return Aabb{q.a - half, q.a + half}; };
  // `ask(peer, q)` of each of the two peers.
  const auto beside = [&](const char* what, Ask ours, const auto& ask) {
    return Asked{what,
                 {std::move(ours), [&eight, ask](const Question& q) { return ask(eight, q); },
                  [&embree, ask](const Question& q) { return ask(embree, q); }}};
  };
  const Asked kinds[] = {
      beside(
          "segment", [&](const Question& q) { return 1.0 * scene.hits(q.a, q.b); },
          [](const auto& peer, const Question& q) { return 1.0 * peer.hits(q.a, q.b); }),
      beside(
          "point", [&](const Question& q) { return 1.0 * scene.hits(q.a); },
          [](const auto& peer, const Question& q) { return 1.0 * peer.hits(q.a, q.a); }),
      beside(
          "nearest box", [&](const Question& q) { return scene.nearest(q.a, kInfinity)->distance; },
          [](const auto& peer, const Question& q) { return peer.nearest(q.a); }),
      beside(
          "region", [&](const Question& q) { return sum(scene.boxes_meeting(around(q))); },
          [around](const auto& peer, const Question& q) {
            return sum(peer.boxes_meeting(around(q)));
          }),
  };
  for (const bool scattered : {true, false}) {
    const auto list = questions(all, scattered, count, seed);
    for (const Asked& asked : kinds) compare(asked, scattered ? "scattered" : "local", list);
  }
}
