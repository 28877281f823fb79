#pragma once

// COPC files of made-up points, by the tests' own LAZ encoder.

#include <algorithm>
#include <array>
#include <map>

#include "support/laz_file.h"

namespace support {

struct CopcFile {
  using Key = std::array<std::int32_t, 4>;  // level, x, y, z

  struct Entry {
    Key key;
    std::uint64_t place;
    std::int32_t bytes;
    std::int32_t points;
  };

  std::vector<LazFilePoint> points;  // in cubes, one after the other
  std::vector<std::pair<Key, std::size_t>> cubes;
  double scale = 0.01;
  double half = 512;  // the cube is centred there, too
  double spacing = 16;
  std::size_t page = 40;  // entries a page, but for the last of a page, which leads on
  std::vector<Entry> entries() const { return entries_of(laz()); }

  // Points of a scan: each cube keeps up to `most` and hands the others down.
  static CopcFile scan(std::size_t count, std::uint64_t seed, std::size_t most) {
    CopcFile file;
    Random random(seed);
    std::map<Key, std::vector<LazFilePoint>> nodes;
    for (std::size_t i = 0; i < count; ++i) {
      LazFilePoint p;
      const auto any = [&](std::uint32_t below) {
        return static_cast<std::int32_t>(chance(random, below));
      };
      p.x = any(100000);
      p.y = any(100000);
      p.z = any(i % 3 ? 500 : 4000);
      p.cls = static_cast<std::uint8_t>(any(7));
      file.put(p, nodes, most);
    }
    for (const auto& [key, inside] : nodes) {
      file.cubes.emplace_back(key, inside.size());
      file.points.insert(file.points.end(), inside.begin(), inside.end());
    }
    return file;
  }

  std::string bytes() const {
    return bytes_with([](std::vector<Entry>&) {});
  }

  // `change` may spoil the entries.
  template <class Change>
  std::string bytes_with(const Change& change) const {
    const LazFile file = laz();
    std::string out = file.bytes();
    std::vector<Entry> all = entries_of(file);
    change(all);
    const std::uint64_t first_later = out.size();
    std::memcpy(&out[235], &first_later, 8);
    const std::uint32_t later = 1;
    std::memcpy(&out[243], &later, 4);
    std::string head(60, '\0');
    std::memcpy(&head[2], "copc", 4);
    head[18] = static_cast<char>(1000 & 255);
    head[19] = static_cast<char>(1000 >> 8);
    const std::uint64_t root = out.size() + head.size();
    std::string hierarchy;
    std::size_t root_bytes = 0;
    for (std::size_t at = 0; at < all.size(); at += page) {
      const std::size_t end = std::min(at + page, all.size());
      for (std::size_t i = at; i < end; ++i) add(hierarchy, all[i]);
      if (end < all.size()) {
        const auto left = static_cast<std::int32_t>(std::min(page, all.size() - end));
        const bool more = end + page < all.size();
        add(hierarchy, {all[end].key, root + hierarchy.size() + 32, 32 * (left + more), -1});
      }
      if (at == 0) root_bytes = hierarchy.size();
    }
    const std::uint64_t size = hierarchy.size();
    std::memcpy(&head[20], &size, 8);
    std::memcpy(&out[375 + 54 + 40], &root, 8);
    std::memcpy(&out[375 + 54 + 48], &root_bytes, 8);
    return out + head + hierarchy;
  }

 private:
  void put(const LazFilePoint& p, std::map<Key, std::vector<LazFilePoint>>& nodes,
           std::size_t most) const {
    for (std::int32_t level = 0;; ++level) {
      const double side = 2 * half / (1 << level);
      const auto at = [&](std::int32_t v) { return static_cast<std::int32_t>(v * scale / side); };
      auto& node = nodes[{level, at(p.x), at(p.y), at(p.z)}];
      if (node.size() < most || level == 8) {
        node.push_back(p);
        return;
      }
    }
  }

  LazFile laz() const {
    LazFile file;
    file.format = 6;
    file.version = 3;
    file.layout = LazFile::Layout::varying;
    file.scale = scale;
    file.points = points;
    for (const auto& cube : cubes) file.sizes.push_back(cube.second);
    file.leading.assign(54 + 160, '\0');
    std::memcpy(&file.leading[2], "copc", 4);
    file.leading[18] = 1;
    file.leading[20] = static_cast<char>(160);
    const double info[] = {half, half, half, half, spacing};
    std::memcpy(&file.leading[54], info, sizeof info);
    return file;
  }

  std::vector<Entry> entries_of(const LazFile& file) const {
    std::vector<Entry> out;
    const auto places = file.chunk_places();
    for (std::size_t i = 0; i < cubes.size(); ++i) {
      out.push_back({cubes[i].first, places[i][0], static_cast<std::int32_t>(places[i][1]),
                     static_cast<std::int32_t>(cubes[i].second)});
    }
    return out;
  }

  static void add(std::string& to, const Entry& e) {
    to.append(reinterpret_cast<const char*>(e.key.data()), 16);
    to.append(reinterpret_cast<const char*>(&e.place), 8);
    to.append(reinterpret_cast<const char*>(&e.bytes), 4);
    to.append(reinterpret_cast<const char*>(&e.points), 4);
  }
};

}  // namespace support
