#pragma once

// Archives of NumPy arrays: uncompressed ZIPs with one meta.json, made to be mapped.
//
// Example:
//   const std::vector<double> heights = {1, 2, 3};
//   const std::vector arrays = {geom::named_array<double>("heights", heights)};
//   std::ostringstream out;
//   geom::write_array_archive(out, R"({"unit":"m"})", arrays);
//   const std::string bytes = out.str();
//   const auto archive = geom::ArrayArchive::from_bytes(std::as_bytes(std::span(bytes)), "a.zip");
//   assert(archive.array<double>("heights")[2] == 3);

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "geom/base/execution.h"
#include "geom/base/mapped_file.h"

namespace geom {

// NumPy's word for a type, little endian: "<f8", "<i4", "|u1", …
template <class T>
constexpr std::string_view dtype_of() {
  static_assert(std::is_arithmetic_v<T>);
  if constexpr (std::is_floating_point_v<T>) {
    return sizeof(T) == 8 ? "<f8" : "<f4";
  } else if constexpr (std::is_signed_v<T>) {
    return sizeof(T) == 8 ? "<i8" : sizeof(T) == 4 ? "<i4" : sizeof(T) == 2 ? "<i2" : "|i1";
  } else {
    return sizeof(T) == 8 ? "<u8" : sizeof(T) == 4 ? "<u4" : sizeof(T) == 2 ? "<u2" : "|u1";
  }
}

struct NamedArray {
  std::string name;  // without ".npy"
  std::string dtype;
  std::vector<std::size_t> shape;                  // C order
  std::vector<std::span<const std::byte>> pieces;  // one after the other
};

// An array with one entry a row, or with `columns` entries a row if that is not 0.
template <class T>
NamedArray named_array(std::string name, std::span<const T> values, std::size_t columns = 0) {
  std::vector<std::size_t> shape = {values.size()};
  if (columns) shape = {values.size() / columns, columns};
  return {std::move(name), std::string(dtype_of<T>()), std::move(shape), {std::as_bytes(values)}};
}

// Writes without seeking. The data of every array starts at a multiple of 64 bytes, the ZIP's clock
// stands at 1980-01-01, and equal content gives equal bytes.
void write_array_archive(std::ostream& out, std::string_view meta_json,
                         std::span<const NamedArray> arrays);

// An opened archive. It is cheap to copy, and its views stay valid while any copy, or what
// keep_alive() gives, lives. Opening checks the directory, the headers, shapes and sizes against
// the bytes that are there, and refuses compression, encryption, duplicates and overlaps; every
// failure is an InputError that names the file. Opening looks at neither values nor checksums: see
// verify().
class ArrayArchive {
 public:
  struct Entry {
    std::string name;  // in the ZIP, "boxes.npy"
    std::string dtype;
    std::vector<std::size_t> shape;
    std::span<const std::byte> bytes;   // the array's data alone
    std::span<const std::byte> stored;  // the whole ZIP entry
    std::uint32_t crc = 0;
  };

  static ArrayArchive map(const std::string& path);  // read-only, not copied
  static ArrayArchive from_bytes(std::span<const std::byte> bytes, std::string name);

  const std::string& name() const;  // for messages
  std::string_view meta() const;    // meta.json
  std::span<const Entry> arrays() const;
  bool has(std::string_view array) const;

  // A view of an array of this type with rows of `columns` (0: one dimension). Throws InputError if
  // it is missing or of another type or shape.
  template <class T>
  std::span<const T> array(std::string_view array, std::size_t columns = 0) const {
    const Entry& entry = find(array, dtype_of<T>(), columns);
    return {reinterpret_cast<const T*>(entry.bytes.data()), entry.bytes.size() / sizeof(T)};
  }

  // Verifies every checksum. Throws InputError at the first that differs.
  void verify(const Execution& run = {}) const;

  // A hash of meta.json and of the directory: names, types, shapes and checksums of all arrays,
  // "sha256:…". It reads no array. If two archives are not damaged and have the same hash, they
  // hold the same.
  std::string directory_hash() const;

  std::optional<FileState> file() const;  // where it is mapped: as it was opened
  std::shared_ptr<const void> keep_alive() const;

 private:
  struct Data;
  explicit ArrayArchive(std::shared_ptr<const Data> data);
  const Entry& find(std::string_view array, std::string_view dtype, std::size_t columns) const;
  static ArrayArchive open(std::shared_ptr<Data> data);

  std::shared_ptr<const Data> data_;
};

}  // namespace geom
