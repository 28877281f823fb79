// clearance_bench MAP FILE: the least clearance of paths or trajectories, by the prefix of the ids
// ("q5000-17"): CPU time, warm, the least of three times, in the median, at most, and for a
// kilometre; and of the whole check with its clearance in a scene that nobody has asked before,
// which builds what it touches.

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geom/base/thread_seconds.h"
#include "geom/map/box_map_file.h"
#include "geom/record/record.h"
#include "geom/shape/polyline.h"
#include "geom/text/json_fields.h"
#include "traj/proof/check.h"
#include "traj/record/trajectory_record.h"

namespace {

// A record as far as it is checked.
struct Way {
  std::string id;
  geom::Provenance provenance;
  geom::Polyline path;          // or
  traj::Trajectory trajectory;  // empty for a path
  double length = 0;            // metres
};

std::optional<Way> way_of(const geom::JsonFields& fields) {
  if (fields.text("type") == "path") {
    auto path = geom::read_path_record(fields);
    if (path.status != geom::PathStatus::found) return std::nullopt;
    const double length = geom::length(path.points);
    return Way{path.id, path.provenance, std::move(path.points), {}, length};
  }
  auto record = traj::read_trajectory_record(fields);
  if (record.status != traj::TrajectoryStatus::solved) return std::nullopt;
  double length = 0;
  for (const traj::Segment& s : record.trajectory.segments) {
    length += (s.point.back() - s.point.front()).norm();
  }
  return Way{record.id, record.provenance, {}, std::move(record.trajectory), length};
}

double check_seconds(const geom::CollisionScene& scene, const Way& way, traj::Clearance clearance) {
  traj::CheckOptions options;
  options.clearance = clearance;
  const double start = geom::thread_seconds();
  way.trajectory.segments.empty() ? traj::check_path(scene, way.path, {}, clearance)
                                  : traj::check(scene, way.trajectory, options);
  return geom::thread_seconds() - start;
}

double warm_seconds(const geom::CollisionScene& scene, const Way& way, traj::Clearance clearance) {
  double least = 1e9;
  check_seconds(scene, way, clearance);  // builds what it touches
  for (int k = 0; k < 3; ++k) least = std::min(least, check_seconds(scene, way, clearance));
  return least;
}

// Of ways of one prefix.
struct Set {
  std::vector<double> us;
  double kilometres = 0;
};

void print(const std::string& name, Set& set) {
  std::sort(set.us.begin(), set.us.end());
  double sum = 0;
  for (const double us : set.us) sum += us;
  fmt::print("{}: {} ways, median {:.0f} us, most {:.0f}, {:.1f} us a km\n", name, set.us.size(),
             set.us[set.us.size() / 2], set.us.back(), sum / set.kilometres);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  using traj::Clearance;
  std::map<std::string, Set> warm, fresh;
  std::ifstream in(argv[2]);
  const auto map = geom::read_box_map(geom::ArrayArchive::map(argv[1]));
  std::optional<geom::CollisionScene> scene;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    const auto way = way_of(geom::JsonFields(line, argv[2], ++number));
    if (!way) continue;
    const auto scene_of_it = [&] {
      return geom::CollisionScene(map, *way->provenance.vehicle,
                                  way->provenance.margin.value_or(0));
    };
    if (!scene) scene.emplace(scene_of_it());
    const std::string name = way->id.substr(0, way->id.rfind('-'));
    const auto add = [&](Set& set, double seconds) {
      set.us.push_back(1e6 * seconds);
      set.kilometres += 1e-3 * way->length;
    };
    add(warm[name], warm_seconds(*scene, *way, Clearance::measured) -
                        warm_seconds(*scene, *way, Clearance::left_out));
    add(fresh[name], check_seconds(scene_of_it(), *way, Clearance::measured));
  }
  for (auto& [name, set] : warm) print(name, set);
  for (auto& [name, set] : fresh) print(name + ", fresh", set);
}
