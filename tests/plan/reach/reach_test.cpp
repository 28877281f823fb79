#include "plan/reach/reach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <set>
#include <vector>

#include "geom/base/error.h"
#include "plan/scenes.h"
#include "reach/free_cells.h"
#include "support/cases.h"
#include "support/random_city.h"

namespace plan {
namespace {

using geom::Aabb;
using geom::CollisionScene;

constexpr int kSide = 5;  // metres, of small maps whose faces all lie on whole metres

Aabb room(double side) { return {{0, 0, 0}, Vec3::Constant(side)}; }

// Boxes on whole metres, some flat.
std::vector<Aabb> whole_boxes(support::Random& random, int count) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < count; ++i) {
    Aabb box;
    for (int k = 0; k < 3; ++k) {
      box.min[k] = random.below(kSide);
      box.max[k] = std::min<double>(kSide, box.min[k] + random.below(4));
    }
    boxes.push_back(box);
  }
  return boxes;
}

// Free space of such a map by cubes of one metre, which boxes fill or leave whole.
class UnitCells {
 public:
  explicit UnitCells(const std::vector<Aabb>& boxes) : boxes_(boxes) {
    for (int i = 0; i < kSide * kSide * kSide; ++i) part_[i] = blocked(place(i)) ? -1 : 0;
    int parts = 0;
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
      if (part_[i] == 0) fill(i, ++parts);
    }
  }

  static Vec3 place(int i) {
    return {i % kSide + 0.5, i / kSide % kSide + 0.5, i / (kSide * kSide) + 0.5};
  }
  int part(int i) const { return part_[i]; }  // -1: blocked

 private:
  bool blocked(const Vec3& p) const {
    return std::any_of(boxes_.begin(), boxes_.end(),
                       [&](const Aabb& box) { return geom::contains(box, p); });
  }

  void fill(int first, int part) {
    std::queue<int> left;
    part_[first] = part;
    for (left.push(first); !left.empty(); left.pop()) {
      const int i = left.front();
      const std::array<int, 3> step = {1, kSide, kSide * kSide};
      const std::array<int, 3> at = {i % kSide, i / kSide % kSide, i / (kSide * kSide)};
      for (int k = 0; k < 3; ++k) {
        for (const int way : {-1, 1}) {
          if (at[k] + way < 0 || at[k] + way >= kSide) continue;
          const int next = i + way * step[k];
          if (part_[next] != 0 || blocked(0.5 * (place(i) + place(next)))) continue;
          part_[next] = part;
          left.push(next);
        }
      }
    }
  }

  const std::vector<Aabb>& boxes_;
  std::array<int, kSide * kSide * kSide> part_{};
};

bool has_inside(const Aabb& box) { return (box.max.array() > box.min.array()).all(); }

// Whether two boxes share a part of a face that has an area.
bool share_face(const Aabb& a, const Aabb& b) {
  int touching = 0;
  int overlapping = 0;
  for (int k = 0; k < 3; ++k) {
    touching += a.max[k] == b.min[k] || b.max[k] == a.min[k];
    overlapping += a.max[k] > b.min[k] && b.max[k] > a.min[k];
  }
  return touching == 1 && overlapping == 2;
}

bool free_inside(const CollisionScene& scene, const Aabb& cell) {
  for (std::size_t i = 0; i < scene.map().size(); ++i) {
    const Aabb box = scene.grown(i);
    if ((box.min.array() < cell.max.array()).all() && (box.max.array() > cell.min.array()).all()) {
      return false;
    }
  }
  return true;
}

// Whether all of a face of `cell` is against the bounds, another cell or a grown box: of the grid
// that all their edges make on the face, each field is.
bool face_closed(const CollisionScene& scene, const std::vector<Aabb>& cells, const Aabb& cell,
                 int axis, bool up) {
  const double at = up ? cell.max[axis] : cell.min[axis];
  const Aabb& bounds = *scene.free_bounds();
  if (at == (up ? bounds.max[axis] : bounds.min[axis])) return true;
  std::vector<Aabb> covers;
  for (const Aabb& other : cells) {
    if ((up ? other.min[axis] : other.max[axis]) == at) covers.push_back(other);
  }
  for (std::size_t i = 0; i < scene.map().size(); ++i) {
    const Aabb box = scene.grown(i);
    if (box.min[axis] <= at && at <= box.max[axis]) covers.push_back(box);
  }
  const std::array<int, 2> across = {(axis + 1) % 3, (axis + 2) % 3};
  std::array<std::set<double>, 2> lines;
  for (int k = 0; k < 2; ++k) {
    const int a = across[k];
    lines[k] = {cell.min[a], cell.max[a]};
    for (const Aabb& c : covers) {
      for (const double v : {c.min[a], c.max[a]}) {
        if (cell.min[a] < v && v < cell.max[a]) lines[k].insert(v);
      }
    }
  }
  for (auto x = lines[0].begin(); std::next(x) != lines[0].end(); ++x) {
    for (auto y = lines[1].begin(); std::next(y) != lines[1].end(); ++y) {
      const bool covered = std::any_of(covers.begin(), covers.end(), [&](const Aabb& c) {
        return c.min[across[0]] <= *x && c.max[across[0]] >= *std::next(x) &&
               c.min[across[1]] <= *y && c.max[across[1]] >= *std::next(y);
      });
      if (!covered) return false;
    }
  }
  return true;
}

void expect_enclosed(const CollisionScene& scene, const std::vector<Aabb>& cells) {
  for (const Aabb& cell : cells) {
    EXPECT_TRUE(has_inside(cell));
    for (int axis = 0; axis < 3; ++axis) {
      for (const bool up : {false, true}) {
        EXPECT_TRUE(face_closed(scene, cells, cell, axis, up));
      }
    }
  }
}

void expect_chain(const CollisionScene& scene, const ReachResult& result, const Vec3& from,
                  const Vec3& to) {
  ASSERT_FALSE(result.cells.empty());
  EXPECT_TRUE(geom::contains(result.cells.front(), from));
  EXPECT_TRUE(geom::contains(result.cells.back(), to));
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    EXPECT_TRUE(free_inside(scene, result.cells[i]));
    if (i > 0) {
      EXPECT_TRUE(share_face(result.cells[i - 1], result.cells[i]));
    }
  }
  const auto way = way_through(result.cells, from, to);
  EXPECT_EQ(way.front(), from);
  EXPECT_EQ(way.back(), to);
  for (std::size_t i = 1; i < way.size(); ++i) EXPECT_TRUE(scene.free(way[i - 1], way[i]));
}

bool holds(const std::vector<Aabb>& cells, const Vec3& p) {
  return std::any_of(cells.begin(), cells.end(),
                     [&](const Aabb& cell) { return geom::contains(cell, p); });
}

TEST(ReachProperty, IsWhatUnitCellsSay) {
  support::Random random(19);
  int apart = 0;
  int joined = 0;
  for (int i = 0; i < support::cases(2000); ++i) {
    SCOPED_TRACE(testing::Message() << "seed 19, case " << i);
    const auto boxes = whole_boxes(random, 8 + static_cast<int>(random.below(40)));
    const UnitCells cells(boxes);
    const auto scene = scene_of(boxes, room(kSide));
    Reach reach(scene);
    std::vector<int> free;
    for (int k = 0; k < kSide * kSide * kSide; ++k) {
      if (cells.part(k) > 0) free.push_back(k);
    }
    if (free.empty()) continue;
    for (int k = 0; k < 3; ++k) {
      const int a = free[random.below(free.size())];
      const int b = free[random.below(free.size())];
      const Vec3 from = UnitCells::place(a);
      const Vec3 to = UnitCells::place(b);
      const ReachResult result = reach.ask(from, to);
      if (cells.part(a) == cells.part(b)) {
        ++joined;
        ASSERT_EQ(result.answer, Reachable::yes);
        expect_chain(scene, result, from, to);
      } else {
        ++apart;
        ASSERT_EQ(result.answer, Reachable::no);
        EXPECT_TRUE(holds(result.cells, result.from_start ? from : to));
        EXPECT_FALSE(holds(result.cells, result.from_start ? to : from));
        expect_enclosed(scene, result.cells);
      }
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(apart, 200);
  EXPECT_GT(joined, 500);
}

// All cells that are reached from that of a point.
std::set<std::uint32_t> flooded(FreeCells& cells, const Vec3& from) {
  std::set<std::uint32_t> met = {cells.cell_at(from)};
  std::vector<std::uint32_t> near;
  for (std::queue<std::uint32_t> left({*met.begin()}); !left.empty(); left.pop()) {
    cells.neighbours(left.front(), near);
    for (const std::uint32_t cell : near) {
      if (met.insert(cell).second) left.push(cell);
    }
  }
  return met;
}

TEST(ReachProperty, IsTheSameWhereRegionsOfManyBoxesAreHalved) {
  support::Random random(21);
  int apart = 0;
  int joined = 0;
  for (int i = 0; i < support::cases(1000); ++i) {
    SCOPED_TRACE(testing::Message() << "seed 21, case " << i);
    const auto boxes = whole_boxes(random, 8 + static_cast<int>(random.below(40)));
    const UnitCells units(boxes);
    const auto scene = scene_of(boxes, room(kSide));
    const Listed most{static_cast<std::size_t>(random.below(6)), random.uniform(0.3, 3)};
    FreeCells cells(scene, most);
    std::vector<int> free;
    for (int k = 0; k < kSide * kSide * kSide; ++k) {
      ASSERT_EQ(cells.is_free(cells.cell_at(UnitCells::place(k))), units.part(k) > 0);
      if (units.part(k) > 0) free.push_back(k);
    }
    if (free.empty()) continue;
    const int a = free[random.below(static_cast<int>(free.size()))];
    const auto from_a = flooded(cells, UnitCells::place(a));
    for (const int b : free) {
      const bool together = units.part(a) == units.part(b);
      ASSERT_EQ(from_a.contains(cells.cell_at(UnitCells::place(b))), together);
      ++(together ? joined : apart);
    }
  }
  EXPECT_GT(apart, 1000);
  EXPECT_GT(joined, 1000);
}

TEST(ReachProperty, IsTheSameWhateverWasAskedBefore) {
  support::Random random(20);
  for (int i = 0; i < 20; ++i) {
    const auto scene = random_scene(100 + i, 60, 12, Vec3::Constant(0.2));
    std::vector<Vec3> free;
    while (free.size() < 12) {
      const Vec3 p(random.uniform(0.2, 11.8), random.uniform(0.2, 11.8), random.uniform(0.2, 11.8));
      if (scene.free(p)) free.push_back(p);
    }
    Reach used(scene);
    for (std::size_t k = 1; k < free.size(); ++k) {
      Reach fresh(scene);
      const auto a = fresh.ask(free[k - 1], free[k]);
      const auto b = used.ask(free[k - 1], free[k]);
      EXPECT_EQ(a.answer, b.answer);
      EXPECT_EQ(a.cells, b.cells);
      EXPECT_EQ(a.looked_at, b.looked_at);
    }
  }
}

// A wall across a room of 10 m with a slit of `width` in it.
std::vector<Aabb> slit(double width) {
  return {{{4, 0, 0}, {5, 5, 10}}, {{4, 5 + width, 0}, {5, 10, 10}}};
}

TEST(Reach, PassesASlitOfAMillimetreAndNoWallThatTouches) {
  const Vec3 from(1, 1, 1);
  const Vec3 to(9, 9, 9);
  const auto open = scene_of(slit(1e-3), room(10));
  const auto found = Reach(open).ask(from, to);
  ASSERT_EQ(found.answer, Reachable::yes);
  expect_chain(open, found, from, to);
  const auto closed = scene_of(slit(0), room(10));
  EXPECT_EQ(Reach(closed).ask(from, to).answer, Reachable::no);
}

// The largest box below the far wall that leaves a gap, and the next larger one.
TEST(Reach, GoesByTheSmallestGapThatGrownBoxesLeave) {
  const auto with_top = [](double y) {
    auto boxes = slit(1e-3);
    boxes.push_back({{4, 2, 0}, {5, y, 10}});
    return scene_of(boxes, room(10));
  };
  const auto gap_of = [](const CollisionScene& scene) {
    double low = 0;
    double high = 10;
    for (std::size_t i = 0; i < scene.map().size(); ++i) {
      const Aabb box = scene.grown(i);
      if (box.min.y() < 5) {
        low = std::max(low, box.max.y());
      } else {
        high = std::min(high, box.min.y());
      }
    }
    return high - low;
  };
  const auto leaves_gap = [&](double y) { return gap_of(with_top(y)) > 0; };
  double open = 5;
  double shut = 5 + 1e-3;
  ASSERT_TRUE(leaves_gap(open));
  ASSERT_FALSE(leaves_gap(shut));
  while (std::nextafter(open, shut) < shut) {
    const double y = open + 0.5 * (shut - open);
    (leaves_gap(y) ? open : shut) = y;
  }
  const auto narrow = with_top(open);
  EXPECT_LT(gap_of(narrow), 1e-14);
  EXPECT_EQ(Reach(narrow).ask({1, 1, 1}, {9, 9, 9}).answer, Reachable::yes);
  EXPECT_EQ(Reach(with_top(shut)).ask({1, 1, 1}, {9, 9, 9}).answer, Reachable::no);
}

TEST(Reach, TellsWhichEndIsEnclosed) {
  // A closed shell around (5, 5, 5).
  std::vector<Aabb> shell;
  for (int k = 0; k < 3; ++k) {
    for (const double at : {3.0, 6.0}) {
      Aabb wall{Vec3::Constant(3), Vec3::Constant(7)};
      wall.min[k] = at;
      wall.max[k] = at + 1;
      shell.push_back(wall);
    }
  }
  const auto scene = scene_of(shell, room(10));
  Reach reach(scene);
  const auto out = reach.ask({5, 5, 5}, {1, 1, 1});
  EXPECT_EQ(out.answer, Reachable::no);
  EXPECT_TRUE(out.from_start);
  const auto in = reach.ask({1, 1, 1}, {5, 5, 5});
  EXPECT_EQ(in.answer, Reachable::no);
  EXPECT_FALSE(in.from_start);
  EXPECT_EQ(in.cells, out.cells);
  expect_enclosed(scene, in.cells);
  EXPECT_EQ(reach.ask({1, 1, 1}, {9, 9, 9}).answer, Reachable::yes);
}

TEST(Reach, WorksWhereTheBoundsAreFlat) {
  const Aabb flat{{0, 0, 5}, {10, 10, 5}};
  const std::vector<Aabb> wall = {{{4, 0, 0}, {5, 9, 10}}};
  const std::vector<Aabb> above = {{{4, 0, 6}, {5, 10, 10}}};
  const std::vector<Aabb> closed = {{{4, 0, 5}, {5, 10, 10}}};  // touches the plane
  const Vec3 from(1, 1, 5);
  const Vec3 to(9, 1, 5);
  const auto around = scene_of(wall, flat);
  const auto result = Reach(around).ask(from, to);
  ASSERT_EQ(result.answer, Reachable::yes);
  const auto way = way_through(result.cells, from, to);
  for (std::size_t i = 1; i < way.size(); ++i) EXPECT_TRUE(around.free(way[i - 1], way[i]));
  EXPECT_EQ(Reach(scene_of(above, flat)).ask(from, to).answer, Reachable::yes);
  const auto shut = scene_of(closed, flat);
  EXPECT_EQ(Reach(shut).ask(from, to).answer, Reachable::no);
  const auto point = scene_of({}, {from, from});
  EXPECT_EQ(Reach(point).ask(from, from).answer, Reachable::yes);
}

TEST(Reach, SaysThatItDoesNotKnowWhereItMayNotLookOn) {
  support::Random random(21);
  const auto scene = scene_of(random_boxes(random, 200, 20), room(20));
  Vec3 from;
  Vec3 to;
  const auto free_place = [&] {
    Vec3 p;
    do {
      p = {random.uniform(0, 20), random.uniform(0, 20), random.uniform(0, 20)};
    } while (!scene.free(p));
    return p;
  };
  int unknown = 0;
  for (int i = 0; i < 20; ++i) {
    from = free_place();
    to = free_place();
    const auto little = Reach(scene).ask(from, to, 3);
    const auto all = Reach(scene).ask(from, to);
    ASSERT_NE(all.answer, Reachable::unknown);
    if (little.answer == Reachable::unknown) {
      ++unknown;
    } else {
      EXPECT_EQ(little.answer, all.answer);
    }
  }
  EXPECT_GT(unknown, 5);
}

TEST(Reach, RefusesEndsThatAreNotFree) {
  const auto scene = scene_of(slit(1), room(10));
  Reach reach(scene);
  EXPECT_THROW(reach.ask({4.5, 1, 1}, {1, 1, 1}), geom::InputError);
  EXPECT_THROW(reach.ask({1, 1, 1}, {4.5, 1, 1}), geom::InputError);
  EXPECT_THROW(reach.ask({1, 1, 1}, {11, 1, 1}), geom::InputError);
  EXPECT_EQ(reach.ask({0, 0, 0}, {10, 10, 10}).answer, Reachable::yes);  // on the bounds
}

TEST(WayThrough, VisitsTheMiddlesOfCellsAndOfWhatTheyShare) {
  const std::vector<Aabb> cells = {{{0, 0, 0}, {2, 2, 2}}, {{2, 1, 0}, {4, 5, 2}}};
  const geom::Polyline way = {{0, 0, 0}, {1, 1, 1}, {2, 1.5, 1}, {3, 3, 1}, {4, 5, 2}};
  EXPECT_EQ(way_through(cells, {0, 0, 0}, {4, 5, 2}), way);
  EXPECT_EQ(way_through({cells[0]}, {1, 1, 1}, {1, 1, 1}), (geom::Polyline{{1, 1, 1}}));
}

}  // namespace
}  // namespace plan
