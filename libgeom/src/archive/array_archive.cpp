#include "geom/archive/array_archive.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <optional>
#include <ostream>

#include "crc.h"
#include "geom/base/error.h"
#include "geom/base/mapped_file.h"
#include "geom/base/parallel.h"
#include "geom/base/sha256.h"
#include "npy.h"
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
  if (!has_meta) throw InputError(data->name, {.expected = "an entry meta.json", .found = "none"});
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
      throw InputError(
          name(),
          {.item = std::string(entry.name),
           .expected = fmt::format("{} in rows of {}", dtype, columns ? columns : 1),
           .found = fmt::format("{} of shape ({})", entry.dtype, fmt::join(entry.shape, ", "))});
    }
    return entry;
  }
  throw InputError(name(), {.expected = fmt::format("an array {}.npy", array), .found = "none"});
}

std::string ArrayArchive::directory_hash() const {
  std::string text(meta());
  for (const Entry& entry : arrays()) {
    text += fmt::format("{} {} {:08x}", entry.name, entry.dtype, entry.crc);
    for (const std::size_t n : entry.shape) text += fmt::format(" {}", n);
    text += '\n';
  }
  Sha256 sum;
  sum.update(std::as_bytes(std::span(text)));
  return "sha256:" + sum.hex();
}

std::optional<FileState> ArrayArchive::file() const {
  if (!data_->mapped) return std::nullopt;
  return data_->mapped->state();
}

namespace {

// Checksums of stretches of entries, on all threads; each entry's are one after the other.
class Checksums {
 public:
  void add(std::string_view name, std::uint32_t expected, std::span<const std::byte> bytes) {
    entries_.push_back({name, expected, stretches_.size()});
    for (std::size_t at = 0; at < bytes.size(); at += kStretch) {
      stretches_.push_back({bytes.subspan(at, std::min(kStretch, bytes.size() - at)), 0});
    }
  }

  void verify(const std::string& archive, const Execution& run) {
    parallel_for(stretches_.size(), {run.threads, {}}, [&](std::size_t i) {
      read_ahead(stretches_[i].bytes);
      stretches_[i].crc = crc32_of(stretches_[i].bytes);
      trim_mapped_files();
    });
    for (std::size_t e = 0; e < entries_.size(); ++e) {
      const std::size_t end = e + 1 < entries_.size() ? entries_[e + 1].first : stretches_.size();
      std::uint32_t found = 0;
      for (std::size_t i = entries_[e].first; i < end; ++i) {
        found = crc32_joined(found, stretches_[i].crc, stretches_[i].bytes.size());
      }
      if (found == entries_[e].expected) continue;
      throw InputError(archive, {.item = std::string(entries_[e].name),
                                 .expected = fmt::format("CRC {:08x}", entries_[e].expected),
                                 .found = fmt::format("{:08x}", found),
                                 .advice = "the file is damaged, get or make it again"});
    }
  }

 private:
  static constexpr std::size_t kStretch = std::size_t{1} << 22;
  struct Stretch {
    std::span<const std::byte> bytes;
    std::uint32_t crc;
  };
  struct Summed {
    std::string_view name;
    std::uint32_t expected;
    std::size_t first;  // of its stretches
  };
  std::vector<Stretch> stretches_;
  std::vector<Summed> entries_;
};

}  // namespace

void ArrayArchive::verify(const Execution& run) const {
  Checksums sums;
  sums.add("meta.json", data_->meta_crc, std::as_bytes(std::span(data_->meta)));
  for (const Entry& entry : data_->arrays) sums.add(entry.name, entry.crc, entry.stored);
  sums.verify(name(), run);
}

}  // namespace geom
