#pragma once

// A stream that hashes the bytes that are read, and shows the beginning of the file before that.
//
// Example:
//   std::istringstream in("boundary 0 0 0 10 10 10\nblock 4 0 0 5 8 8\n");
//   geom::HashedStream file(in);
//   const geom::BoxFormat& format = geom::box_format_of(file.head(), "city.txt");
//   const geom::ImportedBoxes boxes = geom::import_boxes(file.stream(), format, "city.txt");
//   assert(file.hash().starts_with("sha256:"));

#include <istream>
#include <memory>
#include <string>
#include <string_view>

namespace geom {

// Holds 64 KiB of the input at most.
class HashedStream {
 public:
  // Reads on in `source`, which must outlive this object. No other code may read `source`.
  explicit HashedStream(std::istream& source);
  ~HashedStream();
  HashedStream(const HashedStream&) = delete;
  HashedStream& operator=(const HashedStream&) = delete;

  std::string_view head() const;  // up to 64 KiB from the start; before anything else is read
  std::istream& stream();         // throws where reading the source does

  // "sha256:…" of the whole input. What was left unread is read to its end.
  std::string hash();

 private:
  class Buffer;
  std::unique_ptr<Buffer> buffer_;
  std::istream stream_;
};

}  // namespace geom
