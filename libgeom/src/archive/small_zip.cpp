#include "geom/archive/small_zip.h"

#include <fmt/format.h>

#include <algorithm>

#include "crc.h"
#include "geom/base/error.h"
#include "geom/text/excerpt.h"
#include "inflate.h"
#include "zip_reader.h"
#include "zip_writer.h"

namespace geom {
namespace {

constexpr std::uint64_t kMostEntries = 1000;
constexpr std::uint64_t kAnyRatio = 1 << 20;  // bytes that may be packed as well as they can be
constexpr std::uint64_t kMostRatio = 100;     // text takes a tenth to a fiftieth

// A name that a program might take for a place outside of the folder it unpacks into.
bool leads_out(std::string_view name) {
  const std::string between = '/' + std::string(name) + '/';
  return name.empty() || name.front() == '/' || between.find("/../") != between.npos ||
         name.find_first_of("\\:") != name.npos || name.find('\0') != name.npos;
}

std::string lower(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return name;
}

void check_names(const std::vector<ZipEntry>& entries, const SmallZip& zip,
                 const std::string& source) {
  std::vector<std::string> names;
  for (const ZipEntry& entry : entries) {
    const bool wanted =
        std::find(zip.wanted.begin(), zip.wanted.end(), entry.name) != zip.wanted.end();
    for (const std::string_view ending : zip.alone) {
      if (wanted || !lower(entry.name).ends_with(ending)) continue;
      throw InputError(source, {.item = excerpt(entry.name),
                                .expected = fmt::format("no other file that ends in {} than {}",
                                                        ending, fmt::join(zip.wanted, " and "))});
    }
    if (leads_out(entry.name)) {
      throw InputError(source, {.item = excerpt(entry.name),
                                .expected = "the name of a file inside the archive"});
    }
    names.push_back(lower(entry.name));
  }
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice == names.end()) return;
  throw InputError(source, {.item = excerpt(*twice),
                            .expected = "each entry once",
                            .found = "it twice in other letters"});
}

std::string content_of(const ZipEntry& entry, const SmallZip& zip, const std::string& source) {
  const auto refuse = [&](Fault fault) {
    throw InputError(source, within(excerpt(entry.name), std::move(fault)));
  };
  if (entry.size > zip.most_content) {
    refuse({.expected = fmt::format("at most {} bytes", zip.most_content),
            .found = fmt::format("{} unpacked", entry.size)});
  }
  if (entry.size > kAnyRatio && entry.size / kMostRatio > entry.bytes.size()) {
    refuse({.expected = fmt::format("a file that is packed at most {} to 1", kMostRatio),
            .found = fmt::format("{} bytes in {}", entry.size, entry.bytes.size())});
  }
  std::string content;
  if (entry.deflated) {
    auto unpacked = inflated(entry.bytes, entry.size);
    if (!unpacked) {
      refuse({.says = fmt::format(
                  "the file was damaged: it does not unpack to the {} bytes that it says",
                  entry.size)});
    }
    content = std::move(*unpacked);
  } else {
    content.assign(reinterpret_cast<const char*>(entry.bytes.data()), entry.bytes.size());
  }
  if (crc32_of(std::as_bytes(std::span(content))) != entry.crc) {
    refuse({.says = "the file was damaged: its checksum differs"});
  }
  return content;
}

}  // namespace

std::vector<SmallFile> files_of_zip(std::string_view archive, const std::string& source,
                                    const SmallZip& zip) {
  const auto entries =
      read_zip(std::as_bytes(std::span(archive)), source, {zip.what, kMostEntries, true});
  check_names(entries, zip, source);
  std::vector<SmallFile> files;
  for (const std::string_view wanted : zip.wanted) {
    for (const ZipEntry& entry : entries) {
      if (entry.name != wanted) continue;
      files.push_back({entry.name, content_of(entry, zip, source)});
    }
  }
  return files;
}

void write_small_zip(std::ostream& out, std::span<const SmallFile> files) {
  ZipWriter zip(out, 1);
  for (const SmallFile& file : files) zip.add(file.name, file.content, {});
  zip.finish();
}

}  // namespace geom
