#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <exception>
#include <memory>
#include <new>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include "expat_library.h"
#include "geom/base/error.h"
#include "geom/text/excerpt.h"
#include "xml_events.h"
#include "xml_head.h"
#include "xml_namespaces.h"

namespace geom {
namespace {

constexpr std::size_t kDeepest = 200;
constexpr std::size_t kPart = 1 << 16;  // bytes that Expat gets at once, and copies
constexpr std::size_t kShown = 20;      // bytes of what is not well-formed

// The characters of bytes 0x80 to 0x9f in windows-1252; -1 for bytes that have none.
constexpr std::array<int, 32> kWindows1252 = {
    0x20ac, -1,     0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021, 0x02c6, 0x2030, 0x0160,
    0x2039, 0x0152, -1,     0x017d, -1,     -1,     0x2018, 0x2019, 0x201c, 0x201d, 0x2022,
    0x2013, 0x2014, 0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, -1,     0x017e, 0x0178};

struct ParserFree {
  void operator()(XML_Parser parser) const { expat().parser_free(parser); }
};

bool is_windows_1252(std::string_view encoding) {
  constexpr std::string_view kName = "windows-1252";
  return std::equal(encoding.begin(), encoding.end(), kName.begin(), kName.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; });
}

// What the callbacks share. C code calls them, and nothing may be thrown through it.
class Bridge {
 public:
  Bridge(const std::string& source, XmlHandler& handler)
      : source_(source), handler_(handler), parser_(expat().parser_create(nullptr)) {
    if (!parser_) throw std::bad_alloc();
    expat().set_user_data(parser_.get(), this);
    expat().set_element_handler(parser_.get(), &Bridge::begin, &Bridge::end);
    expat().set_character_data_handler(parser_.get(), &Bridge::text);
    expat().set_start_doctype_handler(parser_.get(), &Bridge::document_type);
    expat().set_unknown_encoding_handler(parser_.get(), &Bridge::encoding, this);
  }

  void feed(std::string_view bytes, bool last) {
    const int size = static_cast<int>(bytes.size());
    if (expat().parse(parser_.get(), bytes.data(), size, last) == XML_STATUS_OK) return;
    if (thrown_) std::rethrow_exception(thrown_);
    const XML_Error error = expat().error_code(parser_.get());
    if (error == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
    refuse(problem(error));
  }

 private:
  std::size_t line() const { return expat().current_line(parser_.get()); }

  [[noreturn]] void refuse(Fault fault) const {
    throw InputError(source_, line(), std::move(fault));
  }

  // The first bytes of what Expat stopped at, as a message may show them.
  std::string found() const {
    int at = 0;
    int size = 0;
    const char* const bytes = expat().input_context(parser_.get(), &at, &size);
    if (!bytes || at >= size) return "the end of the file";
    const std::string_view rest(bytes + at, static_cast<std::size_t>(size - at));
    return '"' + excerpt(rest.substr(0, kShown + 1), kShown) + '"';
  }

  Fault problem(XML_Error error) const {
    switch (error) {
      case XML_ERROR_NO_ELEMENTS:
        if (open_.empty()) return {.expected = "an element", .found = "the end of the file"};
        return {.says = fmt::format("the element of line {} is not ended", open_.back()),
                .advice = "the file may be cut"};
      case XML_ERROR_UNCLOSED_TOKEN:
      case XML_ERROR_PARTIAL_CHAR:
      case XML_ERROR_UNCLOSED_CDATA_SECTION:
        return {.says = "a tag, a comment or a text is not ended",
                .advice = "the file may be cut, get it again"};
      case XML_ERROR_TAG_MISMATCH:
        return {.expected = fmt::format("the end of the element of line {}", open_.back()),
                .found = "another's"};
      case XML_ERROR_DUPLICATE_ATTRIBUTE:
        return {.expected = "each attribute of a tag once", .found = "one twice"};
      case XML_ERROR_JUNK_AFTER_DOC_ELEMENT:
        return {.expected = "nothing more after the root element", .found = found()};
      case XML_ERROR_UNDEFINED_ENTITY:
        return {.expected = "only entities of XML itself",
                .found = found(),
                .advice = "write out what it stands for"};
      case XML_ERROR_BAD_CHAR_REF:
        return {.expected = "the number of a character after &#", .found = found()};
      case XML_ERROR_MISPLACED_XML_PI:
        return {.expected = "<?xml ...?> at the first byte",
                .found = "it later",
                .advice = "take out what stands before it"};
      case XML_ERROR_INCORRECT_ENCODING:
        return {.expected = "the encoding that the file names",
                .found = "another",
                .advice = "write it as UTF-8"};
      default:
        return {.expected = "well-formed XML",
                .found = found(),
                .advice = "correct it, or get the file again"};
    }
  }

  template <class F>
  void guarded(const F& f) {
    if (thrown_) return;
    try {
      f();
    } catch (...) {
      thrown_ = std::current_exception();
      expat().stop_parser(parser_.get(), XML_FALSE);
    }
  }

  void take(std::string_view full, const XML_Char** attributes) {
    if (open_.size() == kDeepest) {
      refuse(
          {.expected = fmt::format("elements nested at most {} deep", kDeepest), .found = "more"});
    }
    attributes_.clear();
    for (const XML_Char** a = attributes; *a; a += 2) attributes_.push_back({a[0], a[1]});
    namespaces_.enter(attributes_);
    XmlTag tag;
    const std::size_t colon = full.rfind(':');
    tag.name = full.substr(colon + 1);
    if (colon != full.npos) tag.prefix = full.substr(0, colon);
    tag.space = namespaces_.of(tag.prefix);
    tag.attributes = attributes_;
    tag.line = line();
    if (tag.space == kXInclude) refuse_inclusion(source_, tag.line);
    open_.push_back(tag.line);
    handler_.begin(tag);
  }

  static Bridge& of(void* self) { return *static_cast<Bridge*>(self); }

  static void begin(void* self, const XML_Char* name, const XML_Char** attributes) {
    of(self).guarded([&] { of(self).take(name, attributes); });
  }

  static void text(void* self, const XML_Char* part, int size) {
    of(self).guarded([&] { of(self).handler_.text({part, static_cast<std::size_t>(size)}); });
  }

  static void end(void* self, const XML_Char*) {
    Bridge& bridge = of(self);
    bridge.guarded([&] {
      bridge.open_.pop_back();
      bridge.namespaces_.leave();
      bridge.handler_.end(bridge.line());
    });
  }

  static void document_type(void* self, const XML_Char*, const XML_Char*, const XML_Char*, int) {
    of(self).guarded([&] { refuse_document_type(of(self).source_, of(self).line()); });
  }

  // Expat knows the other encodings that are read.
  static int encoding(void* self, const XML_Char* name, XML_Encoding* made) {
    of(self).guarded([&] {
      if (is_windows_1252(name)) return;
      of(self).refuse({.expected = "UTF-8, UTF-16, ISO-8859-1, US-ASCII or windows-1252",
                       .found = fmt::format("the encoding \"{}\"", excerpt(name, 40)),
                       .advice = "write the file as UTF-8"});
    });
    for (int i = 0; i < 256; ++i) made->map[i] = i;
    std::copy(kWindows1252.begin(), kWindows1252.end(), made->map + 0x80);
    made->data = nullptr;
    made->convert = nullptr;
    made->release = nullptr;
    return of(self).thrown_ ? XML_STATUS_ERROR : XML_STATUS_OK;
  }

  const std::string& source_;
  XmlHandler& handler_;
  std::unique_ptr<std::remove_pointer_t<XML_Parser>, ParserFree> parser_;
  std::exception_ptr thrown_;
  std::vector<std::size_t> open_;  // the lines of elements that are open
  std::vector<XmlAttribute> attributes_;
  XmlNamespaces namespaces_;
};

}  // namespace

void read_xml(std::istream& in, const std::string& source, XmlHandler& handler) {
  Bridge bridge(source, handler);
  std::array<char, kPart> bytes;
  bool last = false;
  while (!last) {
    in.read(bytes.data(), bytes.size());
    if (in.bad()) throw std::system_error(errno, std::generic_category(), source);
    last = in.eof();
    bridge.feed({bytes.data(), static_cast<std::size_t>(in.gcount())}, last);
  }
}

void read_xml(std::string_view text, const std::string& source, XmlHandler& handler) {
  Bridge bridge(source, handler);
  do {
    const std::string_view part = text.substr(0, kPart);
    text.remove_prefix(part.size());
    bridge.feed(part, text.empty());
  } while (!text.empty());
}

}  // namespace geom
