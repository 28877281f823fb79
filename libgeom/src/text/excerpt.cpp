#include "geom/text/excerpt.h"

#include <fmt/format.h>

#include <cstdint>
#include <iterator>

namespace geom {
namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 0;  // 0: no UTF-8 begins here
};

// The character that `text`, which is not empty, begins with (RFC 3629: no surrogates, nothing
// longer than it need be).
Character first_of(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return {};
  std::uint32_t code = lead & (0x7fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3f);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  if (code < kLeast[bytes] || code > 0x10ffff || surrogate) return {};
  return {code, bytes};
}

// Control characters (C0, DEL, C1), line and paragraph separators, and what reorders or hides the
// text around it.
bool steers(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || (code >= 0x200b && code <= 0x200f) ||
         (code >= 0x2028 && code <= 0x202e) || (code >= 0x2060 && code <= 0x206f) || code == 0xfeff;
}

void append_escaped(std::string& out, std::uint32_t code) {
  const auto to = std::back_inserter(out);
  if (code == '\n') {
    out += "\\n";
  } else if (code == '\t') {
    out += "\\t";
  } else if (code == '\r') {
    out += "\\r";
  } else if (code < 0x80) {
    fmt::format_to(to, "\\x{:02x}", code);
  } else {
    fmt::format_to(to, "\\u{:04x}", code);
  }
}

// Takes the first character, or byte that is none, off `text`.
std::string next(std::string_view& text) {
  const Character c = first_of(text);
  std::string out;
  if (c.bytes == 0) {
    fmt::format_to(std::back_inserter(out), "\\x{:02x}", static_cast<std::uint8_t>(text[0]));
  } else if (steers(c.code)) {
    append_escaped(out, c.code);
  } else {
    out = text.substr(0, c.bytes);
  }
  text.remove_prefix(c.bytes ? c.bytes : 1);
  return out;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) out += next(text);
  return out;
}

std::string excerpt(std::string_view text, std::size_t most) {
  constexpr std::string_view kMore = "...";
  std::string out;
  std::size_t whole = 0;  // how much of `out` leaves room for kMore
  while (!text.empty() && out.size() <= most) {
    out += next(text);
    if (out.size() + kMore.size() <= most) whole = out.size();
  }
  if (out.size() <= most) return out;
  return out.substr(0, whole).append(kMore);
}

}  // namespace geom
