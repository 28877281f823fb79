// mesh_check FILE SLACK [shell|solid]: boxes of an OBJ file's triangles against what they
// promise. A million random points of the triangles in rational numbers, none outside the boxes; of
// each box a proof that it reaches no further than the slack. And the time, beside reading alone.

#include <fmt/format.h>

#include <assimp/Importer.hpp>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>
#include <string>

#include "geom/mesh/triangle_cover.h"
#include "geom/model/model.h"
#include "support/exactly_held.h"
#include "support/random_city.h"
#include "support/triangle_oracle.h"

namespace {

using geom::TriangleMesh;
using geom::Vec3;

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class F>
double timed(const F& f) {
  double least = 1e9;
  for (int round = 0; round < 3; ++round) {
    const double before = cpu_seconds();
    f();
    least = std::min(least, cpu_seconds() - before);
  }
  return least;
}

std::size_t points_outside(const TriangleMesh& mesh, const geom::TriangleCover& made, int points) {
  const oracle::ExactlyHeld held(made.boxes);
  support::Random random(1);
  std::size_t outside = 0;
  for (int i = 0; i < points; ++i) {
    const auto t =
        static_cast<std::size_t>(random.uniform(0, static_cast<double>(mesh.triangles.size())));
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh.vertices[mesh.triangles[t].corners[k]];
    int a = random.below((1 << 20) + 1);
    int b = random.below((1 << 20) + 1);
    if (a > b) std::swap(a, b);
    outside += !held(oracle::weighted(corners, {a, b - a, (1 << 20) - b}));
  }
  return outside;
}

// Of boxes that reach further from the triangles of their part, and of what those enclose.
std::size_t boxes_too_far(const TriangleMesh& mesh, const geom::TriangleCover& made, double slack,
                          bool solid) {
  std::map<std::uint32_t, TriangleMesh> parts;
  for (const geom::MeshTriangle& t : mesh.triangles) {
    parts[t.part].triangles.push_back(t);
  }
  std::size_t far = 0;
  for (auto& [number, part] : parts) {
    oracle::Body body({mesh.vertices, std::move(part.triangles)});
    if (solid) body.fill();
    for (std::size_t i = 0; i < made.boxes.size(); ++i) {
      if (made.part[i] == number) far += !oracle::within_slack(body, made.boxes[i], slack);
    }
  }
  return far;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "mesh_check FILE.obj SLACK [shell|solid]\n");
    return 2;
  }
  geom::TriangleCoverOptions options;
  options.slack = std::atof(argv[2]);
  const bool solid = argc > 3 && std::string(argv[3]) == "solid";
  if (solid) options.fill = geom::SolidFill::inside;
  geom::Model model;
  const double reading = timed([&] {
    std::ifstream in(argv[1]);
    model = geom::read_obj(in, argv[1]);
  });
  const double assimp = timed([&] {
    Assimp::Importer importer;
    if (!importer.ReadFile(argv[1], 0)) fmt::print("assimp could not read it\n");
  });
  const TriangleMesh& mesh = model.mesh;
  geom::TriangleCover made;
  const double covering = timed([&] { made = geom::cover_triangles(mesh, options); });
  fmt::print(
      "{} triangles, {} boxes; CPU: read {:.4f} s (assimp {:.4f} s), cover {:.4f} s ({:.0f} ns a "
      "triangle)\n",
      mesh.triangles.size(), made.boxes.size(), reading, assimp, covering,
      1e9 * covering / static_cast<double>(mesh.triangles.size()));
  const std::size_t outside = points_outside(mesh, made, 1000000);
  const std::size_t far = boxes_too_far(mesh, made, options.slack, solid);
  fmt::print("of 1000000 points outside the boxes: {}; of {} boxes beyond the slack: {}\n", outside,
             made.boxes.size(), far);
  return outside + far > 0;
}
