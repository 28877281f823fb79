// Maps and what was planned in them as meshes: to-ply, to-gltf.

#include "geom/mesh/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "cli/content/contents.h"
#include "cli/file/files.h"
#include "cli/option/scenes.h"
#include "traj/curve/to_enu.h"
#include "verbs.h"

namespace verbs {
namespace {

using Colour = std::array<std::uint8_t, 3>;

// Okabe and Ito: vermilion, bluish green, reddish purple; and of trees those of skyway-plan.
constexpr Colour kPath{213, 94, 0};
constexpr Colour kTrajectory{0, 158, 115};
constexpr Colour kFlight{204, 121, 167};
constexpr Colour kCorridor{240, 228, 66};  // yellow, as in the page
constexpr double kCorridorOpacity = 0.3;
constexpr Colour kTrees[] = {{86, 140, 196}, {204, 102, 85}};
constexpr double kStep = 0.1;       // seconds between the points of a curve,
constexpr double kMostSteps = 1e5;  // but no more of them than that

const cli::ContentKinds kKinds{.corridors = true,
                               .expected = "a record of type path, trajectory, tree or corridor"};

using Edges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// A line through points, as thick at its joints as between them.
geom::MeshPart way(std::string name, Colour colour, std::vector<geom::Vec3> points, double radius) {
  Edges edges;
  for (std::uint32_t i = 1; i < points.size(); ++i) edges.push_back({i - 1, i});
  return geom::rod_part(
      {std::move(name), colour, std::move(points), std::move(edges), radius, radius});
}

std::vector<geom::Vec3> curve(const traj::Trajectory& trajectory) {
  const double end = traj::duration(trajectory);
  const double count = std::clamp(std::ceil(end / kStep), 1.0, kMostSteps);
  std::vector<geom::Vec3> points;
  for (double k = 0; k <= count; ++k) {
    points.push_back(traj::evaluate(trajectory, end * (k / count)).position);
  }
  return points;
}

// Of a flight log, a row each kStep.
std::vector<geom::Vec3> flown(const traj::FlightLog& flight) {
  std::vector<geom::Vec3> points;
  double next = flight.samples.front().time;
  for (const traj::FlightSample& s : flight.samples) {
    if (s.time < next && &s != &flight.samples.back()) continue;
    points.push_back(s.position);
    next = s.time + kStep;
  }
  return points;
}

// The nodes of both trees as spheres, twice as thick as the cylinders of the edges between them.
void add_tree(const plan::SearchTreeRecord& record, geom::Axes axes, double radius,
              std::vector<geom::MeshPart>& parts) {
  for (std::uint8_t which = 0; which < 2; ++which) {
    geom::Rods rods{"tree " + record.id + (which ? " from the goal" : " from the start"),
                    kTrees[which],
                    {},
                    {},
                    radius,
                    2 * radius};
    std::vector<std::uint32_t> place(record.tree.points.size());
    for (std::size_t i = 0; i < place.size(); ++i) {
      if (record.tree.tree[i] != which) continue;
      place[i] = static_cast<std::uint32_t>(rods.points.size());
      rods.points.push_back(geom::to_enu(axes, record.tree.points[i]));
    }
    for (std::size_t i = 0; i < place.size(); ++i) {
      const std::uint32_t parent = record.tree.parent[i];
      if (record.tree.tree[i] != which || parent == i) continue;
      rods.edges.push_back({place[parent], place[i]});
    }
    if (!rods.points.empty()) parts.push_back(geom::rod_part(std::move(rods)));
  }
}

geom::MeshPart corridor_part(const traj::CorridorShape& corridor, geom::Axes axes) {
  std::vector<geom::Polytope> regions;
  for (const auto& piece : corridor.pieces) regions.push_back({piece.vertices, piece.faces});
  geom::MeshPart part = geom::polytope_part("corridor " + corridor.id, kCorridor, axes, regions);
  part.opacity = kCorridorOpacity;
  return part;
}

std::vector<geom::MeshPart> parts_of(const geom::BoxMap& map, const cli::Contents& contents,
                                     double radius) {
  const geom::Axes axes = map.spec().frame.axes;
  std::vector<geom::MeshPart> parts = geom::box_parts(map);
  for (const auto& [tree, source, line] : contents.trees) add_tree(tree, axes, radius, parts);
  for (const auto& [path, source, line] : contents.paths) {
    parts.push_back(way("path " + path.id, kPath, traj::to_enu(axes, path.points), radius));
  }
  for (const auto& [t, source, line] : contents.trajectories) {
    parts.push_back(
        way("trajectory " + t.id, kTrajectory, traj::to_enu(axes, curve(t.trajectory)), radius));
  }
  for (const auto& [f, source, line] : contents.flights) {
    parts.push_back(way("flight " + f.id, kFlight, flown(f), radius));
  }
  for (const auto& [corridor, source, line] : contents.corridors)
    parts.push_back(corridor_part(corridor, axes));
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
            cli::drop_failed(contents);
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
