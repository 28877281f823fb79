#include "zip_writer.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "base/stretch.h"
#include "crc.h"
#include "geom/archive/bytes.h"
#include "zip_format.h"

namespace geom {
namespace {

constexpr std::uint16_t kDate = 0x0021;  // 1980-01-01
constexpr std::uint16_t kAlignExtra = 0xd935;
constexpr std::uint16_t kVersion = 20;       // of the format, in tenths
constexpr std::uint16_t kZip64Version = 45;  // the first with Zip64

// A value, or the mark that a Zip64 field holds it.
template <class T>
void append_capped(std::string& out, std::uint64_t value) {
  append_bytes(out, static_cast<T>(std::min<std::uint64_t>(value, std::numeric_limits<T>::max())));
}

std::string zip64_field(const std::vector<std::uint64_t>& values) {
  std::string field;
  append_bytes(field, kZip64Extra);
  append_bytes(field, static_cast<std::uint16_t>(8 * values.size()));
  for (const std::uint64_t value : values) append_bytes(field, value);
  return field;
}

// Fills up what comes before the data, so that these start aligned after `before` bytes.
std::string align_field(std::uint64_t before, std::size_t alignment) {
  if (alignment == 1) return "";
  const std::uint64_t start = before + 4;
  const auto pad = static_cast<std::uint16_t>((alignment - start % alignment) % alignment);
  std::string field;
  append_bytes(field, kAlignExtra);
  append_bytes(field, pad);
  return field.append(pad, '\0');
}

struct Stored {
  const std::string& name;
  const std::string& extra;
  std::uint32_t crc = 0;
  std::uint64_t size = 0;
};

// The fields that local and central headers share.
void append_common(std::string& out, const Stored& stored, bool zip64) {
  append_bytes(out, zip64 ? kZip64Version : kVersion);
  append_bytes(out, std::uint32_t{0});  // flags, method: stored
  append_bytes(out, std::uint16_t{0});  // time
  append_bytes(out, kDate);
  append_bytes(out, stored.crc);
  append_capped<std::uint32_t>(out, stored.size);
  append_capped<std::uint32_t>(out, stored.size);
  append_bytes(out, static_cast<std::uint16_t>(stored.name.size()));
  append_bytes(out, static_cast<std::uint16_t>(stored.extra.size()));
}

}  // namespace

void ZipWriter::add(const std::string& name, std::string_view head,
                    std::span<const std::span<const std::byte>> body) {
  std::uint64_t size = head.size();
  std::uint32_t crc = crc32_of(std::as_bytes(std::span(head)));
  for (const auto& piece : body) {
    size += piece.size();
    for_each_stretch(piece, [&](auto bytes) { crc = crc32_of(bytes, crc); });
  }
  const std::uint64_t offset = written_;
  const bool zip64 = size >= kFull32;
  std::string extra = zip64 ? zip64_field({size, size}) : "";
  extra += align_field(offset + kLocalSize + name.size() + extra.size(), alignment_);

  std::string local;
  append_bytes(local, kLocalMark);
  append_common(local, {name, extra, crc, size}, zip64);
  write(local + name + extra);
  write(head);
  for (const auto& piece : body) {
    for_each_stretch(piece, [&](auto bytes) {
      write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    });
  }
  add_to_directory(name, crc, size, offset);
}

void ZipWriter::finish() {
  const std::uint64_t start = written_;
  write(directory_);
  const std::uint64_t size = written_ - start;
  if (start >= kFull32 || size >= kFull32 || count_ >= kFull16) write_end64(start, size);
  std::string end;
  append_bytes(end, kEndMark);
  append_bytes(end, std::uint32_t{0});  // both disk numbers
  append_capped<std::uint16_t>(end, count_);
  append_capped<std::uint16_t>(end, count_);
  append_capped<std::uint32_t>(end, size);
  append_capped<std::uint32_t>(end, start);
  append_bytes(end, std::uint16_t{0});  // comment
  write(end);
}

void ZipWriter::write(std::string_view text) {
  out_.write(text.data(), static_cast<std::streamsize>(text.size()));
  written_ += text.size();
}

void ZipWriter::add_to_directory(const std::string& name, std::uint32_t crc, std::uint64_t size,
                                 std::uint64_t offset) {
  std::vector<std::uint64_t> full;
  if (size >= kFull32) full = {size, size};
  if (offset >= kFull32) full.push_back(offset);
  const std::string extra = full.empty() ? "" : zip64_field(full);
  append_bytes(directory_, kCentralMark);
  append_bytes(directory_, kZip64Version);  // of the writer
  append_common(directory_, {name, extra, crc, size}, !extra.empty());
  append_bytes(directory_, std::uint16_t{0});  // comment
  append_bytes(directory_, std::uint32_t{0});  // disk, internal attributes
  append_bytes(directory_, std::uint32_t{0});  // external attributes
  append_capped<std::uint32_t>(directory_, offset);
  directory_ += name + extra;
  ++count_;
}

// The Zip64 end record and the locator that points to it.
void ZipWriter::write_end64(std::uint64_t start, std::uint64_t size) {
  std::string end;
  append_bytes(end, kEnd64Mark);
  append_bytes(end, std::uint64_t{kEnd64Size - 12});
  append_bytes(end, kZip64Version);
  append_bytes(end, kZip64Version);
  append_bytes(end, std::uint64_t{0});  // both disk numbers
  append_bytes(end, count_);
  append_bytes(end, count_);
  append_bytes(end, size);
  append_bytes(end, start);
  append_bytes(end, kLocatorMark);
  append_bytes(end, std::uint32_t{0});
  append_bytes(end, start + size);
  append_bytes(end, std::uint32_t{1});
  write(end);
}

}  // namespace geom
