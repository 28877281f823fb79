#include "base/watched_sqlite.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <functional>
#include <new>
#include <optional>
#include <stdexcept>

#include "base/watched_memory.h"
#include "geom/earth/proj_way.h"
#include "support/failing_sqlite.h"

namespace geom {
namespace {

using support::FailingSqlite;

const char* const kNetherlands = "EPSG:28992";
const char* const kOregon = "EPSG:2994";  // PROJ chooses among several operations

std::optional<Vec2> place_of(const char* system, const Vec2& point) {
  const auto reference = ProjReference::of(system);
  const auto way = reference ? ProjWay::to_places(*reference) : std::nullopt;
  return way ? way->place_of(point) : std::nullopt;
}

// What is found while each `step`th allocation of SQLite, of some 7,000, fails in turn: nothing
// where that is refused.
void with_failures(const char* system, const Vec2& point, long step,
                   const std::function<void(long, const std::optional<Vec2>&)>& take) {
  for (long number = 0;; number += step) {
    const FailingSqlite failing(number);
    std::optional<Vec2> found;
    try {
      found = place_of(system, point);
    } catch (const std::bad_alloc&) {
    } catch (const std::runtime_error&) {  // an error in PROJ's log
    }
    if (!FailingSqlite::any_failed()) break;
    take(number, found);
  }
}

void expect_each_told(const char* system, const Vec2& point) {
  if (!FailingSqlite::works_here()) GTEST_SKIP() << "a sanitizer has its own malloc";
  ASSERT_TRUE(place_of(system, point));
  with_failures(system, point, 97, [](long number, const std::optional<Vec2>& found) {
    EXPECT_FALSE(found) << "allocation " << number;
  });
}

void expect_no_other_place(const char* system, const Vec2& point) {
  if (!FailingSqlite::works_here()) GTEST_SKIP() << "a sanitizer has its own malloc";
  const std::optional<Vec2> expected = place_of(system, point);
  ASSERT_TRUE(expected);
  with_failures(system, point, 229, [&](long number, const std::optional<Vec2>& found) {
    EXPECT_EQ(found.value_or(*expected), *expected) << "allocation " << number;
  });
}

TEST(WatchedSqlite, TellsOfEachFailure) {
  expect_each_told(kNetherlands, {85000, 447000});
  expect_each_told(kOregon, {1300000, 700000});
}

// As in a program that has a database open, such as Python.
void use_sqlite_first() {
  void* const sqlite = dlopen("libsqlite3.so.0", RTLD_LAZY | RTLD_LOCAL);
  ASSERT_TRUE(sqlite);
  const auto initialize = reinterpret_cast<int (*)()>(dlsym(sqlite, "sqlite3_initialize"));
  ASSERT_TRUE(initialize);
  ASSERT_EQ(initialize(), 0);
}

TEST(WatchedSqlite, IsReplacedByASecondSearchWhereSqliteWasUsedBefore) {
  use_sqlite_first();
  expect_no_other_place(kNetherlands, {85000, 447000});
}

}  // namespace
}  // namespace geom
