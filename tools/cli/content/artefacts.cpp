#include "artefacts.h"

#include "cli/file/files.h"
#include "cli/option/scenes.h"
#include "cli/option/vehicle_option.h"
#include "plan/lattice/lattice_file.h"
#include "plan/roadmap/roadmap_file.h"

namespace cli {

void ArtefactFiles::add_to(CLI::App& app) {
  app.add_option("--lattice", lattice,
                 "lattice of this map and vehicle (default: worked out as needed)");
  app.add_option("--roadmap", roadmap,
                 "roadmap of this map and vehicle: gives shorter paths, and sooner");
}

Artefacts::Artefacts(const ArtefactFiles& files) : files_(files) {
  if (!files.lattice.empty()) lattice_ = plan::read_lattice(open_archive(files.lattice));
  if (!files.roadmap.empty()) roadmap_ = plan::read_roadmap(open_archive(files.roadmap));
}

void Artefacts::require_made_for(const geom::CollisionScene& scene) const {
  if (lattice_) require_same(lattice_->made_for(), scene, files_.lattice, "lattice");
  if (roadmap_) require_same(roadmap_->made_for, scene, files_.roadmap, "roadmap");
}

}  // namespace cli
