#include "geom/base/kept_times.h"

#include <sys/vfs.h>

#include <algorithm>
#include <array>

namespace geom {
namespace {

constexpr std::array<std::uint32_t, 15> kKeeping = {
    0xEF53,      // ext2, ext3, ext4
    0x58465342,  // XFS
    0x9123683E,  // Btrfs
    0x2FC12FC1,  // ZFS
    0xF2F52010,  // F2FS
    0xCA451A4E,  // bcachefs
    0x3153464A,  // JFS
    0x52654973,  // ReiserFS
    0x3434,      // NILFS
    0xF15F,      // eCryptfs
    0x794C7630,  // overlayfs: those of what lies below
    0x6969,      // NFS: the server's
    0x00C36400,  // Ceph
    0x0BD00BD0,  // Lustre
    0x47504653,  // GPFS
};

}  // namespace

bool keeps_times(std::uint32_t kind) {
  return std::find(kKeeping.begin(), kKeeping.end(), kind) != kKeeping.end();
}

bool keeps_times(const std::string& path) {
  struct statfs info {};
  return statfs(path.c_str(), &info) == 0 && keeps_times(static_cast<std::uint32_t>(info.f_type));
}

}  // namespace geom
