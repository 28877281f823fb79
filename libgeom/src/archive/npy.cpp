#include "npy.h"

#include <fmt/format.h>

#include <charconv>
#include <cstring>
#include <optional>

#include "geom/archive/bytes.h"
#include "geom/base/error.h"
#include "geom/text/excerpt.h"
#include "zip_format.h"

namespace geom {
namespace {

constexpr std::string_view kNpyMark("\x93NUMPY\x01\x00", 8);
constexpr std::size_t kDictAt = kNpyMark.size() + 2;  // after the mark and the length

std::string_view between(std::string_view text, std::string_view before, char after) {
  const std::size_t at = text.find(before);
  if (at == std::string_view::npos) return {};
  text.remove_prefix(at + before.size());
  return text.substr(0, text.find(after));
}

std::optional<std::vector<std::size_t>> parse_shape(std::string_view text) {
  std::vector<std::size_t> shape;
  for (const char* at = text.data(); at < text.data() + text.size();) {
    std::size_t n = 0;
    const auto [rest, error] = std::from_chars(at, text.data() + text.size(), n);
    if (error != std::errc()) return std::nullopt;
    shape.push_back(n);
    at = rest;
    while (at < text.data() + text.size() && (*at == ',' || *at == ' ')) ++at;
  }
  return shape;
}

std::size_t item_size(std::string_view dtype) {
  for (const std::string_view known :
       {"<f8", "<f4", "<i8", "<i4", "<i2", "|i1", "<u8", "<u4", "<u2", "|u1"}) {
    if (dtype == known) return static_cast<std::size_t>(known[2] - '0');
  }
  return 0;
}

// True when rows x columns x … items of `item` bytes are exactly `size` bytes.
bool fits(const std::vector<std::size_t>& shape, std::size_t item, std::size_t size) {
  std::size_t total = item;
  for (const std::size_t n : shape) {
    if (__builtin_mul_overflow(total, n, &total)) return false;
  }
  return total == size;
}

}  // namespace

std::string npy_header(const NamedArray& array) {
  std::string shape;
  for (const std::size_t n : array.shape) shape += fmt::format("{}, ", n);
  if (array.shape.size() > 1) shape.resize(shape.size() - 2);
  if (array.shape.size() == 1) shape.pop_back();
  std::string dict =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", array.dtype, shape);
  const std::size_t used = kDictAt + dict.size() + 1;
  dict.append((kAlignment - used % kAlignment) % kAlignment, ' ');
  dict += '\n';
  std::string header(kNpyMark);
  append_bytes(header, static_cast<std::uint16_t>(dict.size()));
  return header + dict;
}

ArrayArchive::Entry read_npy(const ZipEntry& zip, const std::string& archive) {
  const auto refuse = [&](Fault fault) {
    throw InputError(archive, within(excerpt(zip.name), std::move(fault)));
  };
  const std::string_view text(reinterpret_cast<const char*>(zip.bytes.data()), zip.bytes.size());
  if (text.size() < kDictAt || !text.starts_with(kNpyMark)) {
    refuse({.expected = "a NumPy array of format 1.0", .found = "something else"});
  }
  std::uint16_t length = 0;
  std::memcpy(&length, text.data() + kNpyMark.size(), sizeof length);
  if (length > text.size() - kDictAt)
    refuse({.says = "the array's header is longer than the entry"});
  const std::string_view dict = text.substr(kDictAt, length);
  ArrayArchive::Entry entry;
  entry.name = zip.name;
  entry.crc = zip.crc;
  entry.stored = zip.bytes;
  entry.bytes = zip.bytes.subspan(kDictAt + length);
  entry.dtype = between(dict, "'descr': '", '\'');
  const auto shape = parse_shape(between(dict, "'shape': (", ')'));
  const std::size_t item = item_size(entry.dtype);
  if (item == 0 || !shape || dict.find("'fortran_order': False") == std::string_view::npos) {
    refuse({.expected = "a little-endian array in C order", .found = excerpt(dict)});
  }
  entry.shape = *shape;
  if (!fits(entry.shape, item, entry.bytes.size())) {
    refuse({.says = fmt::format("the shape ({}) does not fit {} bytes of {}",
                                excerpt(fmt::format("{}", fmt::join(entry.shape, ", "))),
                                entry.bytes.size(), entry.dtype)});
  }
  if (reinterpret_cast<std::uintptr_t>(entry.bytes.data()) % item != 0) {
    refuse({.says = "the data must be aligned in the file, and is not"});
  }
  return entry;
}

}  // namespace geom
