#pragma once

// Files that a reader opens itself, because one names others or is read more than once.
//
// Example:
//   const std::shared_ptr<std::istream> file = geom::open_file("house.obj");
//   std::string first_line;
//   std::getline(*file, first_line);
//   const geom::RandomFile map_file("city.boxmap");
//   std::array<unsigned char, 2> start;
//   assert(map_file.read(0, start) == 2 && start[0] == 'P');  // a ZIP

#include <cstdint>
#include <functional>
#include <istream>
#include <memory>
#include <span>
#include <string>

namespace geom {

// Opens a file as a stream, at its beginning. The stream throws where reading fails, so that a file
// that breaks off never looks like one that ends. A program that counts its files passes its own.
using OpenFile = std::function<std::shared_ptr<std::istream>(const std::string& path)>;

// Throws FileError where the file cannot be opened. At its end the stream throws
// std::runtime_error if somebody wrote to the file meanwhile (file_buffer.h).
std::shared_ptr<std::istream> open_file(const std::string& path);

// A regular file of which parts are read, anywhere. Threads may share it.
class RandomFile {
 public:
  // Throws FileError where it cannot be opened.
  explicit RandomFile(const std::string& path);
  ~RandomFile();
  RandomFile(const RandomFile&) = delete;
  RandomFile& operator=(const RandomFile&) = delete;

  // How many bytes there were, up to those asked for. Throws FileError where reading fails.
  std::size_t read(std::uint64_t at, std::span<unsigned char> to) const;

  std::uint64_t size() const { return size_; }  // bytes, when it was opened

 private:
  std::string path_;
  int descriptor_;
  std::uint64_t size_ = 0;
};

}  // namespace geom
