#include "geom/gis/people_raster.h"

#include <gtest/gtest.h>

#include "support/memory_raster.h"
#include "support/short_memory.h"
#include "support/temporary_folder.h"

namespace geom::gis {
namespace {

class PeopleWithinTest : public testing::Test {
 protected:
  PeopleWithinTest() { support::copy_out(MemoryRaster({}).path(), path_); }

  void read() const { EXPECT_FALSE(people_within(path_, {49.6, 8.9}, {49.7, 9.1}).empty()); }

  support::TemporaryFolder folder_;
  std::string path_ = folder_ / "people.tif";
};

TEST_F(PeopleWithinTest, AreRefusedWhereAnAllocationFailsInSilence) {
  support::expect_bad_alloc_where_one_is_swallowed([&] { read(); });
}

TEST_F(PeopleWithinTest, AreRefusedWhereTheFileIsWrittenTo) {
  support::expect_refused_where_written_to(path_, [&] { read(); });
}

}  // namespace
}  // namespace geom::gis
