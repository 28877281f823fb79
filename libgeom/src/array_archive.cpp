#include "geom/io/array_archive.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <optional>
#include <ostream>

#include "crc.h"
#include "geom/error.h"
#include "geom/mapped_file.h"
#include "npy.h"
#include "stretch.h"
#include "zip_format.h"
#include "zip_reader.h"
#include "zip_writer.h"

namespace geom {

void write_array_archive(std::ostream& out, std::string_view meta_json,
                         std::span<const NamedArray> arrays) {
  ZipWriter zip(out);
  zip.add("meta.json", meta_json, {});
  for (const NamedArray& array : arrays)
    zip.add(array.name + ".npy", npy_header(array), array.pieces);
  zip.finish();
}

struct ArrayArchive::Data {
  std::string name;
  std::span<const std::byte> bytes;
  std::vector<Entry> arrays;
  std::string_view meta;
  std::uint32_t meta_crc = 0;
  std::optional<MappedFile> mapped;
  std::byte* owned = nullptr;

  Data() = default;
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;
  ~Data() {
    if (owned) ::operator delete (owned, std::align_val_t{kAlignment});
  }
};

ArrayArchive::ArrayArchive(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

ArrayArchive ArrayArchive::open(std::shared_ptr<Data> data) {
  bool has_meta = false;
  for (const ZipEntry& zip : read_zip(data->bytes, data->name)) {
    if (zip.name == "meta.json") {
      data->meta = {reinterpret_cast<const char*>(zip.bytes.data()), zip.bytes.size()};
      data->meta_crc = zip.crc;
      has_meta = true;
    } else {
      data->arrays.push_back(read_npy(zip, data->name));
    }
  }
  if (!has_meta) throw InputError(data->name, "expected an entry meta.json, found none");
  return ArrayArchive(std::move(data));
}

ArrayArchive ArrayArchive::map(const std::string& path) {
  auto data = std::make_shared<Data>();
  data->name = path;
  data->bytes = data->mapped.emplace(path).bytes();
  return open(std::move(data));
}

ArrayArchive ArrayArchive::from_bytes(std::span<const std::byte> bytes, std::string name) {
  auto data = std::make_shared<Data>();
  data->name = std::move(name);
  data->owned =
      static_cast<std::byte*>(::operator new (bytes.size() + 1, std::align_val_t{kAlignment}));
  std::copy(bytes.begin(), bytes.end(), data->owned);
  data->bytes = {data->owned, bytes.size()};
  return open(std::move(data));
}

const std::string& ArrayArchive::name() const { return data_->name; }
std::string_view ArrayArchive::meta() const { return data_->meta; }
std::span<const ArrayArchive::Entry> ArrayArchive::arrays() const { return data_->arrays; }
std::shared_ptr<const void> ArrayArchive::keep_alive() const { return data_; }

bool ArrayArchive::has(std::string_view array) const {
  return std::any_of(data_->arrays.begin(), data_->arrays.end(),
                     [&](const Entry& e) { return e.name == std::string(array) + ".npy"; });
}

const ArrayArchive::Entry& ArrayArchive::find(std::string_view array, std::string_view dtype,
                                              std::size_t columns) const {
  for (const Entry& entry : data_->arrays) {
    if (entry.name != std::string(array) + ".npy") continue;
    const bool same_shape = columns == 0 ? entry.shape.size() == 1
                                         : entry.shape.size() == 2 && entry.shape[1] == columns;
    if (entry.dtype != dtype || !same_shape) {
      throw InputError(name(), fmt::format("{}: expected {} in rows of {}, found {} of shape ({})",
                                           entry.name, dtype, columns ? columns : 1, entry.dtype,
                                           fmt::join(entry.shape, ", ")));
    }
    return entry;
  }
  throw InputError(name(), fmt::format("expected an array {}.npy, found none", array));
}

void ArrayArchive::verify() const {
  const auto check = [&](std::string_view entry, std::uint32_t expected, std::uint32_t found) {
    if (expected == found) return;
    throw InputError(
        name(), fmt::format("{}: expected CRC {:08x}, found {:08x}: the file is damaged", entry,
                            expected, found));
  };
  check("meta.json", data_->meta_crc, crc32_of(std::as_bytes(std::span(data_->meta))));
  for (const Entry& entry : data_->arrays) {
    std::uint32_t crc = 0;
    for_each_stretch(entry.stored, [&](auto bytes) { crc = crc32_of(bytes, crc); });
    check(entry.name, entry.crc, crc);
  }
}

}  // namespace geom
