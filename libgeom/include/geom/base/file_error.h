#pragma once

// The exception for a file that the system does not let us read or write.
//
// Example:
//   try {
//     throw geom::FileError(geom::FileUse::reading, "city.csv", ENOENT);
//   } catch (const geom::FileError& error) {
//     assert(error.path() == "city.csv");
//   }

#include <cstdint>
#include <memory>
#include <string>
#include <system_error>

namespace geom {

enum class FileUse : std::uint8_t { reading, writing };

// what() reads "cannot read PATH: why". code() is of the generic category.
class FileError : public std::system_error {
 public:
  // `error` is an errno; 0 stands for EIO, where the system gives no reason.
  FileError(FileUse use, std::string path, int error);

  FileUse use() const noexcept { return use_; }
  const std::string& path() const noexcept { return *path_; }

 private:
  FileUse use_;
  std::shared_ptr<const std::string> path_;  // shared, because a copy must not throw
};

}  // namespace geom
