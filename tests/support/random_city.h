#pragma once

// Seeded random maps and segments whose faces often coincide with each other.

#include <random>

#include "geom/map/box_map.h"

namespace support {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  // A multiple of `step` in [low, high]: so that things touch exactly.
  double stepped(double low, double high, double step) {
    return low + step * std::floor(uniform(0, (high - low) / step + 1));
  }
  int below(int n) { return static_cast<int>(uniform(0, n)); }

 private:
  std::mt19937_64 engine_;
};

inline geom::BoxTable table_of(std::vector<geom::Aabb> boxes) {
  geom::BoxTable table;
  table.boxes = std::move(boxes);
  for (std::size_t i = 0; i < table.boxes.size(); ++i) table.ids.push_back(i + 1);
  table.label.assign(table.boxes.size(), 0);
  return table;
}

// Boxes on whole metres in a square of `side` metres around `center`, heights up to 60 m.
inline geom::BoxMap random_city(std::uint64_t seed, int count, double side,
                                const geom::Vec3& center = geom::Vec3::Zero()) {
  Random random(seed);
  std::vector<geom::Aabb> boxes;
  for (int i = 0; i < count; ++i) {
    const geom::Vec3 low(random.stepped(-side / 2, side / 2, 1),
                         random.stepped(-side / 2, side / 2, 1),
                         random.below(4) ? 0 : random.stepped(0, 30, 1));
    const geom::Vec3 size(random.stepped(0, 12, 1), random.stepped(1, 12, 1),
                          random.stepped(1, 60, 1));
    boxes.push_back({center + low, center + low + size});
  }
  if (count > 0) {  // one that spans many tiles
    boxes.push_back({center + geom::Vec3(-side / 2, 0, 40), center + geom::Vec3(side / 2, 3, 42)});
  }
  geom::BoxMapSpec spec;
  spec.bounds = {center + geom::Vec3(-side, -side, 0), center + geom::Vec3(side, side, 120)};
  spec.bounds_from = "obstacles";
  return geom::BoxMap(spec, table_of(boxes));
}

}  // namespace support
