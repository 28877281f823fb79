// reach MAP PAIRS SEED: how long it takes to say whether there is a way between two random free
// places, for box:1,1,1: thread CPU seconds of the first question, then the median and the longest
// of the pairs after it, each asked twice, with how many cells were looked at.

#include "plan/reach/reach.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "geom/base/thread_seconds.h"
#include "geom/map/box_map_file.h"
#include "support/random_city.h"

namespace {

geom::Vec3 free_place(const geom::CollisionScene& scene, support::Random& random) {
  const geom::Aabb& room = *scene.free_bounds();
  while (true) {
    geom::Vec3 p;
    for (int i = 0; i < 3; ++i) p[i] = random.uniform(room.min[i], room.max[i]);
    if (scene.free(p)) return p;
  }
}

template <class List>
auto middle(List list) {
  std::nth_element(list.begin(), list.begin() + list.size() / 2, list.end());
  return list[list.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const auto map = geom::read_box_map(geom::ArrayArchive::map(argv[1]));
  const geom::CollisionScene scene(map, {"box:1,1,1", {1, 1, 1}}, 0);
  support::Random random(static_cast<std::uint64_t>(std::atoll(argv[3])));
  plan::Reach reach(scene);
  std::vector<double> cold;
  std::vector<double> warm;
  std::vector<std::size_t> cells;
  std::size_t apart = 0;
  double first = 0;
  for (int i = 0; i <= std::atoi(argv[2]); ++i) {
    const geom::Vec3 from = free_place(scene, random);
    const geom::Vec3 to = free_place(scene, random);
    plan::ReachResult result;
    const auto timed = [&] {
      const double begin = geom::thread_seconds();
      result = reach.ask(from, to);
      return geom::thread_seconds() - begin;
    };
    const double once = timed();
    if (i == 0) {
      first = once;
      continue;
    }
    cold.push_back(once);
    warm.push_back(timed());
    cells.push_back(result.looked_at);
    apart += result.answer == plan::Reachable::no;
    if (result.answer == plan::Reachable::unknown) fmt::print("unknown\n");
  }
  fmt::print("first {:.3f} ms\n", 1e3 * first);
  fmt::print("asked once: median {:.3f} ms, longest {:.3f} ms\n", 1e3 * middle(cold),
             1e3 * *std::max_element(cold.begin(), cold.end()));
  fmt::print("asked again: median {:.3f} ms, longest {:.3f} ms\n", 1e3 * middle(warm),
             1e3 * *std::max_element(warm.begin(), warm.end()));
  fmt::print("cells: median {}, most {}; {} of {} apart\n", middle(cells),
             *std::max_element(cells.begin(), cells.end()), apart, cold.size());
}
