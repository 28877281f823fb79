#include "geom/base/kept_times.h"

#include <gtest/gtest.h>
#include <linux/magic.h>

namespace geom {
namespace {

TEST(KeptTimes, AreThoseOfFileSystemsWhoseKernelSetsThem) {
  for (const std::uint32_t kind : {EXT4_SUPER_MAGIC, XFS_SUPER_MAGIC, NFS_SUPER_MAGIC}) {
    EXPECT_TRUE(keeps_times(kind)) << kind;
  }
}

// There another file may have the same number, size and times: after cp -p on FAT, say.
TEST(KeptTimes, AreNotThoseOfFatFuseSmb9pMediaAndMemory) {
  for (const std::uint32_t kind :
       {std::uint32_t{MSDOS_SUPER_MAGIC}, std::uint32_t{0x2011BAB0}, std::uint32_t{0x65735546},
        std::uint32_t{0xFF534D42}, std::uint32_t{0xFE534D42}, std::uint32_t{V9FS_MAGIC},
        std::uint32_t{ISOFS_SUPER_MAGIC}, std::uint32_t{TMPFS_MAGIC}, std::uint32_t{0}}) {
    EXPECT_FALSE(keeps_times(kind)) << kind;
  }
}

TEST(KeptTimes, AreNoneOfAPathThatIsNotThere) {
  EXPECT_FALSE(keeps_times("/none/there"));
  EXPECT_FALSE(keeps_times("/proc/self/status"));
}

}  // namespace
}  // namespace geom
