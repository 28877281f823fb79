// Queries of the collision structure in which something goes wrong: they throw, or their answer is
// right all the same.

#include "collision/queries.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <functional>
#include <limits>
#include <new>
#include <optional>
#include <sstream>
#include <thread>

#include "collision/groups.h"
#include "geom/archive/array_archive.h"
#include "geom/base/error.h"
#include "geom/collision/collision.h"
#include "geom/map/box_map_file.h"
#include "support/cases.h"
#include "support/failing_memory.h"
#include "support/random_city.h"
#include "support/small_map.h"

namespace geom {
namespace {

using support::FailingMemory;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Vehicle kVehicle{"box", {1, 1, 0.5}};
constexpr double kMargin = 0.25;

// A map of many groups, of which a budget of nothing keeps the last alone: queries build them anew.
constexpr CollisionOptions kManyGroups{0, 12};
constexpr CollisionOptions kOneGroup{std::size_t{1} << 29, 4096};

struct Place {
  Vec3 a;
  Vec3 b;
};

// What a query answers, in a form that is compared as a whole.
using Answer = std::vector<double>;

struct Query {
  const char* name;
  std::function<Answer(const CollisionScene&, const Place&)> ask;
  std::function<Answer(const CollisionScene&, const Place&)> brute_force;
};

bool meets_any(const CollisionScene& scene, const Place& at) {
  for (std::size_t i = 0; i < scene.map().size(); ++i) {
    if (segment_hits(at.a, at.b, scene.grown(i))) return true;
  }
  return false;
}

Answer flat(const std::vector<Nearest>& list) {
  Answer out;
  for (const Nearest& n : list) out.insert(out.end(), {static_cast<double>(n.box), n.distance});
  return out;
}

Answer nearest_of_all(const CollisionScene& scene, const Vec3& p, std::size_t count) {
  std::vector<Nearest> all;
  for (std::size_t i = 0; i < scene.map().size(); ++i) {
    all.push_back({i, distance(p, grow(scene.map().box(i), scene.vehicle().half))});
  }
  std::sort(all.begin(), all.end(), [](const Nearest& x, const Nearest& y) {
    return std::tie(x.distance, x.box) < std::tie(y.distance, y.box);
  });
  all.resize(std::min(count, all.size()));
  return flat(all);
}

Aabb region(const Place& at) { return {at.a.cwiseMin(at.b), at.a.cwiseMax(at.b)}; }

Answer meeting(const CollisionScene& scene, const Aabb& region) {
  Answer out;
  for (std::size_t i = 0; i < scene.map().size(); ++i) {
    if (overlap(region, scene.grown(i))) out.push_back(static_cast<double>(i));
  }
  return out;
}

constexpr double kReach = 15;
const Vec3 kSwept(2, 1.5, 1);

const Query kQueries[] = {
    {"hits",
     [](const CollisionScene& s, const Place& at) { return Answer{1.0 * s.hits(at.a, at.b)}; },
     [](const CollisionScene& s, const Place& at) { return Answer{1.0 * meets_any(s, at)}; }},
    {"free",
     [](const CollisionScene& s, const Place& at) { return Answer{1.0 * s.free(at.a, at.b)}; },
     [](const CollisionScene& s, const Place& at) {
       return Answer{1.0 * (s.inside_bounds(at.a) && s.inside_bounds(at.b) && !meets_any(s, at))};
     }},
    {"batch",
     [](const CollisionScene& s, const Place& at) {
       const std::vector<std::pair<Vec3, Vec3>> two{{at.a, at.b}, {at.b, at.b}};
       const auto hit = s.hits(two, {2, {}});
       return Answer{1.0 * hit[0], 1.0 * hit[1]};
     },
     [](const CollisionScene& s, const Place& at) {
       return Answer{1.0 * meets_any(s, at), 1.0 * meets_any(s, {at.b, at.b})};
     }},
    {"sweep",
     [](const CollisionScene& s, const Place& at) {
       return Answer{1.0 * s.sweep_hits(at.a, at.b, kSwept)};
     },
     [](const CollisionScene& s, const Place& at) {
       bool hit = false;
       for (std::size_t i = 0; i < s.map().size(); ++i) {
         hit = hit || segment_hits(at.a, at.b, grow(s.map().box(i), kSwept));
       }
       return Answer{1.0 * hit};
     }},
    {"nearest",
     [](const CollisionScene& s, const Place& at) {
       const auto one = s.nearest(at.a, kInfinity);
       return one ? flat({*one}) : Answer{};
     },
     [](const CollisionScene& s, const Place& at) { return nearest_of_all(s, at.a, 1); }},
    {"nearest nine",
     [](const CollisionScene& s, const Place& at) { return flat(s.nearest(at.a, kInfinity, 9)); },
     [](const CollisionScene& s, const Place& at) { return nearest_of_all(s, at.a, 9); }},
    {"region",
     [](const CollisionScene& s, const Place& at) {
       const auto found = s.boxes_meeting(region(at));
       return Answer(found.begin(), found.end());
     },
     [](const CollisionScene& s, const Place& at) { return meeting(s, region(at)); }},
    {"region with a limit",
     [](const CollisionScene& s, const Place& at) {
       const auto found = s.boxes_meeting(region(at), 3);
       return found ? Answer(found->begin(), found->end()) : Answer{-1};
     },
     [](const CollisionScene& s, const Place& at) {
       const Answer all = meeting(s, region(at));
       return all.size() > 3 ? Answer{-1} : all;
     }},
    {"planes",
     [](const CollisionScene& s, const Place& at) {
       Answer out;
       for (const auto& plane : s.separating_planes(at.a, at.b, kReach)) {
         out.push_back(static_cast<double>(plane.box));
       }
       std::sort(out.begin(), out.end());
       return out;
     },
     [](const CollisionScene& s, const Place& at) {
       Answer out;
       for (std::size_t i = 0; i < s.map().size(); ++i) {
         if (distance(at.a, at.b, s.grown(i)) <= kReach) out.push_back(static_cast<double>(i));
       }
       return out;
     }},
    {"empty box",
     [](const CollisionScene& s, const Place& at) {
       return Answer{1.0 * s.empty_box(at.a, at.a, kReach).has_value()};
     },
     [](const CollisionScene& s, const Place& at) {
       return Answer{1.0 * (s.inside_bounds(at.a) && !meets_any(s, {at.a, at.a}))};
     }},
};

Place place(support::Random& random) {
  const auto point = [&] {
    return Vec3(random.uniform(-300, 300), random.uniform(-300, 300), random.uniform(1, 65));
  };
  const Vec3 a = point();
  if (random.below(2)) return {a, point()};
  return {a, a + Vec3(random.uniform(-60, 60), random.uniform(-60, 60), random.uniform(0, 9))};
}

// Fails each allocation of the query in turn, and asks again once there is memory. Returns how
// many failed.
int fail_each_allocation(const Query& query, const CollisionScene& scene, const Place& at,
                         FailingMemory::Then then) {
  const Answer right = query.brute_force(scene, at);
  for (int n = 0;; ++n) {
    std::optional<Answer> answer;
    try {
      const FailingMemory short_of_memory(n, then);
      answer = query.ask(scene, at);
    } catch (const std::bad_alloc&) {
    } catch (const std::system_error&) {  // no thread
    }
    const bool failed = FailingMemory::any_failed();
    if (answer) {
      EXPECT_EQ(*answer, right) << query.name << ", allocation " << n << ", failed: " << failed;
    } else {
      EXPECT_TRUE(failed) << query.name;
    }
    EXPECT_EQ(query.ask(scene, at), right) << query.name << ", after allocation " << n;
    if (testing::Test::HasFailure()) return n;
    if (!failed) return n;
  }
}

class FailedAllocation : public testing::TestWithParam<FailingMemory::Then> {};

TEST_P(FailedAllocation, NeverChangesAnAnswer) {
  const BoxMap map = support::random_city(21, 300, 600);
  const CollisionScene many(map, kVehicle, kMargin, kManyGroups);
  int failures = 0;
  for (const Query& query : kQueries) {
    support::Random random(31);
    for (int i = 0; i < support::cases(12); ++i) {
      failures += fail_each_allocation(query, many, place(random), GetParam());
      if (HasFailure()) return;
      const CollisionScene one(map, kVehicle, kMargin, kOneGroup);  // is built once
      failures += fail_each_allocation(query, one, place(random), GetParam());
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(failures, 1000);
  RecordProperty("failures", failures);
}

TEST_P(FailedAllocation, OfTheConstructorIsThrown) {
  const BoxMap map = support::random_city(22, 200, 600);
  for (int n = 0;; ++n) {
    bool made = false;
    try {
      const FailingMemory short_of_memory(n, GetParam());
      const CollisionScene scene(map, kVehicle, kMargin, kManyGroups);
      made = true;
    } catch (const std::bad_alloc&) {
    }
    const bool failed = FailingMemory::any_failed();
    EXPECT_TRUE(made || failed);
    if (!failed || HasFailure()) {
      EXPECT_GT(n, 20);
      break;
    }
  }
}

// What a process makes once is made in the first scene, so each failure takes a process of its own.
TEST(FailedQuery, OfAProcessWhoseFirstSceneFailedIsRefused) {
  const BoxMap map = support::random_city(24, 200, 600);
  const Place at{{-300, -300, 5}, {300, 300, 5}};
  const auto ask = [&](long n) -> int {
    bool made = false;
    try {
      const FailingMemory short_of_memory(n, FailingMemory::Then::works);
      const CollisionScene scene(map, kVehicle, kMargin, kManyGroups);
      made = true;
    } catch (const std::bad_alloc&) {
    }
    if (!FailingMemory::any_failed()) return made ? 2 : 1;
    for (int again = 0; again < 2; ++again) {
      try {
        const CollisionScene scene(map, kVehicle, kMargin, kManyGroups);
        if (!scene.hits(at.a, at.b)) return 1;
      } catch (const std::bad_alloc&) {
      }
    }
    return 0;
  };
  int status = 0;
  long n = 0;
  for (; status == 0; ++n) {
    const pid_t child = fork();
    if (child == 0) {
      alarm(20);  // a process that hangs has failed
      _exit(ask(n));
    }
    ASSERT_EQ(waitpid(child, &status, 0), child);
  }
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 2)
      << "allocation " << n - 1 << ", status " << status;
  EXPECT_GT(n, 20);
}

INSTANTIATE_TEST_SUITE_P(MemoryThen, FailedAllocation,
                         testing::Values(FailingMemory::Then::works, FailingMemory::Then::fails));

// What counts as inside a group is never given up.
TEST(FailedQuery, LeavesNoGroupInUse) {
  CollisionScene::Impl impl(support::random_city(23, 300, 600), kVehicle, kMargin, kManyGroups);
  const Vec3 a(-300, -300, 5);
  const Vec3 b(300, 300, 5);
  for (int n = 0; n < 200; ++n) {
    try {
      const FailingMemory short_of_memory(n, FailingMemory::Then::works);
      hits_any(impl, a, b);
    } catch (const std::bad_alloc&) {
    }
  }
  for (const Group& group : impl.groups) EXPECT_EQ(group.users.load(), 0);
  std::size_t bytes = 0;
  std::size_t trees = 0;
  for (const Group& group : impl.groups) {
    const GroupTree* tree = group.tree.load();
    if (!tree) continue;
    ++trees;
    bytes += tree->bytes;
  }
  EXPECT_EQ(impl.bytes, bytes);
  EXPECT_EQ(impl.kept.size(), trees);
}

// A small map of many groups, which gets one tree of all its boxes once most were asked for.
BoxMap small_city() { return support::random_city(25, 2500, 600); }

Answer asked(const CollisionScene::Impl& impl, const Aabb& region) {
  const auto found =
      find_meeting(const_cast<CollisionScene::Impl&>(impl), region, impl.boxes.size());
  return {found->begin(), found->end()};
}

TEST(SmallMap, GetsOneTreeOnceMostOfItIsBuilt) {
  CollisionScene::Impl impl(small_city(), kVehicle, kMargin, {});
  ASSERT_GT(impl.groups.size(), 4u);
  EXPECT_EQ(whole_tree(impl), nullptr);
  asked(impl, {{-300, -300, 0}, {-290, -290, 60}});
  EXPECT_EQ(whole_tree(impl), nullptr);
  const Answer all = asked(impl, {{-400, -400, 0}, {400, 400, 120}});
  EXPECT_EQ(all.size(), impl.boxes.size());
  ASSERT_NE(whole_tree(impl), nullptr);
  EXPECT_EQ(whole_tree(impl)->count, impl.boxes.size());
  EXPECT_EQ(asked(impl, {{-400, -400, 0}, {400, 400, 120}}), all);
}

TEST(SmallMap, AnswersRightWhileItsTreeIsMade) {
  const BoxMap map = small_city();
  for (int round = 0; round < 4; ++round) {
    const CollisionScene scene(map, kVehicle, kMargin);
    std::vector<std::thread> threads;
    std::atomic<int> wrong = 0;
    for (int t = 0; t < 3; ++t) {
      threads.emplace_back([&, t] {
        support::Random random(static_cast<std::uint64_t>(100 * round + t));
        for (int i = 0; i < 20; ++i) {
          const Query& query = kQueries[random.below(std::size(kQueries))];
          const Place at = place(random);
          if (query.ask(scene, at) != query.brute_force(scene, at)) ++wrong;
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
  }
}

TEST_P(FailedAllocation, NeverChangesAnAnswerWhileATreeOfAllIsMade) {
  const BoxMap map = small_city();
  const Place across{{-300, -300, 5}, {300, 290, 40}};
  const Aabb everywhere = region(across);
  const Answer right = meeting(CollisionScene(map, kVehicle, kMargin), everywhere);
  int failures = 0;
  for (int n = 0;; ++n) {
    CollisionScene::Impl impl(map, kVehicle, kMargin, {});
    try {
      const FailingMemory short_of_memory(n, GetParam());
      EXPECT_EQ(asked(impl, everywhere), right) << "allocation " << n;
    } catch (const std::bad_alloc&) {
      ++failures;
    }
    const bool failed = FailingMemory::any_failed();
    EXPECT_EQ(asked(impl, everywhere), right) << "after allocation " << n;
    if (!failed || HasFailure()) break;
  }
  EXPECT_GT(failures, 20);
}

// The bytes of a map whose box of that lowest x has another one.
std::string with_lowest_x(const BoxMap& map, double x, double other) {
  std::ostringstream out;
  write_box_map(out, map);
  std::string bytes = std::move(out).str();
  char from[sizeof x];
  std::memcpy(from, &x, sizeof x);
  std::size_t count = 0;
  for (std::size_t at = 0; (at = bytes.find(from, at, sizeof x)) != std::string::npos; at += 8) {
    std::memcpy(&bytes[at], &other, sizeof other);
    ++count;
  }
  EXPECT_EQ(count, 1u);
  return bytes;
}

// A wrong value in a file hides the boxes of a whole group where it is lost.
TEST(FailedQuery, NearAWrongBoxOfAFileThrows) {
  std::vector<Aabb> boxes;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) {
      const Vec3 low(10 * x, 10 * y, 0);
      boxes.push_back({low, low + Vec3(6, 6, 30)});
    }
  }
  boxes[5050].min.x() = 503.1234567;  // in the middle; inside its tile's extent
  const BoxMap map = support::map_of({{0, 0, 0}, {1000, 1000, 100}}, boxes);
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity}) {
    const std::string bytes = with_lowest_x(map, 503.1234567, wrong);
    const auto read = [&] {
      return read_box_map(ArrayArchive::from_bytes(std::as_bytes(std::span(bytes)), "map"));
    };
    for (const Query& query : kQueries) {
      // Whoever looks first refuses: the constructor or the query. Again, for what was half built.
      std::optional<CollisionScene> scene;
      try {
        scene.emplace(read(), kVehicle, kMargin);
      } catch (const InputError&) {
        continue;
      }
      const Place at{{498, 507.5, 5}, {521, 508, 5}};  // the street beside it, and a wall
      for (int again = 0; again < 2; ++again) {
        EXPECT_THROW(query.ask(*scene, at), InputError) << query.name;
      }
    }
  }
}

}  // namespace
}  // namespace geom
