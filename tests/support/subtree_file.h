#pragma once

// Subtrees of implicit tiling for tests, byte by byte.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "geom/archive/bytes.h"
#include "support/glb_file.h"

namespace support {

// "1010…", of which the first is the lowest bit of the first byte.
inline std::string bits(const std::string& each) {
  std::string out((each.size() + 7) / 8, '\0');
  for (std::size_t i = 0; i < each.size(); ++i) {
    if (each[i] == '1') out[i / 8] = static_cast<char>(out[i / 8] | 1 << i % 8);
  }
  return out;
}

// Bits of tiles, of their contents, and of the subtrees below. "0" and "1" alone are constants.
struct SubtreeFile {
  json text;
  std::string binary;

  SubtreeFile(const std::string& tiles, const std::vector<std::string>& contents,
              const std::string& children) {
    text["buffers"] = json::array({json::object()});
    text["bufferViews"] = json::array();
    text["tileAvailability"] = availability(tiles);
    text["childSubtreeAvailability"] = availability(children);
    for (const std::string& content : contents) {
      text["contentAvailability"].push_back(availability(content));
    }
    text["buffers"][0]["byteLength"] = binary.size();
  }

  json availability(const std::string& each) {
    if (each == "0" || each == "1") return {{"constant", each == "1" ? 1 : 0}};
    const std::string bytes = bits(each);
    text["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}});
    binary += bytes;
    return {{"bitstream", text["bufferViews"].size() - 1},
            {"availableCount", std::count(each.begin(), each.end(), '1')}};
  }

  std::string bytes() const {
    const std::string first = padded(text.dump(), ' ');
    const std::string second = padded(binary, '\0');
    std::string out = "subt";
    geom::append_bytes(out, std::uint32_t{1});
    geom::append_bytes(out, std::uint64_t{first.size()});
    geom::append_bytes(out, std::uint64_t{second.size()});
    return out + first + second;
  }
};

}  // namespace support
