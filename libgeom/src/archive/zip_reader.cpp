#include "zip_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string_view>

#include "geom/base/error.h"
#include "geom/text/excerpt.h"
#include "zip_format.h"

namespace geom {
namespace {

constexpr std::uint16_t kEncrypted = 1;  // flags of an entry
constexpr std::uint16_t kDescribed = 8;
constexpr std::uint16_t kStored = 0;  // methods
constexpr std::uint16_t kDeflated = 8;

// Little-endian numbers at checked places; nothing beyond the end.
class Bytes {
 public:
  Bytes(std::span<const std::byte> bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  [[noreturn]] void refuse(Fault fault) const { throw InputError(name_, std::move(fault)); }

  std::span<const std::byte> part(std::uint64_t at, std::uint64_t size, const char* what) const {
    if (at > bytes_.size() || size > bytes_.size() - at) {
      refuse({.says = fmt::format(
                  "the file was cut or is damaged: {} would end at byte {}, and there are {}", what,
                  at + size, bytes_.size())});
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

// What is no ZIP at all is told by its beginning; its end says nothing to anyone.
void require_zip(const Bytes& in, const char* what) {
  constexpr std::size_t kShown = 16;
  const std::string head = in.text(0, std::min(in.size(), kShown), "the beginning");
  if (!head.starts_with("PK")) {
    in.refuse({.expected = fmt::format("{} (a ZIP archive)", what),
               .found = head.empty()
                            ? "an empty file"
                            : fmt::format("a file that begins with \"{}\"", excerpt(head))});
  }
  if (in.size() < kEndSize) {
    in.refuse({.expected = "a whole ZIP archive",
               .found = fmt::format("{} bytes", in.size()),
               .advice = "the file was cut"});
  }
}

Directory find_directory(const Bytes& in, const char* what) {
  require_zip(in, what);
  const std::uint64_t end = in.size() - kEndSize;
  if (in.get<std::uint32_t>(end, "the end record") != kEndMark) {
    in.refuse({.expected = "a whole ZIP archive",
               .found = "one without its end",
               .advice = "the file was cut, get or make it again"});
  }
  Directory d{in.get<std::uint32_t>(end + 16, "end"), in.get<std::uint32_t>(end + 12, "end"),
              in.get<std::uint16_t>(end + 10, "end")};
  std::uint64_t limit = end;
  if (d.start == kFull32 || d.size == kFull32 || d.count == kFull16) {
    if (end < kLocatorSize ||
        in.get<std::uint32_t>(end - kLocatorSize, "locator") != kLocatorMark) {
      in.refuse({.expected = "a Zip64 locator before the end record", .found = "none"});
    }
    const auto at = in.get<std::uint64_t>(end - kLocatorSize + 8, "locator");
    if (in.get<std::uint32_t>(at, "the Zip64 end record") != kEnd64Mark) {
      in.refuse({.expected = "a Zip64 end record where the locator points", .found = "none"});
    }
    d = {in.get<std::uint64_t>(at + 48, "Zip64 end"), in.get<std::uint64_t>(at + 40, "Zip64 end"),
         in.get<std::uint64_t>(at + 32, "Zip64 end")};
    limit = at;
  }
  if (d.size > limit || d.start > limit - d.size || d.start + d.size != limit) {
    in.refuse({.says = "the ZIP directory must end where the end record begins, and does not"});
  }
  return d;
}

// Sizes and place of an entry, as the directory has them.
struct Extent {
  std::uint64_t size = 0;
  std::uint64_t stored = 0;  // the size when compressed
  std::uint64_t header = 0;
};

// The Zip64 values stand in the extra field in the order of Extent, each only where its own field
// is full.
Extent with_zip64(const Bytes& in, std::uint64_t at, std::uint64_t size, Extent extent) {
  for (std::uint64_t i = 0; i + 4 <= size;) {
    const auto id = in.get<std::uint16_t>(at + i, "extra field");
    const auto n = in.get<std::uint16_t>(at + i + 2, "extra field");
    if (n > size - i - 4)
      in.refuse({.says = "an extra field of the ZIP directory is longer than its place"});
    if (id == kZip64Extra) {
      std::uint64_t next = at + i + 4;
      const std::uint64_t end = next + n;
      for (std::uint64_t* value : {&extent.size, &extent.stored, &extent.header}) {
        if (*value != kFull32) continue;
        if (end - next < 8) in.refuse({.says = "a Zip64 extra field is too short"});
        *value = in.get<std::uint64_t>(next, "Zip64 extra field");
        next += 8;
      }
      return extent;
    }
    i += 4u + n;
  }
  return extent;
}

// Refuses a local header of another method or, where it says them, other sizes than the directory:
// readers that go from entry to entry would find something else.
void require_alike(const Bytes& in, const ZipEntry& entry, std::uint64_t stored) {
  const auto method = in.get<std::uint16_t>(entry.header + 8, "a local header");
  const auto local_stored = in.get<std::uint32_t>(entry.header + 18, "a local header");
  const auto local_size = in.get<std::uint32_t>(entry.header + 22, "a local header");
  const auto differs = [&](std::uint32_t local, std::uint64_t size) {
    return local != size && local != kFull32 && !(entry.described && local == 0);
  };
  if (method != (entry.deflated ? kDeflated : kStored) || differs(local_stored, stored) ||
      differs(local_size, entry.size)) {
    in.refuse({.item = excerpt(entry.name), .says = "the local header and the directory differ"});
  }
}

// The bytes that the local header of `entry` says are its own.
std::span<const std::byte> find_data(const Bytes& in, const Directory& d, const ZipEntry& entry,
                                     std::uint64_t size) {
  if (in.get<std::uint32_t>(entry.header, "a local header") != kLocalMark) {
    in.refuse({.item = excerpt(entry.name),
               .expected = "a local header where the directory points",
               .found = "none"});
  }
  const auto local_name = in.get<std::uint16_t>(entry.header + 26, "a local header");
  const auto local_extra = in.get<std::uint16_t>(entry.header + 28, "a local header");
  if (in.text(entry.header + kLocalSize, local_name, "a local name") != entry.name) {
    in.refuse({.item = excerpt(entry.name), .says = "the local header has another name"});
  }
  require_alike(in, entry, size);
  const std::uint64_t start = entry.header + kLocalSize + local_name + local_extra;
  const auto data = in.part(start, size, excerpt(entry.name).c_str());
  if (start + size > d.start) {
    in.refuse({.item = excerpt(entry.name), .says = "the entry runs into the directory"});
  }
  return data;
}

// The entry of the directory at `at`, which then stands at the next.
ZipEntry read_entry(const Bytes& in, const Directory& d, const ZipRules& rules, std::uint64_t& at) {
  if (in.get<std::uint32_t>(at, "the directory") != kCentralMark) {
    in.refuse({.expected = "an entry of the ZIP directory", .found = "something else"});
  }
  const auto flags = in.get<std::uint16_t>(at + 8, "directory");
  const auto method = in.get<std::uint16_t>(at + 10, "directory");
  ZipEntry entry;
  entry.crc = in.get<std::uint32_t>(at + 16, "directory");
  const auto name = in.get<std::uint16_t>(at + 28, "directory");
  const auto extra = in.get<std::uint16_t>(at + 30, "directory");
  const auto comment = in.get<std::uint16_t>(at + 32, "directory");
  const Extent fields{in.get<std::uint32_t>(at + 24, "directory"),
                      in.get<std::uint32_t>(at + 20, "directory"),
                      in.get<std::uint32_t>(at + 42, "directory")};
  entry.name = in.text(at + kCentralSize, name, "a name in the directory");
  in.part(at + kCentralSize + name, extra, "an extra field");
  const Extent extent = with_zip64(in, at + kCentralSize + name, extra, fields);
  entry.header = extent.header;
  at += kCentralSize + name + extra + comment;
  entry.size = extent.size;
  entry.deflated = rules.foreign && method == kDeflated;
  entry.described = (flags & kDescribed) != 0;
  if (flags & kEncrypted) {
    in.refuse(
        {.item = excerpt(entry.name), .expected = "a plain entry", .found = "an encrypted one"});
  }
  if (!entry.deflated && (method != kStored || extent.stored != extent.size)) {
    in.refuse({.item = excerpt(entry.name),
               .expected = fmt::format("an entry stored {}",
                                       rules.foreign ? "or deflated" : "without compression"),
               .found = fmt::format("method {}", method)});
  }
  entry.bytes = find_data(in, d, entry, extent.stored);
  return entry;
}

// Refuses names that come twice.
void check_names(const Bytes& in, const std::vector<ZipEntry>& entries) {
  std::vector<std::string_view> names;
  for (const ZipEntry& entry : entries) names.push_back(entry.name);
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice == names.end()) return;
  in.refuse({.item = excerpt(*twice), .expected = "each entry once", .found = "it twice"});
}

std::uint64_t end_of(std::span<const std::byte> archive, const ZipEntry& entry) {
  return static_cast<std::uint64_t>(entry.bytes.data() - archive.data()) + entry.bytes.size();
}

// Refuses overlaps of entries, which stand in the order of their places.
void check_apart(const Bytes& in, std::span<const std::byte> archive,
                 const std::vector<ZipEntry>& entries) {
  std::uint64_t end = 0;
  for (const ZipEntry& entry : entries) {
    if (end > entry.header)
      in.refuse({.item = excerpt(entry.name), .says = "overlaps the entry before it"});
    end = end_of(archive, entry);
  }
}

// Refuses bytes that belong to no entry: readers that go from entry to entry would find others
// there.
void check_whole(const Bytes& in, std::span<const std::byte> archive, const Directory& d,
                 const std::vector<ZipEntry>& entries) {
  constexpr std::uint64_t kLongestDescriptor = 24;
  std::uint64_t least = 0;
  std::uint64_t most = 0;
  const auto require = [&](std::uint64_t place) {
    if (place < least || place > most) {
      in.refuse({.expected = "entries one after the other", .found = "bytes that belong to none"});
    }
  };
  for (const ZipEntry& entry : entries) {
    require(entry.header);
    least = end_of(archive, entry);
    most = least + (entry.described ? kLongestDescriptor : 0);
  }
  require(d.start);
}

}  // namespace

std::vector<ZipEntry> read_zip(std::span<const std::byte> archive, const std::string& name,
                               const ZipRules& rules) {
  const Bytes in(archive, name);
  const Directory d = find_directory(in, rules.what);
  if (d.count > rules.most_entries) {
    in.refuse({.expected = fmt::format("a ZIP of at most {} entries", rules.most_entries),
               .found = fmt::to_string(d.count)});
  }
  std::vector<ZipEntry> entries;
  std::uint64_t at = d.start;
  for (std::uint64_t i = 0; i < d.count; ++i) entries.push_back(read_entry(in, d, rules, at));
  if (at != d.start + d.size)
    in.refuse({.says = "the ZIP directory has another size than it says"});
  std::sort(entries.begin(), entries.end(),
            [](const ZipEntry& a, const ZipEntry& b) { return a.header < b.header; });
  check_names(in, entries);
  check_apart(in, archive, entries);
  if (rules.foreign) check_whole(in, archive, d, entries);
  return entries;
}

}  // namespace geom
