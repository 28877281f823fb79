#include "geom/text/json_line.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geom/text/number.h"

namespace geom {
namespace {

// Nothing to escape, and ASCII: almost all that records hold.
bool is_plain(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; });
}

}  // namespace

JsonLine& JsonLine::add_json(std::string_view key, std::string_view json) {
  append_key(key);
  text_ += json;
  return *this;
}

// Texts end with their quote: only what was just opened ends with its bracket.
void JsonLine::separate() {
  if (text_.back() != '{' && text_.back() != '[') text_ += ',';
}

void JsonLine::append_key(std::string_view key) {
  separate();
  append_text(key);
  text_ += ':';
}

void JsonLine::append_double(double value) { append_number(text_, value); }

void JsonLine::append_text(std::string_view text) {
  if (!is_plain(text)) {
    text_ += nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    return;
  }
  text_ += '"';
  text_ += text;
  text_ += '"';
}

}  // namespace geom
