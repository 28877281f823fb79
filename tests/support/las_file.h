#pragma once

// Small LAS files, made byte by byte.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "geom/base/vec3.h"

namespace support {

struct LasFile {
  struct Record {
    std::string user = "LASF_Projection";
    std::uint16_t id = 0;
    std::string data;
  };
  std::vector<Record> records;
  std::vector<geom::Vec3> points;
  double scale = 0.001;
  bool well_known_text = false;  // the flag of the header

  std::string bytes() const {
    std::string before;
    for (const Record& r : records) {
      std::string head(54, '\0');
      std::memcpy(head.data() + 2, r.user.data(), r.user.size());
      put<std::uint16_t>(head, 18, r.id);
      put<std::uint16_t>(head, 20, static_cast<std::uint16_t>(r.data.size()));
      before += head + r.data;
    }
    std::string out(227, '\0');
    std::memcpy(out.data(), "LASF", 4);
    put<std::uint16_t>(out, 6, well_known_text ? 0x10 : 0);
    out[24] = 1;
    out[25] = 2;
    put<std::uint16_t>(out, 94, 227);
    put<std::uint32_t>(out, 96, static_cast<std::uint32_t>(227 + before.size()));
    put<std::uint32_t>(out, 100, static_cast<std::uint32_t>(records.size()));
    put<std::uint16_t>(out, 105, 20);
    put<std::uint32_t>(out, 107, static_cast<std::uint32_t>(points.size()));
    for (std::size_t i = 0; i < 3; ++i) put<double>(out, 131 + 8 * i, scale);
    out += before;
    for (const geom::Vec3& p : points) {
      std::string point(20, '\0');
      for (std::size_t i = 0; i < 3; ++i) {
        const double v = std::round(p[static_cast<Eigen::Index>(i)] / scale);
        put<std::int32_t>(point, 4 * i, static_cast<std::int32_t>(v));
      }
      out += point;
    }
    return out;
  }

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
  template <class T>
  static void put(std::string& to, std::size_t at, T value) {
    std::memcpy(to.data() + at, &value, sizeof value);
  }
};

}  // namespace support
