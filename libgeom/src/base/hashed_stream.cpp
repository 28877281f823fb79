#include "geom/base/hashed_stream.h"

#include <span>
#include <streambuf>
#include <vector>

#include "geom/base/sha256.h"

namespace geom {

class HashedStream::Buffer : public std::streambuf {
 public:
  explicit Buffer(std::istream& source) : source_(source), bytes_(1 << 16) { underflow(); }

  std::string_view filled() const { return {eback(), egptr()}; }

  std::string hash() {
    while (!traits_type::eq_int_type(underflow(), traits_type::eof()))
      setg(nullptr, nullptr, nullptr);
    return "sha256:" + sum_.hex();
  }

 private:
  int_type underflow() override {
    if (gptr() < egptr()) return traits_type::to_int_type(*gptr());
    source_.read(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
    const std::streamsize n = source_.gcount();
    if (n == 0) return traits_type::eof();
    sum_.update(std::as_bytes(std::span(bytes_.data(), static_cast<std::size_t>(n))));
    setg(bytes_.data(), bytes_.data(), bytes_.data() + n);
    return traits_type::to_int_type(*gptr());
  }

  std::istream& source_;
  std::vector<char> bytes_;
  Sha256 sum_;
};

HashedStream::HashedStream(std::istream& source)
    : buffer_(std::make_unique<Buffer>(source)), stream_(buffer_.get()) {
  stream_.exceptions(std::ios::badbit);  // so that a failed read is thrown on with its reason
}
HashedStream::~HashedStream() = default;

std::string_view HashedStream::head() const { return buffer_->filled(); }
std::istream& HashedStream::stream() { return stream_; }
std::string HashedStream::hash() { return buffer_->hash(); }

}  // namespace geom
