#pragma once

// What comments of a table say of its axes, as in "# frame: ned".
//
// Example:
//   const auto ned = geom::axes_of_comment("# frame: ned");
//   assert(ned && ned->axes == geom::Axes::neu && ned->downwards);
//   assert(!geom::axes_of_comment("# flown by Ned"));

#include <optional>
#include <string_view>

#include "geom/base/error.h"
#include "geom/base/vec3.h"
#include "geom/map/frame.h"

namespace geom {

struct CommentedAxes {
  std::optional<Axes> axes;  // nothing: others, such as FLU, or several
  bool downwards = false;    // z grows downwards, as in NED
};

// Nothing if the comment names no axes. It names some with ENU, NEU, NED, FLU and the like in
// capitals, with these, ECEF, LLA and WGS84 in any case behind a word such as "frame" or "axes" or
// alone, and with directions behind the letters of axes ("x north, y east, z down").
std::optional<CommentedAxes> axes_of_comment(std::string_view comment);

// A point in the axes of a comment, which are known, in others.
Vec3 in_axes(Axes axes, const CommentedAxes& from, const Vec3& point);

// Why a table cannot be read whose comment names axes that are not known, or not one of `read`.
Fault not_these_axes(std::string_view comment, std::string_view read);

}  // namespace geom
