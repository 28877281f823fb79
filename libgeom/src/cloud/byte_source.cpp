#include "byte_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "geom/base/error.h"

namespace geom {
namespace {

constexpr std::size_t kBuffer = 1 << 16;

}  // namespace

ByteSource::ByteSource(std::istream& in, std::uint64_t at, std::string_view source)
    : in_(&in), buffer_(kBuffer), behind_(at), source_(source) {
  begin_ = at_ = end_ = buffer_.data();
}

ByteSource::ByteSource(std::span<const unsigned char> bytes, std::uint64_t at,
                       std::string_view source)
    : begin_(bytes.data()),
      at_(bytes.data()),
      end_(bytes.data() + bytes.size()),
      behind_(at),
      source_(source) {}

bool ByteSource::fill() {
  if (!in_) return false;
  behind_ = position();
  in_->read(reinterpret_cast<char*>(buffer_.data()), static_cast<std::streamsize>(kBuffer));
  begin_ = at_ = buffer_.data();
  end_ = begin_ + in_->gcount();
  return at_ != end_;
}

void ByteSource::read(std::uint64_t count, std::vector<unsigned char>& to) {
  while (count > 0) {
    if (at_ == end_ && !fill()) end_too_early();
    const auto some = std::min(count, static_cast<std::uint64_t>(end_ - at_));
    to.insert(to.end(), at_, at_ + some);
    at_ += some;
    count -= some;
  }
}

std::size_t ByteSource::copy(std::span<unsigned char> to) {
  std::size_t copied = 0;
  while (copied < to.size() && (at_ != end_ || fill())) {
    const std::size_t some = std::min(to.size() - copied, static_cast<std::size_t>(end_ - at_));
    std::copy_n(at_, some, to.data() + copied);
    at_ += some;
    copied += some;
  }
  return copied;
}

std::uint64_t ByteSource::skip(std::uint64_t count) {
  std::uint64_t skipped = 0;
  while (skipped < count && (at_ != end_ || fill())) {
    const auto some = std::min(count - skipped, static_cast<std::uint64_t>(end_ - at_));
    at_ += some;
    skipped += some;
  }
  return skipped;
}

std::span<const unsigned char> ByteSource::load() {
  if (in_) {
    const std::uint64_t here = position();
    std::vector<unsigned char> all;
    while (at_ != end_ || fill()) {
      all.insert(all.end(), at_, end_);
      at_ = end_;
    }
    in_ = nullptr;
    buffer_ = std::move(all);
    behind_ = here;
    begin_ = at_ = buffer_.data();
    end_ = begin_ + buffer_.size();
  }
  return {at_, end_};
}

void ByteSource::refuse(Fault fault) const { throw InputError(source_, std::move(fault)); }

void ByteSource::end_too_early() const {
  refuse({.expected = fmt::format("more points at byte {}, where their bytes end", position()),
          .advice = "the file is cut short or damaged"});
}

}  // namespace geom
