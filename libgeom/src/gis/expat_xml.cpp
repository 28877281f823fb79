#include <expat.h>
#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <exception>
#include <memory>
#include <system_error>

#include "geom/base/error.h"
#include "text/xml_head.h"
#include "xml.h"

namespace geom::gis {
namespace {

constexpr char kBetween = '|';  // a namespace and a name
constexpr std::size_t kDeepest = 200;

struct ParserFree {
  void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
};

// What the callbacks share. They are called by C code, through which nothing may be thrown.
class Bridge {
 public:
  Bridge(const std::string& name, XmlHandler& handler)
      : name_(name), handler_(handler), parser_(XML_ParserCreateNS(nullptr, kBetween)) {
    if (!parser_) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), &Bridge::begin, &Bridge::end);
    XML_SetCharacterDataHandler(parser_.get(), &Bridge::text);
    XML_SetStartDoctypeDeclHandler(parser_.get(), &Bridge::document_type);
  }

  void feed(const char* bytes, std::size_t size, bool last) {
    if (XML_Parse(parser_.get(), bytes, static_cast<int>(size), last) == XML_STATUS_OK) return;
    if (thrown_) std::rethrow_exception(thrown_);
    const XML_Error error = XML_GetErrorCode(parser_.get());
    if (error == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
    throw InputError(name_, line(),
                     {.expected = "well-formed XML to its end",
                      .found = in_quotes(XML_ErrorString(error)),
                      .advice = "the file is damaged or cut, get it again"});
  }

 private:
  std::size_t line() const { return XML_GetCurrentLineNumber(parser_.get()); }

  template <class F>
  void guarded(const F& f) {
    if (thrown_) return;
    try {
      f();
    } catch (...) {
      thrown_ = std::current_exception();
      XML_StopParser(parser_.get(), XML_FALSE);
    }
  }

  // "URI|name", or a name alone.
  static std::pair<std::string, std::string> split(std::string_view full) {
    const std::size_t at = full.rfind(kBetween);
    if (at == std::string_view::npos) return {"", std::string(full)};
    return {std::string(full.substr(0, at)), std::string(full.substr(at + 1))};
  }

  static void begin(void* self, const XML_Char* full, const XML_Char** attributes) {
    Bridge& bridge = *static_cast<Bridge*>(self);
    bridge.guarded([&] {
      if (++bridge.depth_ > kDeepest) {
        throw InputError(
            bridge.name_, bridge.line(),
            {.expected = fmt::format("elements at most {} deep", kDeepest), .found = "more"});
      }
      XmlElement element;
      std::tie(element.space, element.name) = split(full);
      if (element.space == kXInclude) refuse_inclusion(bridge.name_, bridge.line());
      for (const XML_Char** a = attributes; *a; a += 2) {
        element.attributes.emplace_back(split(a[0]).second, a[1]);
      }
      element.line = bridge.line();
      bridge.handler_.begin(std::move(element));
    });
  }

  static void document_type(void* self, const XML_Char*, const XML_Char*, const XML_Char*, int) {
    Bridge& bridge = *static_cast<Bridge*>(self);
    bridge.guarded([&] { refuse_document_type(bridge.name_, bridge.line()); });
  }

  static void text(void* self, const XML_Char* part, int size) {
    Bridge& bridge = *static_cast<Bridge*>(self);
    bridge.guarded([&] { bridge.handler_.text({part, static_cast<std::size_t>(size)}); });
  }

  static void end(void* self, const XML_Char*) {
    Bridge& bridge = *static_cast<Bridge*>(self);
    bridge.guarded([&] {
      --bridge.depth_;
      bridge.handler_.end(bridge.line());
    });
  }

  const std::string& name_;
  XmlHandler& handler_;
  std::unique_ptr<std::remove_pointer_t<XML_Parser>, ParserFree> parser_;
  std::exception_ptr thrown_;
  std::size_t depth_ = 0;
};

}  // namespace

void read_xml(std::istream& in, const std::string& name, XmlHandler& handler) {
  Bridge bridge(name, handler);
  std::array<char, 1 << 16> bytes;
  bool last = false;
  while (!last) {
    in.read(bytes.data(), bytes.size());
    if (in.bad()) throw std::system_error(errno, std::generic_category(), name);
    last = in.eof();
    bridge.feed(bytes.data(), static_cast<std::size_t>(in.gcount()), last);
  }
}

}  // namespace geom::gis
