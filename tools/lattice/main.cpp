// skyway-lattice: the lattice graph of a box map for one vehicle and margin.

#include "cli/file/files.h"
#include "cli/option/numbers_option.h"
#include "cli/option/output_option.h"
#include "cli/option/scenes.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "cli/shard/sharding.h"
#include "plan/lattice/build_lattice.h"
#include "plan/lattice/fitting_length.h"
#include "plan/lattice/lattice_file.h"
#include "plan/lattice/part_file.h"

namespace {

plan::LatticeCounts write_shard(const cli::Sharding& sharding, const std::string& output,
                                const geom::CollisionScene& scene, const plan::LatticeSpec& spec,
                                const geom::Execution& run) {
  const plan::LatticePart part = plan::build_lattice_part(scene, spec, sharding.shard(), run);
  sharding.write(output, "output", "lattice", plan::arrays_of(part));
  return part.blocks.counts;
}

struct Asked {
  std::optional<double> spacing;
  int connect = 6;
  std::optional<geom::Vec3> origin;
};

// A spacing that nobody asked for fits the map.
plan::LatticeSpec spec_for(const geom::CollisionScene& scene, const Asked& asked) {
  plan::LatticeSpec spec;
  spec.connectivity = static_cast<plan::Connectivity>(asked.connect);
  spec.origin = asked.origin.value_or(scene.map().spec().bounds.min);
  if (asked.spacing) {
    spec.spacing = *asked.spacing;
  } else if (scene.free_bounds()) {
    spec.spacing = plan::fitting_length(*scene.free_bounds(), spec.spacing);
  }
  return spec;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Build a lattice graph of a box map.", "skyway-lattice"};
  cli::Common common(app, true);
  cli::VehicleOptions vehicle;
  std::string map_file;
  std::string output = "-";
  Asked asked;
  cli::Sharding sharding;
  app.add_option("map", map_file, "box map; - for stdin")->required();
  cli::add_output(app, "-o,--output", output, "lattice to write (default: stdout)");
  app.add_option("--spacing", asked.spacing,
                 "distance of neighbouring nodes, metres (default 25, less on maps under 300 m)")
      ->check(CLI::Range(1e-3, 1e6));
  app.add_option("--connect", asked.connect, "neighbours of a node: 6, 18 or 26 (default 6)")
      ->check(CLI::IsMember({6, 18, 26}));
  cli::add_point(app, "--node", asked.origin,
                 "a node, along the map's axes (default: the lower corner of the bounds)");
  vehicle.add_to(app);
  vehicle.add_memory_to(app);
  sharding.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    sharding.begin(app, {{"map", map_file}}, {{"output", output}});
    if (const auto done = sharding.finished(common)) return *done;
    cli::Scenes scenes(cli::open_map(map_file, geom::Verified::extents, common.execution("verify")),
                       vehicle, cli::Scenes::Differences::refused);
    const plan::LatticeSpec spec = spec_for(scenes.scene(), asked);
    const geom::Execution run = common.execution("layers");
    if (sharding.asked()) {
      const auto counts = write_shard(sharding, output, scenes.scene(), spec, run);
      common.write_stats({{"nodes", counts.nodes}, {"edges", counts.edges}});
      return cli::Exit::yes;
    }
    const plan::Lattice lattice = plan::build_lattice(scenes.scene(), spec, run);
    cli::OutputFile out(output, cli::OutputKind::artefact);
    plan::write_lattice(out.stream(), lattice);
    out.commit();
    const plan::LatticeCounts counts = plan::stored_counts(lattice);
    common.write_stats({{"nodes", counts.nodes}, {"edges", counts.edges}});
    return cli::Exit::yes;
  });
}
