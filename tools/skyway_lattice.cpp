// skyway-lattice: the lattice graph of a box map for one vehicle and margin.

#include <fmt/format.h>

#include "cli/files.h"
#include "cli/numbers_option.h"
#include "cli/run.h"
#include "cli/vehicle_option.h"
#include "plan/build_lattice.h"
#include "plan/io/lattice_file.h"

int main(int argc, char** argv) {
  CLI::App app{"Build a lattice graph of a box map.", "skyway-lattice"};
  cli::Common common(app, true);
  cli::VehicleOptions vehicle;
  std::string map_file;
  std::string output = "-";
  plan::LatticeSpec spec;
  int connect = 6;
  std::optional<geom::Vec3> origin;
  app.add_option("map", map_file, "box map; - for stdin")->required();
  app.add_option("-o,--output", output, "lattice to write (default: stdout)");
  app.add_option("--spacing", spec.spacing, "distance of neighbouring nodes, metres (default 25)")
      ->check(CLI::Range(1e-3, 1e6));
  app.add_option("--connect", connect, "neighbours of a node: 6, 18 or 26 (default 6)")
      ->check(CLI::IsMember({6, 18, 26}));
  cli::add_point(app, "--origin", origin, "a node (default: the lower corner of the bounds)");
  vehicle.add_to(app);
  return cli::run_tool(app, argc, argv, [&] {
    cli::Scenes scenes(cli::open_map(map_file), vehicle, cli::Scenes::Differences::refused);
    const geom::CollisionScene& scene = scenes.scene();
    spec.connectivity = static_cast<plan::Connectivity>(connect);
    spec.origin = origin.value_or(scene.map().spec().bounds.min);
    const plan::Lattice lattice = plan::build_lattice(scene, spec, common.execution("layers"));
    cli::OutputFile out(output, cli::OutputKind::artefact);
    plan::write_lattice(out.stream(), lattice);
    out.commit();
    const plan::LatticeCounts counts = plan::stored_counts(lattice);
    common.write_stats({{"nodes", counts.nodes}, {"edges", counts.edges}});
    return cli::Exit::yes;
  });
}
