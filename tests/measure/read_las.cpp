// read_las [THREADS] FILE...: points a second that read_las reads of LAS and LAZ files, of CPU time
// and of wall time, the best of seven turns, in which the files are read one after the other.

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>

#include "geom/cloud/point_cloud.h"

namespace {

struct Best {
  std::size_t points = 0;
  double cpu = 1e9;   // seconds
  double wall = 1e9;  // seconds
};

void read(const std::string& name, unsigned threads, Best& best) {
  std::ifstream file(name, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  const geom::ReadAt ahead = [&](std::uint64_t at, std::span<unsigned char> to) {
    const std::size_t from = std::min<std::uint64_t>(at, bytes.size());
    return bytes.copy(reinterpret_cast<char*>(to.data()), to.size(), from);
  };
  std::istringstream in(bytes);
  const std::clock_t start = std::clock();
  const auto wall = std::chrono::steady_clock::now();
  best.points =
      geom::read_las(in, name, [](std::span<const geom::CloudPoint>) {}, {}, {{threads, {}}, ahead})
          .read;
  best.cpu = std::min(best.cpu, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  best.wall = std::min(
      best.wall, std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count());
}

}  // namespace

int main(int argc, char** argv) {
  const int threads = argc > 1 ? std::atoi(argv[1]) : 0;
  const int first = threads > 0 ? 2 : 1;
  std::map<std::string, Best> best;
  for (int turn = 0; turn < 7; ++turn) {
    for (int i = first; i < argc; ++i) {
      read(argv[i], static_cast<unsigned>(std::max(threads, 1)), best[argv[i]]);
    }
  }
  for (const auto& [name, b] : best) {
    const auto million = static_cast<double>(b.points) / 1e6;
    std::cout << name << ": " << b.points << " points, " << million / b.cpu
              << " million a second of CPU, " << million / b.wall << " of wall time\n";
  }
  return 0;
}
