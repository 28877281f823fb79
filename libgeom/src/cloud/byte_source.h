#pragma once

// Bytes of a file from some place on, one after the other: of a stream, by the buffer, or of
// memory.

#include <cstdint>
#include <istream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/error.h"

namespace geom {

// Reads past the end throw InputError. What `bytes` shows and `in` must outlive it. It may have
// read the stream further than it has handed out.
class ByteSource {
 public:
  // `at` is the place in the file of the next byte of `in`.
  ByteSource(std::istream& in, std::uint64_t at, std::string_view source);
  ByteSource(std::span<const unsigned char> bytes, std::uint64_t at, std::string_view source);
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  unsigned char next() {
    if (at_ == end_ && !fill()) end_too_early();
    return *at_++;
  }

  template <class T>
  T number() {  // little endian
    std::uint64_t value = 0;
    for (unsigned i = 0; i < sizeof(T); ++i) value |= std::uint64_t{next()} << (8 * i);
    return static_cast<T>(value);
  }

  // Appends `count` bytes; memory grows as they come, whatever the count.
  void read(std::uint64_t count, std::vector<unsigned char>& to);

  // Fills `to` as far as there are bytes; how many there were.
  std::size_t copy(std::span<unsigned char> to);

  // What can be looked at where it lies: none only at the end. Stays until more is read.
  std::span<const unsigned char> ready() {
    if (at_ == end_) fill();
    return {at_, end_};
  }

  // How many of `count` bytes there were to skip.
  std::uint64_t skip(std::uint64_t count);

  // Takes all that is left into memory, from where next() then goes on; returns it.
  std::span<const unsigned char> load();

  std::uint64_t position() const { return behind_ + static_cast<std::uint64_t>(at_ - begin_); }

  const std::string& source() const { return source_; }
  [[noreturn]] void refuse(Fault fault) const;

 private:
  bool fill();
  [[noreturn]] void end_too_early() const;

  std::istream* in_ = nullptr;
  std::vector<unsigned char> buffer_;
  const unsigned char* begin_ = nullptr;
  const unsigned char* at_ = nullptr;
  const unsigned char* end_ = nullptr;
  std::uint64_t behind_;  // the place in the file of *begin_
  std::string source_;
};

}  // namespace geom
