#include "hashed_input.h"

#include <streambuf>
#include <vector>

#include "geom/base/sha256.h"

namespace cli {

class HashedInput::Buffer : public std::streambuf {
 public:
  explicit Buffer(InputFile& file) : file_(file), bytes_(1 << 16) { underflow(); }

  std::string_view filled() const { return {eback(), egptr()}; }

  std::string hash() {
    while (!traits_type::eq_int_type(underflow(), traits_type::eof()))
      setg(nullptr, nullptr, nullptr);
    return "sha256:" + sum_.hex();
  }

 private:
  int_type underflow() override {
    if (gptr() < egptr()) return traits_type::to_int_type(*gptr());
    file_.stream().read(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
    const std::streamsize n = file_.stream().gcount();
    if (n == 0) return traits_type::eof();
    sum_.update(std::as_bytes(std::span(bytes_.data(), static_cast<std::size_t>(n))));
    setg(bytes_.data(), bytes_.data(), bytes_.data() + n);
    return traits_type::to_int_type(*gptr());
  }

  InputFile& file_;
  std::vector<char> bytes_;
  geom::Sha256 sum_;
};

HashedInput::HashedInput(InputFile& file)
    : buffer_(std::make_unique<Buffer>(file)), stream_(buffer_.get()) {
  stream_.exceptions(std::ios::badbit);  // so that a failed read is thrown on with its reason
}
HashedInput::~HashedInput() = default;

std::string_view HashedInput::head() const { return buffer_->filled(); }
std::istream& HashedInput::stream() { return stream_; }
std::string HashedInput::hash() { return buffer_->hash(); }

}  // namespace cli
