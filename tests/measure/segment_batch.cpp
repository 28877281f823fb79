// segment_batch MAP SEGMENTS THREADS REPEATS: hits() of a file of float64 (n, 6) for box:1,1,1, as
// the libraries' own batch. Prints the seconds of the best of the repeats, and how many hit.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/map/box_map_file.h"

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const auto map = geom::read_box_map(geom::ArrayArchive::map(argv[1]));
  const geom::CollisionScene scene(map, {"box:1,1,1", {1, 1, 1}}, 0);
  std::ifstream file(argv[2], std::ios::binary | std::ios::ate);
  std::vector<std::pair<geom::Vec3, geom::Vec3>> segments(static_cast<std::size_t>(file.tellg()) /
                                                          48);
  file.seekg(0);
  file.read(reinterpret_cast<char*>(segments.data()),
            static_cast<std::streamsize>(segments.size() * 48));
  const geom::Execution run{static_cast<unsigned>(std::atoi(argv[3])), {}};
  double best = 1e9;
  std::ptrdiff_t count = 0;
  for (int i = 0; i < std::atoi(argv[4]); ++i) {
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<std::uint8_t> hits = scene.hits(segments, run);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    best = std::min(best, took.count());
    count = std::count(hits.begin(), hits.end(), 1);
  }
  fmt::print("{} {}\n", best, count);
}
