#pragma once

// How far vehicles reach beyond the bounds of a map, and bounds that would hold them.
//
// Example:
//   geom::WiderBounds wider({{0, 0, 0}, {80, 60, 60}});
//   wider.add({{10, 10, 58}, {12, 12, 60.4}});
//   assert(wider.in_words() == "0.4 m above the ceiling, z = 60");
//   assert(wider.option() == "--ceiling 61");

#include <string>

#include "geom/shape/aabb.h"

namespace geom {

class WiderBounds {
 public:
  explicit WiderBounds(const Aabb& bounds) : bounds_(bounds), needed_(bounds) {}

  // A box that is to be inside: the whole vehicle, with its margin. Its corners are finite.
  void add(const Aabb& room) { needed_ = merged(needed_, room); }

  // A vehicle of these half sizes at this place, which reaches `out` metres beyond the bounds or
  // more, beside the face that it is furthest out of.
  void add(const Vec3& place, const Vec3& half, double out);

  // Whether anything reaches beyond the bounds.
  bool any() const;

  // How far, beside each face: "0.4 m above the ceiling, z = 60". Empty where nothing does.
  std::string in_words() const;

  // The option of `skyway-map bounds` that would do, rounded outward to whole metres. Empty where
  // nothing reaches beyond.
  std::string option() const;

  // What to do, as the end of a message. Empty where nothing reaches beyond.
  std::string advice() const;

 private:
  Aabb bounds_;
  Aabb needed_;
};

}  // namespace geom
