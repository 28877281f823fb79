#include "geom/text/beginning.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>

namespace geom {
namespace {

std::string without_blanks(std::string_view text) {
  std::string out;
  std::copy_if(text.begin(), text.end(), std::back_inserter(out),
               [](unsigned char c) { return !std::isspace(c); });
  return out;
}

std::size_t byte(std::string_view head, std::size_t at) {
  return at < head.size() ? static_cast<unsigned char>(head[at]) : 0;
}

}  // namespace

std::string_view text_of(std::string_view head) {
  if (head.starts_with("\xef\xbb\xbf")) head.remove_prefix(3);
  head.remove_prefix(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
  return head;
}

std::string_view first_line(std::string_view head) {
  while (!head.empty()) {
    const std::size_t end = std::min(head.find('\n'), head.size());
    std::string_view line = head.substr(0, end);
    line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
    if (!line.empty() && line.front() != '#') return line;
    head.remove_prefix(std::min(end + 1, head.size()));
  }
  return {};
}

bool is_xml_with(std::string_view head, std::string_view part) {
  const std::string_view text = text_of(head);
  return text.starts_with('<') && text.find(part) != text.npos;
}

bool is_json_with(std::string_view head, std::string_view part) {
  const std::string_view text = text_of(head);
  if (!text.starts_with('{') && !text.starts_with('[')) return false;
  return without_blanks(text).find(part) != std::string::npos;
}

bool is_json_of_type(std::string_view head, std::string_view type) {
  const std::string_view text = text_of(head);
  if (!text.starts_with('{')) return false;
  const std::string dense = without_blanks(text);
  const std::size_t first = dense.find("\"type\":");
  const std::string said = "\"type\":\"" + std::string(type) + '"';
  return first != dense.npos && dense.find(said) == first;
}

bool is_zip(std::string_view head) { return head.starts_with("PK\x03\x04"); }

std::string_view first_zip_entry(std::string_view head) {
  constexpr std::size_t kNameSize = 26;
  constexpr std::size_t kName = 30;
  if (!is_zip(head)) return {};
  const std::size_t size = byte(head, kNameSize) + 256 * byte(head, kNameSize + 1);
  return head.substr(std::min(kName, head.size()), size);
}

bool is_archive_of(std::string_view head, std::string_view format) {
  if (first_zip_entry(head) != "meta.json") return false;
  const std::string said = "\"format\":\"" + std::string(format) + '"';
  return without_blanks(head).find(said) != std::string::npos;
}

}  // namespace geom
