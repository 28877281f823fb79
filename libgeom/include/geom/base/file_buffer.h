#pragma once

// The buffer of a stream that reads a file. It refuses a file that somebody writes to meanwhile.
//
// Example:
//   geom::FileBuffer buffer("house.obj");
//   std::istream in(&buffer);
//   in.exceptions(std::ios::badbit);  // so that what the buffer throws is thrown on
//   std::string first_line;
//   std::getline(in, first_line);

#include <cstddef>
#include <functional>
#include <optional>
#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/mapped_file.h"

namespace geom {

// Throws FileError where reading fails, so that a file that breaks off never looks like one that
// ends. At the end of a regular file it throws std::runtime_error if somebody wrote to the file
// since it was opened: what was read may be a mixture of old and new. Whoever stops reading before
// the end is not told. Pipes and devices are not watched.
class FileBuffer : public std::streambuf {
 public:
  // Throws FileError where the file cannot be opened, and for a folder.
  explicit FileBuffer(const std::string& path);

  // Reads on from a descriptor, which it closes in the end. `name` is for messages; `first` gets
  // the first bytes that are read.
  FileBuffer(int descriptor, std::string name, std::function<void(std::string_view)> first = {});

  // Returns the beginning of the file, which stays to be read. It waits for more until `enough` is
  // true, there are `most` bytes (64 KiB at most), or the file ends. Call it before any reading.
  std::string_view head_until(const std::function<bool(std::string_view)>& enough,
                              std::size_t most);

 private:
  int_type underflow() override;
  std::size_t fill(char* place);

  struct Descriptor {
    explicit Descriptor(int opened) : number(opened) {}
    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int number;
  };

  Descriptor descriptor_;
  std::string name_;
  std::function<void(std::string_view)> first_;
  std::optional<FileState> opened_;
  std::vector<char> buffer_;
};

}  // namespace geom
