// union_check A B [SLACK]: whether two box maps cover exactly the same closed set; with a slack,
// whether every box of A lies in the boxes of B.

#include <fmt/format.h>

#include "geom/map/box_map_file.h"
#include "support/union_oracle.h"

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const geom::BoxMap a = geom::read_box_map(geom::ArrayArchive::map(argv[1]));
  const geom::BoxMap b = geom::read_box_map(geom::ArrayArchive::map(argv[2]));
  const std::size_t forth = oracle::not_held(a.boxes(), b.boxes());
  const std::size_t back = argc > 3 ? 0 : oracle::not_held(b.boxes(), a.boxes());
  fmt::print(
      "boxes {} and {}: of the first not in the second {}, of the second not in the first {}\n",
      a.size(), b.size(), forth, argc > 3 ? "not asked" : std::to_string(back));
  return forth + back != 0;
}
