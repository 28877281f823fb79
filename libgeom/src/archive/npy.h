#pragma once

// Arrays as NumPy stores them: format NPY 1.0.

#include <string>

#include "geom/archive/array_archive.h"
#include "zip_reader.h"

namespace geom {

// What comes before the array's bytes; as long as a multiple of kAlignment.
std::string npy_header(const NamedArray& array);

// The array that `entry` of the archive named `archive` holds, in place. InputError where it is no
// little-endian array in C order, or its bytes do not fit its shape or are not aligned.
ArrayArchive::Entry read_npy(const ZipEntry& entry, const std::string& archive);

}  // namespace geom
