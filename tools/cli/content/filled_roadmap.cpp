#include "filled_roadmap.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "cli/file/files.h"
#include "cli/option/scenes.h"
#include "geom/record/record.h"
#include "plan/roadmap/roadmap_file.h"

namespace cli {
namespace {

constexpr double kPart = 10;   // metres
constexpr double kReach = 60;  // metres, of a new one

// One process at a time fills roadmaps of a folder. The system ends it with the process.
class FolderLock {
 public:
  explicit FolderLock(const std::string& file) {
    const std::filesystem::path parent = std::filesystem::path(file).parent_path();
    const std::string folder = parent.empty() ? "." : parent.string();
    descriptor_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ < 0) fail(folder);
    while (flock(descriptor_, LOCK_EX) != 0) {
      if (errno != EINTR) fail(folder);
    }
  }
  ~FolderLock() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  void fail(const std::string& folder) {
    const int error = errno;
    if (descriptor_ >= 0) close(descriptor_);
    throw std::system_error(error, std::generic_category(), "cannot lock " + folder);
  }

  int descriptor_ = -1;
};

std::optional<geom::ArrayArchive> opened(const std::string& path) {
  if (access(path.c_str(), F_OK) != 0) return std::nullopt;
  return open_archive(path);
}

bool same_spec(const plan::RoadmapSpec& a, const plan::RoadmapSpec& b) {
  return a.part == b.part && a.reach == b.reach && a.region == b.region;
}

}  // namespace

FilledRoadmap::FilledRoadmap(const std::string& path, const geom::CollisionScene& scene)
    : path_(path), scene_(scene) {
  std::optional<plan::Roadmap> known;
  archive_ = opened(path);
  if (archive_) known = plan::read_roadmap(*archive_, plan::Filled::allowed);
  if (known) require_same(known->made_for, scene, path, "roadmap");
  if (known && !known->filled) {
    whole_ = std::move(known);
    return;
  }
  const plan::RoadmapSpec spec = known ? known->spec : plan::RoadmapSpec{kPart, kReach, {}};
  fill_.emplace(scene, spec, std::move(known));
}

// What is copied is verified first: damage must not get new checksums.
void FilledRoadmap::save() const {
  if (!fill_ || !fill_->grew()) return;
  const FolderLock lock(path_);
  std::optional<plan::Roadmap> others;
  if (archive_) archive_->verify();
  if (const auto archive = opened(path_)) {
    others = plan::read_roadmap(*archive, plan::Filled::allowed);
    archive->verify();
    // Of another map by now, or whole: left as it is.
    if (!others->filled || !same_spec(others->spec, fill_->spec()) ||
        geom::mismatch(others->made_for, geom::provenance_of(scene_))) {
      return;
    }
  }
  OutputFile out(path_, OutputKind::artefact, path_);
  plan::write_roadmap(out.stream(), fill_->known(others));
  out.commit_now();
}

}  // namespace cli
