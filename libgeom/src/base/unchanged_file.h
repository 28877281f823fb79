#pragma once

// Whether one mapped file is still as it was opened.

namespace geom {

// As require_mapped_files_unchanged() (geom/base/mapped_file.h), of the file alone that is mapped
// at this address.
void require_unchanged_at(const void* address);

}  // namespace geom
