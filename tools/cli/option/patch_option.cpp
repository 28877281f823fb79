#include "patch_option.h"

#include <fmt/format.h>

#include "cli/file/files.h"
#include "geom/base/error.h"
#include "scenes.h"

namespace cli {

void PatchOptions::add_to(CLI::App& app, const std::string& kind,
                          std::initializer_list<CLI::Option*> excluded) {
  auto* patch = app.add_option("--patch", artefact,
                               fmt::format("{} of an older map: only what changed is worked out "
                                           "anew, and all else is as in the older one",
                                           kind));
  auto* map = app.add_option("--old-map", old_map, "the map that the file of --patch was made for");
  patch->needs(map);
  map->needs(patch);
  for (CLI::Option* option : excluded) patch->excludes(option);
}

geom::ArrayArchive PatchOptions::open(const geom::Execution& run) const {
  geom::ArrayArchive archive = open_archive(artefact);
  archive.verify(run);
  return archive;
}

const geom::CollisionScene& PatchOptions::scene(Scenes& scenes, geom::Provenance made_for) const {
  made_for.map.reset();  // the old one
  return scenes.scene_for(made_for, artefact, 0);
}

plan::MapChange PatchOptions::change(const geom::Provenance& made_for,
                                     const geom::CollisionScene& scene) const {
  const geom::BoxMap old = open_map(old_map, geom::Verified::contents);
  if (made_for.map != old.hash()) {
    throw geom::InputError(artefact, {.expected = fmt::format("one made for the map {}", old_map),
                                      .found = "one made for another map"});
  }
  return plan::change_since(old, scene);
}

}  // namespace cli
