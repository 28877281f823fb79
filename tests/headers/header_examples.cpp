// header_examples SAMPLES: runs the examples of the public headers, in a folder with the samples
// and a `city.boxmap`. They check themselves by `assert`.

#include <filesystem>

#include "geom/import/import_boxes.h"
#include "geom/map/box_map_file.h"
#include "headers/given.h"
#include "plan/planner/plan.h"
#include "support/temporary_folder.h"
#include "traj/flight/vehicle_profile.h"
#include "traj/solve/solve.h"

void run_geom(Given& given);
void run_plan(Given& given);
void run_traj(Given& given);
void run_geom_png(Given& given);
void run_geom_gis(Given& given);
void run_geom_cloud(Given& given);
void run_geom_mesh(Given& given);

namespace {

Given given() {
  std::istringstream blocks("boundary 0 0 0 10 10 10\nblock 4 0 0 5 8 8\n");
  const geom::BoxMap map =
      geom::make_map(geom::import_boxes(blocks, geom::kBlockText, "city.txt"),
                     "city.txt")
          .map;
  const geom::Vehicle vehicle = traj::vehicle_named("tello")->vehicle;
  geom::Limits limits = vehicle.limits;
  limits[geom::Limit::acceleration] = 3;
  geom::CollisionScene scene(map, vehicle, 0.2);
  const geom::Polyline path = plan::Planner(scene).plan({1, 1, 1}, {9, 1, 1}).path;
  traj::SolveOptions options;
  options.limits = limits;
  const traj::Trajectory trajectory = traj::solve(scene, path, options).trajectory;
  return {map, vehicle, limits, std::move(scene), path, trajectory};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  std::cout.setstate(std::ios::failbit);  // what examples print, nobody reads here
  std::cerr.setstate(std::ios::failbit);
  const support::TemporaryFolder folder;
  std::filesystem::copy(argv[1], folder.path());
  std::filesystem::current_path(folder.path());
  Given about = given();
  {
    std::ofstream out("city.boxmap", std::ios::binary);
    geom::write_box_map(out, about.map);
  }
  run_geom(about);
  run_plan(about);
  run_traj(about);
  run_geom_png(about);
#ifdef RUN_geom_gis
  run_geom_gis(about);
#endif
#ifdef RUN_geom_cloud
  run_geom_cloud(about);
#endif
#ifdef RUN_geom_mesh
  run_geom_mesh(about);
#endif
}
