#pragma once

// Block text, as courses use it: a `boundary` line and `block` lines.

#include <iosfwd>
#include <string_view>

#include "geom/import/box_format.h"

namespace geom {

// `boundary|block x0 y0 z0 x1 y1 z1 [r g b]`, fields by white space, `#` starts a comment. Throws
// InputError(source, line, …) unless there is exactly one boundary and at least one block; for a
// block without any extent, and a field that is not a finite number. Ids are line numbers, and a
// colour becomes the label "R G B"; the bounds are the boundary. Lines whose keyword is neither are
// skipped, because they may have been meant as blocks.
ImportedBoxes read_block_text(std::istream& in, std::string_view source);

extern const BoxFormat kBlockText;  // of box_formats()

}  // namespace geom
