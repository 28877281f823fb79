// make_las TABLE N FILE: N points scanned from the roofs, walls and ground of an FCND table, as LAS
// 1.2, point format 0, millimetres, far from the origin as surveys are.

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <vector>

#include "geom/import/fcnd_csv.h"
#include "support/random_city.h"

namespace {

template <class T>
void put(std::vector<char>& bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  std::ifstream in(argv[1]);
  const geom::FcndTable table = geom::read_fcnd_csv(in, argv[1]);
  const auto n = static_cast<std::uint32_t>(std::atof(argv[2]));
  std::ofstream out(argv[3], std::ios::binary);
  std::vector<char> header(227);
  std::memcpy(header.data(), "LASF", 4);
  header[24] = 1;
  header[25] = 2;
  put<std::uint16_t>(header, 94, 227);
  put<std::uint32_t>(header, 96, 227);
  put<std::uint16_t>(header, 105, 20);
  put<std::uint32_t>(header, 107, n);
  for (const std::size_t i : {0, 1, 2}) put(header, 131 + 8 * i, 0.001);
  put(header, 155, 500000.0);
  put(header, 163, 5400000.0);
  out.write(header.data(), 227);
  support::Random random(1);
  geom::Aabb all = table.table.boxes.front();
  for (const geom::Aabb& box : table.table.boxes) all = geom::merged(all, box);
  std::vector<char> record(20);
  for (std::uint32_t k = 0; k < n; ++k) {
    geom::Vec3 p(random.uniform(all.min[0], all.max[0]), random.uniform(all.min[1], all.max[1]), 0);
    if (k % 4) {  // a wall, twice a roof
      const geom::Aabb& box = table.table.boxes[static_cast<std::size_t>(
          random.below(static_cast<int>(table.table.boxes.size())))];
      for (int i = 0; i < 3; ++i) p[i] = random.uniform(box.min[i], box.max[i]);
      const int axis = k % 4 == 1 ? random.below(2) : 2;
      p[axis] = box.max[axis];
    }
    for (int i = 0; i < 3; ++i) {
      put(record, 4 * static_cast<std::size_t>(i),
          static_cast<std::int32_t>(std::lround(p[i] * 1000)));
    }
    out.write(record.data(), 20);
  }
  return out ? 0 : 4;
}
