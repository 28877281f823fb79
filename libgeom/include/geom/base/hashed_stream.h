#pragma once

// A stream that sums what is read of it, and whose beginning can be looked at before.
//
//   geom::HashedStream file(std::cin);
//   const geom::BoxFormat format = geom::box_format_of(file.head(), "stdin");
//   const auto boxes = geom::import_boxes(file.stream(), format, "stdin");
//   std::cout << file.hash();

#include <istream>
#include <memory>
#include <string>
#include <string_view>

namespace geom {

// Holds 64 KiB of the input at most.
class HashedStream {
 public:
  // Of what is left of `source`, which must outlive this and be read by nobody else.
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
