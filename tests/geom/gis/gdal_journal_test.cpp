#include "gis/gdal_journal.h"

#include <gtest/gtest.h>

#include "geom/gis/footprint_source.h"
#include "support/memory_file.h"
#include "support/reading.h"

namespace geom::gis {
namespace {

using support::refusal_of;
using support::says;

TEST(RequireNoJournal, RefusesChangesBesideADatabase) {
  const MemoryFile city("city.gpkg", "SQLite format 3");
  EXPECT_EQ(refusal_of([&] { require_no_journal(city.path()); }), "");
  for (const char* ending : {"-wal", "-journal"}) {
    const MemoryFile journal(std::string("city.gpkg") + ending, "7\177\6\202 and changes");
    for (const auto& read : {std::function([&] { require_no_journal(city.path()); }),
                             std::function([&] { is_raster(city.path()); }),
                             std::function([&] { read_vector(city.path(), "city.gpkg", {}); })}) {
      EXPECT_TRUE(says(refusal_of(read),
                       "expected a database without changes beside it, found "
                       "some in /vsimem/city.gpkg" +
                           std::string(ending)));
    }
  }
}

TEST(RequireNoJournal, TakesOneWithoutChanges) {
  const MemoryFile city("city.gpkg", "SQLite format 3");
  for (const std::string& none : {std::string(), std::string(512, '\0')}) {
    const MemoryFile journal("city.gpkg-journal", none);
    EXPECT_EQ(refusal_of([&] { require_no_journal(city.path()); }), "");
  }
}

}  // namespace
}  // namespace geom::gis
