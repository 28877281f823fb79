#pragma once

// Small LAS files, made byte by byte.

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "geom/base/vec3.h"
#include "support/random_city.h"

namespace support {

struct LasFile {
  struct Record {
    std::string user = "LASF_Projection";
    std::uint16_t id = 0;
    std::string data;
  };
  std::vector<Record> records;
  std::vector<Record> later;  // behind the points, of LAS 1.4
  std::vector<geom::Vec3> points;
  geom::Vec3 scale = geom::Vec3::Constant(0.001);
  geom::Vec3 offset = geom::Vec3::Zero();
  bool well_known_text = false;  // the flag of the header
  unsigned minor = 2;            // of LAS 1.x
  unsigned format = 0;           // of the points
  std::size_t extra = 0;         // bytes a point
  std::size_t own = 0;           // bytes of its writer behind the header, and before the points
  std::uint64_t seed = 0;        // of flags, classes, times and colours; 0: all of them are 0

  std::string bytes() const {
    std::string before;
    for (const Record& r : records) before += head_of(r, 54) + r.data;
    const std::size_t header = (minor < 3 ? 227 : minor == 3 ? 235 : 375) + own;
    std::string out(header, '\0');
    std::memcpy(out.data(), "LASF", 4);
    put<std::uint16_t>(out, 6, well_known_text ? 0x10 : 0);
    out[24] = 1;
    out[25] = static_cast<char>(minor);
    put<std::uint16_t>(out, 94, static_cast<std::uint16_t>(header));
    put<std::uint32_t>(out, 96, static_cast<std::uint32_t>(header + before.size() + own));
    put<std::uint32_t>(out, 100, static_cast<std::uint32_t>(records.size()));
    out[104] = static_cast<char>(format);
    put<std::uint16_t>(out, 105, static_cast<std::uint16_t>(record_size()));
    put_count(out, points.size());
    for (int i = 0; i < 3; ++i) {
      put<double>(out, 131 + 8 * static_cast<std::size_t>(i), scale[i]);
      put<double>(out, 155 + 8 * static_cast<std::size_t>(i), offset[i]);
    }
    out += before + std::string(own, '\x5a') + records_of_points();
    if (minor < 4 || later.empty()) return out;
    put<std::uint64_t>(out, 235, out.size());
    put<std::uint32_t>(out, 243, static_cast<std::uint32_t>(later.size()));
    for (const Record& r : later) out += head_of(r, 60) + r.data;
    return out;
  }

  // What the header of `file` counts.
  void put_count(std::string& file, std::uint64_t count) const {
    if (format < 6) put<std::uint32_t>(file, 107, static_cast<std::uint32_t>(count));
    if (minor == 4) put<std::uint64_t>(file, 247, count);
  }

  // As the integers of the file hold it.
  geom::Vec3 held(const geom::Vec3& p) const { return stored(p).cwiseProduct(scale) + offset; }

  // A GeoKeyDirectory of keys whose values are in place.
  static Record geo_keys(const std::vector<std::pair<std::uint16_t, std::uint16_t>>& keys) {
    Record out{"LASF_Projection", 34735, std::string(8 * (keys.size() + 1), '\0')};
    put<std::uint16_t>(out.data, 0, 1);
    put<std::uint16_t>(out.data, 2, 1);
    put<std::uint16_t>(out.data, 6, static_cast<std::uint16_t>(keys.size()));
    for (std::size_t i = 0; i < keys.size(); ++i) {
      put<std::uint16_t>(out.data, 8 * (i + 1), keys[i].first);
      put<std::uint16_t>(out.data, 8 * (i + 1) + 4, 1);
      put<std::uint16_t>(out.data, 8 * (i + 1) + 6, keys[i].second);
    }
    return out;
  }

  static Record text(const std::string& wkt) { return {"LASF_Projection", 2112, wkt + '\0'}; }

 private:
  std::size_t record_size() const {
    constexpr std::size_t kSizes[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
    return kSizes[format] + extra;
  }

  geom::Vec3 stored(const geom::Vec3& p) const {
    return (p - offset).cwiseQuotient(scale).array().round();
  }

  std::string records_of_points() const {
    Random random(seed);
    std::string out;
    for (const geom::Vec3& p : points) {
      std::string record(record_size(), '\0');
      for (char& c : record) c = seed ? static_cast<char>(random.below(256)) : '\0';
      for (std::size_t i = 0; i < 3; ++i) {
        put<std::int32_t>(record, 4 * i,
                          static_cast<std::int32_t>(stored(p)[static_cast<Eigen::Index>(i)]));
      }
      out += record;
    }
    return out;
  }

  // Of 54 bytes before the points, and of 60 behind them.
  static std::string head_of(const Record& record, std::size_t size) {
    std::string head(size, '\0');
    std::memcpy(head.data() + 2, record.user.data(), record.user.size());
    put<std::uint16_t>(head, 18, record.id);
    put<std::uint16_t>(head, 20, static_cast<std::uint16_t>(record.data.size()));
    return head;
  }

  template <class T>
  static void put(std::string& to, std::size_t at, T value) {
    std::memcpy(to.data() + at, &value, sizeof value);
  }
};

}  // namespace support
