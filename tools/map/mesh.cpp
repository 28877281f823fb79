// Maps and what was planned in them as meshes: to-ply, to-gltf.

#include "geom/mesh/mesh.h"

#include <memory>
#include <utility>

#include "cli/content/contents.h"
#include "cli/file/files.h"
#include "cli/tell.h"
#include "plan/sampling/tree_parts.h"
#include "traj/record/record_parts.h"
#include "verbs.h"

namespace verbs {
namespace {

const cli::ContentKinds kKinds{.corridors = true,
                               .expected = "a record of type path, trajectory, tree or corridor"};

std::vector<geom::MeshPart> parts_of(const geom::BoxMap& map, const cli::Contents& contents,
                                     double radius) {
  const geom::Axes axes = map.spec().frame.axes;
  std::vector<geom::MeshPart> parts = geom::box_parts(map);
  for (const auto& [tree, source, line] : contents.trees) {
    for (geom::MeshPart& part : plan::tree_parts(tree, axes, radius)) {
      parts.push_back(std::move(part));
    }
  }
  for (const auto& [path, source, line] : contents.paths) {
    parts.push_back(traj::path_part(path, axes, radius));
  }
  for (const auto& [trajectory, source, line] : contents.trajectories) {
    parts.push_back(traj::trajectory_part(trajectory, axes, radius));
  }
  for (const auto& [flight, source, line] : contents.flights) {
    parts.push_back(traj::flight_part(flight, radius));
  }
  for (const auto& [corridor, source, line] : contents.corridors) {
    parts.push_back(traj::corridor_part(corridor, axes));
  }
  return parts;
}

using Write = void (*)(std::ostream&, std::span<const geom::MeshPart>);

Verb mesh_verb(CLI::App& app, const cli::Common& common, const char* name, const char* what,
               Write write) {
  struct More {
    std::vector<std::string> inputs;
    double radius = 0.3;
    cli::MetresOption metres;
  };
  auto files = std::make_shared<Files>();
  auto more = std::make_shared<More>();
  CLI::App* verb = files->add(app, name, what);
  verb->add_option("files", more->inputs,
                   "paths, trajectories, flight logs, search trees and corridors");
  verb->add_option("--radius", more->radius, "of their lines, metres")
      ->check(CLI::Range(1e-6, 1e6))
      ->capture_default_str();
  more->metres.add_to(*verb);
  return {verb, [=, &common] {
            cli::at_most_one_stdin(files->map, more->inputs);
            const geom::BoxMap map = open(files->map, common);
            cli::Contents contents = cli::read_contents(more->inputs, kKinds);
            cli::require_same_map(contents, &map, more->metres);
            cli::warn_of_unsaid_maps(common, contents);
            cli::tell_left_out(common, "skyway-map", cli::drop_failed(contents));
            const auto parts = parts_of(map, contents, more->radius);
            cli::OutputFile out(files->output, cli::OutputKind::artefact);
            write(out.stream(), parts);
            out.commit();
            warn_of_times(files->map, map, common);
            return cli::Exit::yes;
          }};
}

}  // namespace

Verb to_ply(CLI::App& app, const cli::Common& common) {
  return mesh_verb(app, common, "to-ply",
                   "write boxes and what was planned as triangles (binary PLY, east north up)",
                   geom::write_ply);
}

Verb to_gltf(CLI::App& app, const cli::Common& common) {
  return mesh_verb(app, common, "to-gltf",
                   "write boxes and what was planned as meshes (binary glTF, .glb)",
                   geom::write_glb);
}

}  // namespace verbs
