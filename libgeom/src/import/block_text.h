#pragma once

// Block text, as courses use it: a `boundary` line and `block` lines.

#include <iosfwd>
#include <string_view>

#include "geom/base/skipped.h"
#include "geom/map/box_map.h"

namespace geom {

struct BlockText {
  BoxTable table;  // ids are line numbers; a colour becomes the label "R G B"
  Aabb boundary;
  Skipped skipped;           // lines whose keyword is neither: they may have been meant as blocks
  std::size_t flat = 0;      // blocks without extent along one or two axes: kept
  std::size_t reversed = 0;  // lines whose second corner is below the first: their box is between
};

// `boundary|block x0 y0 z0 x1 y1 z1 [r g b]`, fields by white space, `#` starts a comment. Throws
// InputError(source, line, …) unless there is exactly one boundary and at least one block; for a
// block without any extent, and a field that is not a finite number.
BlockText read_block_text(std::istream& in, std::string_view source);

struct BoxFormat;
extern const BoxFormat kBlockText;  // of box_formats()

}  // namespace geom
