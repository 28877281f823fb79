#include "text/xml_head.h"

#include <algorithm>
#include <utility>

#include "geom/base/error.h"

namespace geom {
namespace {

constexpr std::string_view kSpace = " \t\r\n";
constexpr std::string_view kMark = "\xef\xbb\xbf";  // of byte order

bool is_wide(std::string_view head) {
  using std::string_view_literals::operator""sv;
  for (const std::string_view start : {"\xff\xfe"sv, "\xfe\xff"sv, "<\0"sv, "\0<"sv, "\0\0"sv}) {
    if (head.starts_with(start)) return true;
  }
  return false;
}

// Where the comment or instruction that begins at `at` ends; `at` where none begins.
std::size_t behind_aside(std::string_view head, std::size_t at) {
  for (const auto& [begin, end] :
       {std::pair<std::string_view, std::string_view>{"<!--", "-->"}, {"<?", "?>"}}) {
    if (!head.substr(at).starts_with(begin)) continue;
    const std::size_t found = head.find(end, at + begin.size());
    return found == head.npos ? head.size() : found + end.size();
  }
  return at;
}

}  // namespace

void require_plain_xml(std::string_view head, std::string_view source) {
  if (is_wide(head)) {
    throw InputError(
        source,
        {.expected = "XML in UTF-8", .found = "UTF-16 or UTF-32", .advice = "write it as UTF-8"});
  }
  const auto first_of = [&](std::size_t at) {
    return std::min(head.find_first_not_of(kSpace, at), head.size());
  };
  std::size_t at = first_of(head.starts_with(kMark) ? kMark.size() : 0);
  if (at < head.size() && head[at] != '<') return;
  for (std::size_t next = at; at < head.size(); at = first_of(next)) {
    next = behind_aside(head, at);
    if (next > at) continue;
    if (!head.substr(at).starts_with("<!")) return;
    const auto line =
        std::count(head.begin(), head.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    refuse_document_type(source, static_cast<std::size_t>(line) + 1);
  }
  if (head.size() >= kXmlHead) {
    throw InputError(
        source, {.expected = "an element within the first MiB of an XML file", .found = "none"});
  }
}

void XmlWatch::look(std::string_view part) {
  if (!begun_) require_plain_xml(part, source_);
  begun_ = true;
  last_ += part;
  const auto lines_to = [&](std::size_t at) {
    const auto lines =
        std::count(last_.begin(), last_.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    return line_ + static_cast<std::size_t>(lines);
  };
  const std::size_t named = last_.find(kXInclude);
  if (named != last_.npos) refuse_inclusion(source_, lines_to(named));
  const std::size_t passed = last_.size() - std::min(last_.size(), kXInclude.size() - 1);
  line_ = lines_to(passed);
  last_.erase(0, passed);
}

void refuse_document_type(std::string_view source, std::size_t line) {
  throw InputError(source, line,
                   {.expected = "no document type",
                    .found = "one",
                    .advice = "its entities may stand for parts that are not read; write the file "
                              "without it, for example with xmllint --noent --dropdtd"});
}

void refuse_inclusion(std::string_view source, std::size_t line) {
  throw InputError(source, line,
                   {.expected = "the whole file",
                    .found = "an <include> of another (XInclude)",
                    .advice = "put it together, for example with xmllint --xinclude"});
}

}  // namespace geom
