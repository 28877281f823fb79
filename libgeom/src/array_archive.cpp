#include "geom/io/array_archive.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <limits>
#include <new>
#include <optional>
#include <ostream>
#include <system_error>

#include "geom/error.h"

// The format is PKWARE's APPNOTE 6.3; the arrays are NumPy's NPY 1.0.

namespace geom {
namespace {

constexpr std::uint32_t kLocalMark = 0x04034b50;
constexpr std::uint32_t kCentralMark = 0x02014b50;
constexpr std::uint32_t kEndMark = 0x06054b50;
constexpr std::uint32_t kEnd64Mark = 0x06064b50;
constexpr std::uint32_t kLocatorMark = 0x07064b50;
constexpr std::uint32_t kFull32 = 0xffffffff;
constexpr std::uint16_t kFull16 = 0xffff;
constexpr std::uint16_t kDate = 0x0021;  // 1980-01-01
constexpr std::uint16_t kZip64Extra = 1;
constexpr std::uint16_t kAlignExtra = 0xd935;
constexpr std::size_t kAlignment = 64;
constexpr std::size_t kLocalSize = 30;
constexpr std::size_t kCentralSize = 46;
constexpr std::size_t kEndSize = 22;
constexpr std::size_t kLocatorSize = 20;
constexpr std::size_t kEnd64Size = 56;
constexpr std::string_view kNpyMark("\x93NUMPY\x01\x00", 8);

// --- writing --------------------------------------------------------------------------------

template <class T>
void put(std::string& out, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i) out += static_cast<char>(value >> (8 * i));
}

std::string npy_header(const NamedArray& array) {
  std::string shape;
  for (const std::size_t n : array.shape) shape += fmt::format("{}, ", n);
  if (array.shape.size() > 1) shape.resize(shape.size() - 2);
  if (array.shape.size() == 1) shape.pop_back();
  std::string dict =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", array.dtype, shape);
  const std::size_t used = kNpyMark.size() + 2 + dict.size() + 1;
  dict.append((kAlignment - used % kAlignment) % kAlignment, ' ');
  dict += '\n';
  std::string header(kNpyMark);
  put(header, static_cast<std::uint16_t>(dict.size()));
  return header + dict;
}

std::uint32_t crc_of(std::uint32_t crc, std::span<const std::byte> bytes) {
  if (bytes.empty()) return crc;  // crc32_z() starts anew when it is given no buffer
  return static_cast<std::uint32_t>(
      crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

class ZipWriter {
 public:
  explicit ZipWriter(std::ostream& out) : out_(out) {}

  void add(const std::string& name, std::string_view head, std::span<const std::byte> body) {
    const std::uint64_t size = head.size() + body.size();
    const std::uint32_t crc = crc_of(crc_of(0, bytes_of(head)), body);
    const std::uint64_t offset = written_;
    const bool big = size >= kFull32;
    std::string extra;
    if (big) {
      put(extra, kZip64Extra);
      put(extra, std::uint16_t{16});
      put(extra, size);
      put(extra, size);
    }
    const std::uint64_t start = offset + kLocalSize + name.size() + extra.size() + 4;
    const auto pad = static_cast<std::uint16_t>((kAlignment - start % kAlignment) % kAlignment);
    put(extra, kAlignExtra);
    put(extra, pad);
    extra.append(pad, '\0');

    std::string local;
    put(local, kLocalMark);
    put_common(local, big, crc, size, name, extra.size());
    write(local + name + extra);
    write(head);
    write({reinterpret_cast<const char*>(body.data()), body.size()});
    add_to_directory(name, crc, size, offset);
  }

  void finish() {
    const std::uint64_t start = written_;
    write(directory_);
    const std::uint64_t size = written_ - start;
    std::string end;
    if (start >= kFull32 || size >= kFull32 || count_ >= kFull16) {
      put(end, kEnd64Mark);
      put(end, std::uint64_t{kEnd64Size - 12});
      put(end, std::uint16_t{45});
      put(end, std::uint16_t{45});
      put(end, std::uint64_t{0});  // both disk numbers
      put(end, count_);
      put(end, count_);
      put(end, size);
      put(end, start);
      put(end, kLocatorMark);
      put(end, std::uint32_t{0});
      put(end, start + size);
      put(end, std::uint32_t{1});
    }
    put(end, kEndMark);
    put(end, std::uint32_t{0});  // both disk numbers
    put(end, static_cast<std::uint16_t>(std::min<std::uint64_t>(count_, kFull16)));
    put(end, static_cast<std::uint16_t>(std::min<std::uint64_t>(count_, kFull16)));
    put(end, static_cast<std::uint32_t>(std::min<std::uint64_t>(size, kFull32)));
    put(end, static_cast<std::uint32_t>(std::min<std::uint64_t>(start, kFull32)));
    put(end, std::uint16_t{0});
    write(end);
  }

 private:
  void write(std::string_view text) {
    out_.write(text.data(), static_cast<std::streamsize>(text.size()));
    written_ += text.size();
  }

  // The fields that local and central headers share.
  static void put_common(std::string& out, bool big, std::uint32_t crc, std::uint64_t size,
                         const std::string& name, std::size_t extra) {
    put(out, std::uint16_t{big ? std::uint16_t{45} : std::uint16_t{20}});
    put(out, std::uint32_t{0});  // flags, method: stored
    put(out, std::uint16_t{0});
    put(out, kDate);
    put(out, crc);
    put(out, static_cast<std::uint32_t>(std::min<std::uint64_t>(size, kFull32)));
    put(out, static_cast<std::uint32_t>(std::min<std::uint64_t>(size, kFull32)));
    put(out, static_cast<std::uint16_t>(name.size()));
    put(out, static_cast<std::uint16_t>(extra));
  }

  void add_to_directory(const std::string& name, std::uint32_t crc, std::uint64_t size,
                        std::uint64_t offset) {
    std::string values;
    if (size >= kFull32) {
      put(values, size);
      put(values, size);
    }
    if (offset >= kFull32) put(values, offset);
    std::string extra;
    if (!values.empty()) {
      put(extra, kZip64Extra);
      put(extra, static_cast<std::uint16_t>(values.size()));
      extra += values;
    }
    put(directory_, kCentralMark);
    put(directory_, std::uint16_t{45});
    put_common(directory_, !extra.empty(), crc, size, name, extra.size());
    put(directory_, std::uint16_t{0});  // comment
    put(directory_, std::uint32_t{0});  // disk, internal attributes
    put(directory_, std::uint32_t{0});  // external attributes
    put(directory_, static_cast<std::uint32_t>(std::min<std::uint64_t>(offset, kFull32)));
    directory_ += name + extra;
    ++count_;
  }

  std::ostream& out_;
  std::string directory_;
  std::uint64_t written_ = 0;
  std::uint64_t count_ = 0;
};

// --- reading --------------------------------------------------------------------------------

// Little-endian numbers at checked places; nothing beyond the end.
class Bytes {
 public:
  Bytes(std::span<const std::byte> bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  [[noreturn]] void refuse(std::string_view message) const { throw InputError(name_, message); }

  std::span<const std::byte> part(std::uint64_t at, std::uint64_t size, const char* what) const {
    if (at > bytes_.size() || size > bytes_.size() - at) {
      refuse(fmt::format("truncated or damaged: {} would end at byte {}, and there are {}", what,
                         at + size, bytes_.size()));
    }
    return bytes_.subspan(at, size);
  }

  template <class T>
  T get(std::uint64_t at, const char* what) const {
    T value = 0;
    std::memcpy(&value, part(at, sizeof(T), what).data(), sizeof(T));
    return value;
  }

  std::string text(std::uint64_t at, std::uint64_t size, const char* what) const {
    const auto bytes = part(at, size, what);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }

  std::size_t size() const { return bytes_.size(); }

 private:
  std::span<const std::byte> bytes_;
  const std::string& name_;
};

struct Directory {
  std::uint64_t start = 0;
  std::uint64_t size = 0;
  std::uint64_t count = 0;
};

Directory find_directory(const Bytes& in) {
  if (in.size() < kEndSize)
    in.refuse(fmt::format("expected a ZIP archive, found {} bytes", in.size()));
  const std::uint64_t end = in.size() - kEndSize;
  if (in.get<std::uint32_t>(end, "the end record") != kEndMark) {
    in.refuse("expected a ZIP archive that ends in its end record, found none (truncated?)");
  }
  Directory d{in.get<std::uint32_t>(end + 16, "end"), in.get<std::uint32_t>(end + 12, "end"),
              in.get<std::uint16_t>(end + 10, "end")};
  std::uint64_t limit = end;
  if (d.start == kFull32 || d.size == kFull32 || d.count == kFull16) {
    if (end < kLocatorSize ||
        in.get<std::uint32_t>(end - kLocatorSize, "locator") != kLocatorMark) {
      in.refuse("expected a Zip64 locator before the end record, found none");
    }
    const auto at = in.get<std::uint64_t>(end - kLocatorSize + 8, "locator");
    if (in.get<std::uint32_t>(at, "the Zip64 end record") != kEnd64Mark) {
      in.refuse("expected a Zip64 end record where the locator points, found none");
    }
    d = {in.get<std::uint64_t>(at + 48, "Zip64 end"), in.get<std::uint64_t>(at + 40, "Zip64 end"),
         in.get<std::uint64_t>(at + 32, "Zip64 end")};
    limit = at;
  }
  if (d.size > limit || d.start > limit - d.size || d.start + d.size != limit) {
    in.refuse("the ZIP directory must end where the end record begins, and does not");
  }
  return d;
}

struct ZipEntry {
  std::string name;
  std::uint64_t header = 0;  // of its local header
  std::uint64_t start = 0;   // of its data
  std::uint64_t size = 0;
  std::uint32_t crc = 0;
};

// The Zip64 values stand in the extra field in this order, each only where its field is full.
void read_zip64(const Bytes& in, std::uint64_t at, std::uint64_t size, std::uint64_t& stored,
                std::uint64_t& length, std::uint64_t& offset) {
  for (std::uint64_t i = 0; i + 4 <= size;) {
    const auto id = in.get<std::uint16_t>(at + i, "extra field");
    const auto n = in.get<std::uint16_t>(at + i + 2, "extra field");
    if (n > size - i - 4) in.refuse("an extra field of the ZIP directory is longer than its place");
    if (id == kZip64Extra) {
      std::uint64_t next = at + i + 4;
      const std::uint64_t end = next + n;
      for (std::uint64_t* value : {&length, &stored, &offset}) {
        if (*value != kFull32) continue;
        if (end - next < 8) in.refuse("a Zip64 extra field is too short");
        *value = in.get<std::uint64_t>(next, "Zip64 extra field");
        next += 8;
      }
      return;
    }
    i += 4u + n;
  }
}

ZipEntry read_entry(const Bytes& in, const Directory& d, std::uint64_t& at) {
  if (in.get<std::uint32_t>(at, "the directory") != kCentralMark) {
    in.refuse("expected an entry of the ZIP directory, found something else");
  }
  const auto flags = in.get<std::uint16_t>(at + 8, "directory");
  const auto method = in.get<std::uint16_t>(at + 10, "directory");
  ZipEntry entry;
  entry.crc = in.get<std::uint32_t>(at + 16, "directory");
  std::uint64_t stored = in.get<std::uint32_t>(at + 20, "directory");
  entry.size = in.get<std::uint32_t>(at + 24, "directory");
  const auto name = in.get<std::uint16_t>(at + 28, "directory");
  const auto extra = in.get<std::uint16_t>(at + 30, "directory");
  const auto comment = in.get<std::uint16_t>(at + 32, "directory");
  entry.header = in.get<std::uint32_t>(at + 42, "directory");
  entry.name = in.text(at + kCentralSize, name, "a name in the directory");
  in.part(at + kCentralSize + name, extra, "an extra field");
  read_zip64(in, at + kCentralSize + name, extra, stored, entry.size, entry.header);
  at += kCentralSize + name + extra + comment;
  if (method != 0 || stored != entry.size) {
    in.refuse(fmt::format("{}: expected an entry stored without compression, found method {}",
                          entry.name, method));
  }
  if (flags & 1)
    in.refuse(fmt::format("{}: expected a plain entry, found an encrypted one", entry.name));
  if (in.get<std::uint32_t>(entry.header, "a local header") != kLocalMark) {
    in.refuse(fmt::format("{}: expected a local header where the directory points, found none",
                          entry.name));
  }
  const auto local_name = in.get<std::uint16_t>(entry.header + 26, "a local header");
  const auto local_extra = in.get<std::uint16_t>(entry.header + 28, "a local header");
  if (in.text(entry.header + kLocalSize, local_name, "a local name") != entry.name) {
    in.refuse(fmt::format("{}: the local header has another name", entry.name));
  }
  entry.start = entry.header + kLocalSize + local_name + local_extra;
  in.part(entry.start, entry.size, entry.name.c_str());
  if (entry.start + entry.size > d.start) {
    in.refuse(fmt::format("{}: the entry runs into the directory", entry.name));
  }
  return entry;
}

std::vector<ZipEntry> read_entries(const Bytes& in) {
  const Directory d = find_directory(in);
  std::vector<ZipEntry> entries;
  std::uint64_t at = d.start;
  for (std::uint64_t i = 0; i < d.count; ++i) entries.push_back(read_entry(in, d, at));
  if (at != d.start + d.size) in.refuse("the ZIP directory has another size than it says");
  std::sort(entries.begin(), entries.end(),
            [](const ZipEntry& a, const ZipEntry& b) { return a.header < b.header; });
  for (std::size_t i = 0; i < entries.size(); ++i) {
    for (std::size_t k = i + 1; k < entries.size(); ++k) {
      if (entries[k].name == entries[i].name) {
        in.refuse(fmt::format("{}: expected each entry once, found it twice", entries[i].name));
      }
    }
    if (i && entries[i - 1].start + entries[i - 1].size > entries[i].header) {
      in.refuse(fmt::format("{}: overlaps the entry before it", entries[i].name));
    }
  }
  return entries;
}

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

ArrayArchive::Entry parse_array(const Bytes& in, const ZipEntry& zip) {
  ArrayArchive::Entry entry;
  entry.name = zip.name;
  entry.crc = zip.crc;
  entry.stored = in.part(zip.start, zip.size, zip.name.c_str());
  const auto refuse = [&](std::string_view message) {
    in.refuse(fmt::format("{}: {}", zip.name, message));
  };
  if (zip.size < 10 || in.text(zip.start, 8, "array") != kNpyMark) {
    refuse("expected a NumPy array of format 1.0, found something else");
  }
  const auto length = in.get<std::uint16_t>(zip.start + 8, "array");
  if (length + 10u > zip.size) refuse("the array's header is longer than the entry");
  const std::string dict = in.text(zip.start + 10, length, "array");
  entry.dtype = between(dict, "'descr': '", '\'');
  const auto shape = parse_shape(between(dict, "'shape': (", ')'));
  const std::size_t item = item_size(entry.dtype);
  if (item == 0 || !shape || dict.find("'fortran_order': False") == std::string::npos) {
    refuse(fmt::format("expected a little-endian array in C order, found {}", dict));
  }
  entry.shape = *shape;
  entry.bytes = entry.stored.subspan(10u + length);
  if (!fits(entry.shape, item, entry.bytes.size())) {
    refuse(fmt::format("the shape ({}) does not fit {} bytes of {}", fmt::join(entry.shape, ", "),
                       entry.bytes.size(), entry.dtype));
  }
  if (reinterpret_cast<std::uintptr_t>(entry.bytes.data()) % item != 0) {
    refuse("the data must be aligned in the file, and is not");
  }
  return entry;
}

}  // namespace

void write_array_archive(std::ostream& out, std::string_view meta_json,
                         std::span<const NamedArray> arrays) {
  ZipWriter zip(out);
  zip.add("meta.json", meta_json, {});
  for (const NamedArray& array : arrays)
    zip.add(array.name + ".npy", npy_header(array), array.bytes);
  zip.finish();
}

struct ArrayArchive::Data {
  std::string name;
  std::span<const std::byte> bytes;
  std::vector<Entry> arrays;
  std::string_view meta;
  std::uint32_t meta_crc = 0;
  void* mapped = nullptr;
  std::byte* owned = nullptr;

  Data() = default;
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;
  ~Data() {
    if (mapped) munmap(mapped, bytes.size());
    if (owned) ::operator delete (owned, std::align_val_t{kAlignment});
  }
};

ArrayArchive::ArrayArchive(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

ArrayArchive ArrayArchive::open(std::shared_ptr<Data> data) {
  const Bytes in(data->bytes, data->name);
  bool has_meta = false;
  for (const ZipEntry& zip : read_entries(in)) {
    if (zip.name == "meta.json") {
      const auto bytes = in.part(zip.start, zip.size, "meta.json");
      data->meta = {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
      data->meta_crc = zip.crc;
      has_meta = true;
    } else {
      data->arrays.push_back(parse_array(in, zip));
    }
  }
  if (!has_meta) in.refuse("expected an entry meta.json, found none");
  return ArrayArchive(std::move(data));
}

ArrayArchive ArrayArchive::map(const std::string& path) {
  auto data = std::make_shared<Data>();
  data->name = path;
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat info {};
  if (file < 0 || fstat(file, &info) != 0) {
    const int error = errno;
    if (file >= 0) close(file);
    throw std::system_error(error, std::generic_category(), "cannot read " + path);
  }
  if (!S_ISREG(info.st_mode) || info.st_size == 0) {
    close(file);
    throw InputError(path, "expected a ZIP archive, found an empty or special file");
  }
  const auto size = static_cast<std::size_t>(info.st_size);
  void* const at = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
  const int error = errno;
  close(file);
  if (at == MAP_FAILED)
    throw std::system_error(error, std::generic_category(), "cannot map " + path);
  data->mapped = at;
  data->bytes = {static_cast<const std::byte*>(at), size};
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
  check("meta.json", data_->meta_crc, crc_of(0, bytes_of(data_->meta)));
  for (const Entry& entry : data_->arrays) check(entry.name, entry.crc, crc_of(0, entry.stored));
}

}  // namespace geom
