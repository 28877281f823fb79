#pragma once

// What the readers of point clouds share.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <istream>
#include <string>
#include <vector>

#include "geom/base/error.h"
#include "geom/cloud/point_cloud.h"

namespace geom {

// Collects points and hands them on by the thousand.
class PointChunks {
 public:
  PointChunks(std::string_view source, const PointSink& sink) : source_(source), sink_(sink) {
    chunk_.reserve(kChunk);
  }

  void add(const Vec3& p, std::uint8_t cls = 0) {
    ++counts_.read;
    // Also false of what is no number.
    const bool near = (std::abs(p.x()) <= kLargestCoordinate) &
                      (std::abs(p.y()) <= kLargestCoordinate) &
                      (std::abs(p.z()) <= kLargestCoordinate);
    if (!near) return leave_out(p);
    chunk_.push_back({p, cls});
    if (chunk_.size() == kChunk) flush();
  }

  CloudCounts finish() {
    flush();
    return counts_;
  }

 private:
  static constexpr std::size_t kChunk = 1 << 14;

  void leave_out(const Vec3& p) {
    if (p.allFinite()) {
      throw InputError(source_, {.key = "point " + std::to_string(counts_.read),
                                 .expected = "within 1e8 m of the origin",
                                 .found = std::to_string(p.cwiseAbs().maxCoeff())});
    }
    ++counts_.not_finite;
  }

  void flush() {
    if (!chunk_.empty()) sink_(chunk_);
    chunk_.clear();
  }

  std::string source_;
  const PointSink& sink_;
  std::vector<CloudPoint> chunk_;
  CloudCounts counts_;
};

// A number of the file's bytes, swapped where the file is big endian.
template <class T>
T number_at(const unsigned char* bytes, bool big_endian = false) {
  unsigned char copy[sizeof(T)];
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    copy[i] = bytes[big_endian ? sizeof(T) - 1 - i : i];
  }
  T value;
  std::memcpy(&value, copy, sizeof(T));
  return value;
}

// A scalar of a file: floating point, or an integer with or without sign.
struct Scalar {
  char type = 'F';  // F, I or U
  int size = 4;

  bool valid() const {
    return type == 'F'
               ? size == 4 || size == 8
               : (type == 'I' || type == 'U') && (size == 1 || size == 2 || size == 4 || size == 8);
  }

  double at(const unsigned char* bytes, bool big_endian = false) const {
    if (type == 'F') {
      return size == 4 ? static_cast<double>(number_at<float>(bytes, big_endian))
                       : number_at<double>(bytes, big_endian);
    }
    const bool is_signed = type == 'I';
    switch (size) {
      case 1:
        return is_signed ? number_at<std::int8_t>(bytes) : number_at<std::uint8_t>(bytes);
      case 2:
        return is_signed ? number_at<std::int16_t>(bytes, big_endian)
                         : number_at<std::uint16_t>(bytes, big_endian);
      case 4:
        return is_signed ? number_at<std::int32_t>(bytes, big_endian)
                         : number_at<std::uint32_t>(bytes, big_endian);
      default:
        return is_signed ? static_cast<double>(number_at<std::int64_t>(bytes, big_endian))
                         : static_cast<double>(number_at<std::uint64_t>(bytes, big_endian));
    }
  }
};

// Reads records of `size` bytes, at most a megabyte at once whatever the count: f(record) each.
// Returns how many there were, up to `count`.
template <class F>
std::uint64_t for_each_record(std::istream& in, std::size_t size, std::uint64_t count, const F& f) {
  const std::uint64_t batch = std::max<std::uint64_t>(1, (1 << 20) / size);
  std::vector<unsigned char> bytes;
  std::uint64_t done = 0;
  while (done < count) {
    const std::uint64_t wanted = std::min(batch, count - done);
    bytes.resize(wanted * size);
    in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    const std::uint64_t got = static_cast<std::uint64_t>(in.gcount()) / size;
    for (std::uint64_t i = 0; i < got; ++i) f(bytes.data() + i * size);
    done += got;
    if (got < wanted) break;
  }
  return done;
}

}  // namespace geom
