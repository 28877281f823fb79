#include "geom/base/file_error.h"

#include <utility>

namespace geom {

FileError::FileError(FileUse use, std::string path, int error)
    : std::system_error(error ? error : EIO, std::generic_category(),
                        (use == FileUse::reading ? "cannot read " : "cannot write ") + path),
      use_(use),
      path_(std::make_shared<const std::string>(std::move(path))) {}

}  // namespace geom
