#include "geom/text/xml_element.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "geom/base/error.h"
#include "text/xml_head.h"

namespace geom {
namespace {

constexpr std::size_t kDeepest = 100;
constexpr std::string_view kSpace = " \t\r\n";
constexpr std::string_view kMark = "\xef\xbb\xbf";  // of byte order

// A character as UTF-8; nothing for what XML cannot hold.
std::string utf8(std::uint32_t c) {
  const auto byte = [](std::uint32_t value) { return static_cast<char>(value); };
  const bool control = c < 0x20 && c != 0x9 && c != 0xa && c != 0xd;
  if (control || (c >= 0xd800 && c < 0xe000) || c > 0x10ffff) return {};
  if (c < 0x80) return {byte(c)};
  if (c < 0x800) return {byte(0xc0 | c >> 6), byte(0x80 | (c & 0x3f))};
  if (c < 0x10000) {
    return {byte(0xe0 | c >> 12), byte(0x80 | (c >> 6 & 0x3f)), byte(0x80 | (c & 0x3f))};
  }
  return {byte(0xf0 | c >> 18), byte(0x80 | (c >> 12 & 0x3f)), byte(0x80 | (c >> 6 & 0x3f)),
          byte(0x80 | (c & 0x3f))};
}

class XmlParser {
 public:
  XmlParser(std::string_view text, std::string_view source) : text_(text), source_(source) {}

  XmlElement parse() {
    require_characters();
    require_plain_xml(text_.substr(0, kXmlHead), source_);
    take(kMark);
    pass_beside("an element");
    if (at_end()) refuse({.expected = "an element", .found = "the end of the file"});
    XmlElement root = element(0);
    pass_beside("nothing more after the root element");
    if (!at_end()) refuse({.expected = "nothing more after the root element", .found = "another"});
    return root;
  }

 private:
  [[noreturn]] void refuse(Fault fault) const {
    throw InputError(source_, line_, std::move(fault));
  }

  bool at_end() const { return at_ == text_.size(); }
  bool next_is(std::string_view word) const { return text_.substr(at_).starts_with(word); }

  void pass(std::size_t count) {
    const std::string_view passed = text_.substr(at_, count);
    line_ += static_cast<std::size_t>(std::count(passed.begin(), passed.end(), '\n'));
    at_ += passed.size();
  }

  bool take(std::string_view word) {
    if (!next_is(word)) return false;
    pass(word.size());
    return true;
  }

  void pass_space() { pass(std::min(text_.find_first_not_of(kSpace, at_), text_.size()) - at_); }

  // The text up to `end`, which is passed too.
  std::string_view up_to(std::string_view end, const char* what) {
    const std::size_t stop = text_.find(end, at_);
    if (stop == text_.npos)
      refuse({.says = fmt::format("{} is not ended", what), .advice = "the file may be cut"});
    const std::string_view found = text_.substr(at_, stop - at_);
    pass(found.size() + end.size());
    return found;
  }

  void require_characters() {
    for (const char c : text_) {
      const bool control = static_cast<unsigned char>(c) < ' ' && kSpace.find(c) == kSpace.npos;
      if (control) {
        refuse({.expected = "text",
                .found =
                    fmt::format("the control character 0x{:02x}", static_cast<unsigned char>(c))});
      }
      line_ += c == '\n';
    }
    line_ = 1;
  }

  // Comments and instructions, also those that stand inside an element.
  bool pass_aside() {
    if (take("<!--")) {
      up_to("-->", "a comment");
    } else if (take("<?")) {
      require_encoding(up_to("?>", "an instruction"));
    } else {
      return false;
    }
    return true;
  }

  void require_encoding(std::string_view instruction) {
    if (!instruction.starts_with("xml ")) return;
    const std::size_t at = instruction.find("encoding");
    if (at == instruction.npos) return;
    std::string said(instruction.substr(at + 8));
    std::transform(said.begin(), said.end(), said.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    for (const char* known : {"utf-8", "us-ascii", "iso-8859-1", "windows-1252"}) {
      if (said.find(known) != said.npos) return;
    }
    refuse({.expected = "the encoding UTF-8", .found = "another"});
  }

  // What may stand before and after the root.
  void pass_beside(const char* expected) {
    do {
      pass_space();
    } while (pass_aside());
    if (!at_end() && !next_is("<")) refuse({.expected = std::string(expected), .found = "text"});
  }

  std::string name(const char* what) {
    const std::size_t stop = std::min(text_.find_first_of(" \t\r\n/>=<\"'&", at_), text_.size());
    const std::string found(text_.substr(at_, stop - at_));
    const auto letter = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':' ||
             static_cast<unsigned char>(c) >= 0x80;
    };
    if (found.empty() || !letter(found[0])) refuse({.expected = std::string(what)});
    pass(found.size());
    return found;
  }

  void take_attributes(XmlElement& made) {
    while (true) {
      pass_space();
      if (at_end() || next_is(">") || next_is("/")) return;
      std::string key = name("the name of an attribute or the end of the tag");
      pass_space();
      if (!take("=")) refuse({.expected = "= after the name of an attribute"});
      pass_space();
      const std::string quote(text_.substr(at_, 1));
      if (quote != "\"" && quote != "'") refuse({.expected = "a value in quotes"});
      pass(1);
      const std::string_view value = up_to(quote, "a value");
      if (value.find('<') != std::string_view::npos) refuse({.expected = "no < in a value"});
      made.attributes.emplace_back(std::move(key), resolved(value));
      if (made.attributes.back().second == kXInclude) refuse_inclusion(source_, line_);
    }
  }

  std::string resolved(std::string_view value) const {
    std::string out;
    for (std::size_t at = 0; at < value.size();) {
      const std::size_t start = std::min(value.find('&', at), value.size());
      out += value.substr(at, start - at);
      if (start == value.size()) break;
      const std::size_t end = value.find(';', start);
      if (end == value.npos) refuse({.says = "an entity is not ended"});
      out += entity(value.substr(start + 1, end - start - 1));
      at = end + 1;
    }
    return out;
  }

  std::string entity(std::string_view word) const {
    for (const auto& [known, meaning] :
         {std::pair{"lt", "<"}, {"gt", ">"}, {"amp", "&"}, {"quot", "\""}, {"apos", "'"}}) {
      if (word == known) return meaning;
    }
    const bool hex = word.starts_with("#x");
    if (!word.starts_with("#")) refuse({.expected = "an entity of XML itself", .found = "another"});
    const std::string_view digits = word.substr(hex ? 2 : 1);
    std::uint32_t c = 0;
    const auto [rest, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), c, hex ? 16 : 10);
    std::string found = utf8(c);
    if (error != std::errc() || rest != digits.data() + digits.size() || found.empty()) {
      refuse({.expected = "the number of a character after &#"});
    }
    return found;
  }

  XmlElement element(std::size_t depth) {
    if (depth == kDeepest)
      refuse({.expected = "elements nested at most 100 deep", .found = "more"});
    XmlElement made;
    made.line = line_;
    if (!take("<")) refuse({.expected = "an element"});
    const std::string full = name("the name of an element");
    const std::size_t colon = full.rfind(':');
    made.name = full.substr(colon + 1);
    if (colon != full.npos) made.prefix = full.substr(0, colon);
    take_attributes(made);
    if (take("/>")) return made;
    if (!take(">")) refuse({.says = "a tag is not ended", .advice = "the file may be cut"});
    take_content(made, depth);
    if (name("the name of the element that ends") != full) {
      refuse({.expected = fmt::format("the end of the element of line {}", made.line),
              .found = "another's"});
    }
    pass_space();
    if (!take(">")) refuse({.says = "a tag is not ended", .advice = "the file may be cut"});
    return made;
  }

  // Up to the name in the tag that ends the element.
  void take_content(XmlElement& made, std::size_t depth) {
    while (!take("</")) {
      if (at_end()) {
        refuse({.says = fmt::format("the element of line {} is not ended", made.line),
                .advice = "the file may be cut"});
      }
      if (take("<![CDATA[")) {
        made.text += up_to("]]>", "a CDATA section");
      } else if (take("&")) {
        made.text += entity(up_to(";", "an entity"));
      } else if (next_is("<")) {
        if (!pass_aside()) made.children.push_back(element(depth + 1));
      } else {
        const std::size_t stop = std::min(text_.find_first_of("<&", at_), text_.size());
        made.text += text_.substr(at_, stop - at_);
        pass(stop - at_);
      }
    }
  }

  std::string_view text_;
  std::string_view source_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

}  // namespace

XmlElement parse_xml(std::string_view text, std::string_view source) {
  return XmlParser(text, source).parse();
}

}  // namespace geom
