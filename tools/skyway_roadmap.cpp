// skyway-roadmap: the taut visibility roadmap of a box map for one vehicle and margin.

#include <fmt/format.h>

#include "cli/files.h"
#include "cli/numbers_option.h"
#include "cli/patch_option.h"
#include "cli/run.h"
#include "cli/vehicle_option.h"
#include "plan/io/roadmap_file.h"

namespace {

constexpr std::size_t kManyBoxes = 100000;  // beyond, a region must be named

void require_not_too_many(const geom::CollisionScene& scene, const plan::RoadmapSpec& spec) {
  const std::size_t boxes =
      spec.region ? scene.boxes_meeting(*spec.region).size() : scene.map().size();
  if (boxes <= kManyBoxes) return;
  throw cli::UsageError(fmt::format(
      "a roadmap of {} boxes would have about {} million bends and gigabytes of edges: name a "
      "--region of at most {} boxes",
      boxes, boxes * 5 / 1000000 + 1, kManyBoxes));
}

plan::Roadmap built(const geom::CollisionScene& scene, const plan::RoadmapSpec& spec,
                    const geom::Execution& run) {
  require_not_too_many(scene, spec);
  return plan::build_roadmap(scene, spec, run);
}

plan::Roadmap patched(cli::Scenes& scenes, const cli::PatchOptions& patch,
                      const geom::Execution& run) {
  const plan::Roadmap old = plan::read_roadmap(cli::open_archive(patch.artefact));
  const geom::CollisionScene& scene = patch.scene(scenes, old.made_for);
  require_not_too_many(scene, old.spec);
  return plan::patch_roadmap(old, scene, patch.change(old.made_for, scene), run);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Build a taut visibility roadmap of a box map.", "skyway-roadmap"};
  cli::Common common(app, true);
  cli::VehicleOptions vehicle;
  std::string map_file;
  std::string output = "-";
  plan::RoadmapSpec spec;
  cli::PatchOptions patch;
  app.add_option("map", map_file, "box map; - for stdin")->required();
  app.add_option("-o,--output", output, "roadmap to write (default: stdout)");
  auto* reach = app.add_option("--reach", spec.reach, "longest edge, metres (default 500)")
                    ->check(CLI::Range(1.0, 1e5));
  auto* part = app.add_option("--part", spec.part,
                              "box edges are cut into parts of at most this, metres (default 10)")
                   ->check(CLI::Range(0.1, 1e4));
  auto* region =
      cli::add_box(app, "--region", spec.region, "bend only around boxes that meet this region");
  patch.add_to(app, "a roadmap", {reach, part, region});
  vehicle.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    cli::at_most_one_stdin({map_file, patch.artefact, patch.old_map});
    cli::Scenes scenes(cli::open_map(map_file), vehicle, cli::Scenes::Differences::refused);
    const geom::Execution run = common.execution("bends");
    const plan::Roadmap roadmap =
        patch.asked() ? patched(scenes, patch, run) : built(scenes.scene(), spec, run);
    cli::OutputFile out(output, cli::OutputKind::artefact);
    plan::write_roadmap(out.stream(), roadmap);
    out.commit();
    common.write_stats({{"bends", roadmap.bends.size()}, {"edges", roadmap.to.size() / 2}});
    return cli::Exit::yes;
  });
}
