#pragma once

// A roadmap file that is filled as it is used, by several processes at once.

#include <optional>
#include <string>

#include "geom/archive/array_archive.h"
#include "geom/collision/collision.h"
#include "plan/roadmap/roadmap.h"
#include "plan/roadmap/roadmap_fill.h"

namespace cli {

class FilledRoadmap {
 public:
  // Of that file; of a new one, with edges of up to 60 m, where there is none. A whole roadmap is
  // used as it is. Throws geom::InputError where it was made for something else than the scene,
  // which must outlive this.
  FilledRoadmap(const std::string& path, const geom::CollisionScene& scene);

  // One of both.
  plan::RoadmapFill* fill() { return fill_ ? &*fill_ : nullptr; }
  const plan::Roadmap* whole() const { return whole_ ? &*whole_ : nullptr; }

  // Writes the file anew where there is more to know, with what others wrote meanwhile. Whoever
  // reads it meanwhile has the file as it was. Throws std::system_error where it cannot, and
  // geom::InputError where the file is damaged.
  void save() const;

 private:
  std::string path_;
  const geom::CollisionScene& scene_;
  std::optional<geom::ArrayArchive> archive_;  // of the file as it was at first
  std::optional<plan::Roadmap> whole_;
  std::optional<plan::RoadmapFill> fill_;
};

}  // namespace cli
