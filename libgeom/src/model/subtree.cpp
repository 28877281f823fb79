#include "subtree.h"

#include <fmt/format.h>

#include <bit>
#include <map>

#include "buffer_view.h"
#include "geom/base/error.h"
#include "geom/text/parse_json.h"
#include "json_members.h"
#include "little_endian.h"
#include "model_path.h"

namespace geom {
namespace {

constexpr std::size_t kHead = 24;

}  // namespace

// The JSON of a subtree, and the bytes that its views are of.
class SubtreeBytes {
 public:
  SubtreeBytes(const std::string& path, const ModelFiles& files)
      : path_(path), files_(files), file_(files(path)) {
    std::string_view text = file_;
    if (text.starts_with("subt")) text = read_container();
    json_ = parse_json(text, path);
  }

  JsonMembers root() const { return {json_, path_, "subtree"}; }

  std::string_view view(std::uint64_t i) {
    const JsonMembers view = root().at("bufferViews", i, "bufferView");
    return bytes_of(view, buffer(view.whole("buffer")));
  }

 private:
  // Gives the text, and keeps the binary part.
  std::string_view read_container() {
    const std::string_view all = file_;
    const auto refuse = [&](Fault fault) { throw InputError(path_, std::move(fault)); };
    if (all.size() < kHead)
      refuse({.says = fmt::format("a subtree of {} bytes is cut short", all.size())});
    if (const auto version = little_endian<std::uint32_t>(all, 4); version != 1) {
      refuse({.expected = "a subtree of version 1", .found = fmt::to_string(version)});
    }
    const auto text = little_endian<std::uint64_t>(all, 8);
    const auto binary = little_endian<std::uint64_t>(all, 16);
    const std::size_t rest = all.size() - kHead;
    if (text > rest || binary != rest - text) {
      refuse({.expected = fmt::format("a subtree of {} and {} bytes after its head, as it says",
                                      text, binary),
              .found = fmt::to_string(rest)});
    }
    binary_ = all.substr(kHead + text);
    has_binary_ = true;
    return all.substr(kHead, text);
  }

  std::string_view buffer(std::uint64_t i) {
    const JsonMembers buffer = root().at("buffers", i, "buffer");
    std::string_view bytes = binary_;
    if (const auto uri = buffer.find_text("uri")) {
      const auto [at, added] = loaded_.try_emplace(i);
      if (added) at->second = files_(path_of_uri(*uri, path_, path_));
      bytes = at->second;
    } else if (i != 0 || !has_binary_) {
      buffer.refuse({.says = "it has no \"uri\", and no bytes in the file"});
    }
    const std::uint64_t length = buffer.whole("byteLength");
    if (bytes.size() < length) {
      buffer.refuse({.expected = fmt::format("{} bytes, as it says", length),
                     .found = fmt::to_string(bytes.size())});
    }
    return bytes.substr(0, length);
  }

  std::string path_;
  const ModelFiles& files_;
  std::string file_;
  std::string_view binary_;
  bool has_binary_ = false;
  nlohmann::json json_;
  std::map<std::uint64_t, std::string> loaded_;
};

Subtree::Subtree(const std::string& path, const SubtreeShape& shape, const ModelFiles& files)
    : shape_(shape) {
  std::uint64_t tiles = 0;
  std::uint64_t of_level = 1;
  for (std::uint64_t level = 0; level <= shape.levels; ++level) {
    first_.push_back(tiles);
    if (level == shape.levels) break;
    tiles += of_level;
    of_level *= shape.branches;
  }
  SubtreeBytes bytes(path, files);
  const JsonMembers root = bytes.root();
  if (root.members("extensions").contains("3DTILES_multiple_contents")) {
    root.refuse({.says = "3DTILES_multiple_contents is not read", .advice = "write version 1.1"});
  }
  const auto availability = [&](const char* key, std::uint64_t count) {
    return read({root.members(key), path, key}, bytes, count);
  };
  tiles_ = availability("tileAvailability", tiles);
  children_ = availability("childSubtreeAvailability", of_level);
  const std::size_t contents = root.list("contentAvailability").size();
  if (contents != 0 && contents != shape.contents) {
    root.refuse({.expected = fmt::format("contentAvailability of {} contents", shape.contents),
                 .found = fmt::to_string(contents)});
  }
  for (std::size_t k = 0; k < contents; ++k) {
    contents_.push_back(
        read(root.at("contentAvailability", k, "contentAvailability"), bytes, tiles));
  }
  require_whole(path);
  if (!has_tile(0, 0)) root.refuse({.expected = "the tile that it begins with", .found = "none"});
}

Subtree::Availability Subtree::read(const JsonMembers& availability, SubtreeBytes& bytes,
                                    std::uint64_t count) const {
  Availability out;
  if (const auto constant = availability.find_whole("constant")) {
    if (*constant > 1 || availability.has("bitstream")) {
      availability.refuse({.expected = "a constant of 0 or 1, or a bitstream", .found = "another"});
    }
    out.all = *constant == 1;
    return out;
  }
  const std::string_view bits = bytes.view(availability.whole("bitstream"));
  if (bits.size() < (count + 7) / 8) {
    availability.refuse(
        {.expected = fmt::format("{} bits", count), .found = fmt::format("{} bytes", bits.size())});
  }
  out.bits = bits.substr(0, (count + 7) / 8);
  if (count % 8 != 0) {
    out.bits.back() =
        static_cast<char>(static_cast<unsigned char>(out.bits.back()) & ((1u << count % 8) - 1));
  }
  std::uint64_t set = 0;
  for (const char byte : out.bits) set += std::popcount(static_cast<unsigned char>(byte));
  const auto told = availability.find_whole("availableCount");
  if (told && *told != set) {
    availability.refuse(
        {.expected = fmt::format("{} available, as it says", *told), .found = fmt::to_string(set)});
  }
  return out;
}

// Where one answer stands for all, nothing in particular is said of what hangs below no tile.
void Subtree::require_whole(const std::string& path) const {
  const auto refuse = [&](const char* what, std::uint64_t level, std::uint64_t i) {
    throw InputError(
        path, {.says = fmt::format(
                   "{} is available at level {} of the subtree, place {}, and no tile there", what,
                   level, i)});
  };
  for (std::uint64_t level = 0; level <= shape_.levels; ++level) {
    const std::uint64_t count = std::uint64_t{1} << level * (shape_.branches == 8 ? 3 : 2);
    for (std::uint64_t i = 0; i < count; ++i) {
      const bool below = level == 0 || has_tile(level - 1, i / shape_.branches);
      if (level == shape_.levels) {
        if (!below && !children_.bits.empty() && has_child(i)) {
          refuse("a subtree below", level - 1, i / shape_.branches);
        }
        continue;
      }
      if (!below && !tiles_.bits.empty() && has_tile(level, i)) {
        refuse("a tile below", level - 1, i / shape_.branches);
      }
      for (const Availability& content : contents_) {
        if (!content.bits.empty() && content.at(place(level, i)) && !has_tile(level, i)) {
          refuse("content", level, i);
        }
      }
    }
  }
}

}  // namespace geom
