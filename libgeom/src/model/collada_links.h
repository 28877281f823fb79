#pragma once

// What a COLLADA file names and assimp would leave out without a word, or fall over.

#include <string>
#include <string_view>

#include "geom/base/skipped.h"

namespace geom {

// Adds to `skipped` what is placed from elsewhere, is not there, or is no mesh. Throws InputError
// for a document type, an entity that is not one of XML itself, elements behind a prefix, a tag
// that does not end, a unit that is no number above 0 or not that of the whole file, an `up_axis`
// that is none of the three or not that of the whole file, accessors that reach beyond their
// numbers, comments within numbers, nodes that are within themselves or multiply beyond a million,
// skews, `lookat`, turns about axes of another length than 1, and what bones or morphs move.
void check_collada_links(std::string_view text, const std::string& source, Skipped& skipped);

}  // namespace geom
