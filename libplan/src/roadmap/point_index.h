#pragma once

// The nearest of a growing set of points.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "geom/base/vec3.h"

namespace plan {

// Balanced k-d trees of doubling sizes (Bentley and Saxe 1980), one after the other in a single
// array, the middle of a range being its root. Exact for the distances as rounded: the same answers
// as looking at every point. Inserting costs O(log^2 n) on average, finding the nearest about that.
class PointIndex {
 public:
  void insert(const geom::Vec3& point, std::uint32_t id);

  // The id of the point nearest to `p`, the lowest where several are. There must be one.
  std::uint32_t nearest(const geom::Vec3& p) const;

  // The ids of the points within `radius` metres (closed), ascending.
  std::vector<std::uint32_t> within(const geom::Vec3& p, double radius) const;

 private:
  struct Entry {
    geom::Vec3 point;
    std::uint32_t id;
    std::uint8_t axis;  // that the range is split along, where this is its middle
  };
  // The best so far: what is farther than `reach` is of no interest.
  struct Nearest {
    double reach = std::numeric_limits<double>::infinity();  // metres squared
    std::uint32_t id = std::numeric_limits<std::uint32_t>::max();

    void offer(double squared, std::uint32_t candidate);
  };
  struct Within {
    double reach;
    std::vector<std::uint32_t> ids;

    void offer(double squared, std::uint32_t candidate);
  };

  void build(std::size_t low, std::size_t high);
  template <class Search>
  void search(const geom::Vec3& p, Search& found) const;
  template <class Search>
  void search(std::size_t low, std::size_t high, const geom::Vec3& p, const geom::Vec3& outside,
              Search& found) const;

  std::vector<Entry> entries_;
};

}  // namespace plan
