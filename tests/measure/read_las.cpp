// read_las FILE...: points a second of CPU time that read_las reads of LAS and LAZ files, the best
// of seven turns, in which the files are read one after the other.

#include <ctime>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>

#include "geom/cloud/point_cloud.h"

int main(int argc, char** argv) {
  std::map<std::string, double> best;
  std::map<std::string, std::size_t> points;
  for (int turn = 0; turn < 7; ++turn) {
    for (int i = 1; i < argc; ++i) {
      std::ifstream file(argv[i], std::ios::binary);
      std::istringstream in(std::string(std::istreambuf_iterator<char>(file), {}));
      const std::clock_t start = std::clock();
      points[argv[i]] = geom::read_las(in, argv[i], [](std::span<const geom::CloudPoint>) {}).read;
      const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      if (turn == 0 || seconds < best[argv[i]]) best[argv[i]] = seconds;
    }
  }
  for (const auto& [name, seconds] : best) {
    std::cout << name << ": " << points[name] << " points, "
              << static_cast<double>(points[name]) / seconds / 1e6 << " million a second\n";
  }
  return 0;
}
