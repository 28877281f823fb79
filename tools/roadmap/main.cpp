// skyway-roadmap: the taut visibility roadmap of a box map for one vehicle and margin.

#include <fmt/format.h>

#include "cli/file/files.h"
#include "cli/option/numbers_option.h"
#include "cli/option/output_option.h"
#include "cli/option/patch_option.h"
#include "cli/option/scenes.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "cli/shard/sharding.h"
#include "geom/base/thread_seconds.h"
#include "plan/roadmap/part_file.h"
#include "plan/roadmap/patch_roadmap.h"
#include "plan/roadmap/roadmap_estimate.h"
#include "plan/roadmap/roadmap_file.h"
#include "plan/roadmap/roadmap_part.h"

namespace {

constexpr double kLong = 300;  // seconds of a core: beyond, the reach must be named
constexpr double kSaid = 20;   // seconds of a core: beyond, it is measured and said beforehand

plan::Roadmap patched(cli::Scenes& scenes, const cli::PatchOptions& patch,
                      const geom::Execution& run) {
  const plan::Roadmap old = plan::read_roadmap(patch.open(run));
  const geom::CollisionScene& scene = patch.scene(scenes, old.made_for);
  return plan::patch_roadmap(old, scene, patch.change(old.made_for, scene), run);
}

void write_shard(const cli::Sharding& sharding, const cli::Common& common,
                 const std::string& output, const geom::CollisionScene& scene,
                 const plan::RoadmapSpec& spec) {
  const plan::Roadmap part =
      plan::build_roadmap_part(scene, spec, sharding.shard(), common.execution("bends"));
  sharding.write(output, "output", "roadmap", plan::arrays_of(part));
  common.write_stats({{"bends", part.bends()}, {"edges", part.edge_to.size()}});
}

// Refuses what would take long, unless its reach was named: then some tiles are tried, and it is
// said, but not of a shard.
void check_size(const cli::Common& common, const std::string& map_file,
                const geom::CollisionScene& scene, const plan::RoadmapSpec& spec, bool named,
                bool all) {
  const std::size_t boxes =
      spec.region ? scene.boxes_meeting(*spec.region).size() : scene.map().size();
  const geom::Aabb& bounds = scene.map().spec().bounds;
  const geom::Aabb area = spec.region.value_or(bounds);
  const plan::RoadmapEstimate estimate = plan::rough_estimate(
      boxes, spec.reach, {area.min.cwiseMax(bounds.min), area.max.cwiseMin(bounds.max)});
  if (estimate.seconds > kLong && !named) {
    throw cli::UsageError(
        fmt::format("a roadmap of {} boxes would have {}: give --reach (500 m is the "
                    "default), or a smaller --region",
                    boxes, plan::in_words(estimate)));
  }
  if (estimate.seconds <= kSaid || !all) return;
  common.warn(
      fmt::format("{}: a roadmap of {} boxes will have {}, by a few of its tiles", map_file, boxes,
                  plan::in_words(plan::estimate_roadmap(scene, spec, geom::thread_seconds))));
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
  cli::Sharding sharding;
  app.add_option("map", map_file, "box map; - for stdin")->required();
  cli::add_output(app, "-o,--output", output, "roadmap to write (default: stdout)");
  auto* reach =
      app.add_option("--reach", spec.reach,
                     "longest edge, metres (default 500; to be named where building would take "
                     "over 5 minutes of a core)")
          ->check(CLI::Range(1.0, 1e5));
  auto* part = app.add_option("--part", spec.part,
                              "box edges are cut into parts of at most this, metres (default 10)")
                   ->check(CLI::Range(0.1, 1e4));
  auto* region = cli::add_box(app, "--region", spec.region,
                              "bend only around boxes that meet this region, along the map's axes");
  patch.add_to(app, "a roadmap", {reach, part, region});
  vehicle.add_to(app);
  vehicle.add_memory_to(app);
  sharding.add_to(app)->excludes("--patch");
  return cli::run_tool(app, argc, argv, [&] {
    cli::at_most_one_stdin({map_file, patch.artefact, patch.old_map});
    sharding.begin(app, {{"map", map_file}}, {{"output", output}});
    if (const auto done = sharding.finished(common)) return *done;
    cli::Scenes scenes(cli::open_map(map_file, geom::Verified::extents, common.execution("verify")),
                       vehicle, cli::Scenes::Differences::refused);
    const geom::Execution run = common.execution("bends");
    if (!patch.asked()) {
      check_size(common, map_file, scenes.scene(), spec, !reach->empty(), !sharding.asked());
    }
    if (sharding.asked()) {
      write_shard(sharding, common, output, scenes.scene(), spec);
      return cli::Exit::yes;
    }
    const plan::Roadmap roadmap = patch.asked() ? patched(scenes, patch, run)
                                                : plan::build_roadmap(scenes.scene(), spec, run);
    cli::OutputFile out(output, cli::OutputKind::artefact, patch.artefact);
    plan::write_roadmap(out.stream(), roadmap);
    out.commit();
    common.write_stats({{"bends", roadmap.bends()}, {"edges", roadmap.edges()}});
    return cli::Exit::yes;
  });
}
