#include "geom/text/parse_json.h"

#include <istream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "geom/base/file_error.h"
#include "geom/text/excerpt.h"
#include "simdjson_value.h"
#include "worded_json.h"

namespace geom {
namespace {

constexpr std::size_t kShown = 60;  // bytes

// Goes no further into a value than a message will show.
template <class Json>
void append_shown(std::string& out, const Json& value) {
  if (value.is_string()) {
    const auto& text = value.template get_ref<const std::string&>();
    out += Json(text.substr(0, kShown + 1)).dump(-1, ' ', false, Json::error_handler_t::replace);
  } else if (!value.is_structured()) {
    out += value.dump();
  } else {
    const bool object = value.is_object();
    out += object ? '{' : '[';
    bool first = true;
    for (auto at = value.begin(); at != value.end() && out.size() <= kShown; ++at) {
      if (!std::exchange(first, false)) out += ',';
      if (object) out += '"' + at.key().substr(0, kShown + 1) + "\":";
      append_shown(out, *at);
    }
    out += object ? '}' : ']';
  }
}

template <class Json>
std::string beginning(const Json& value) {
  std::string out;
  append_shown(out, value);
  return excerpt(out, kShown);
}

}  // namespace

nlohmann::json parse_json(std::string_view text, std::string_view source, std::size_t line) {
  if (std::optional<nlohmann::json> value = simdjson_value(text)) return *std::move(value);
  return worded_json(text, source, line);
}

nlohmann::json parse_json(std::istream& in, std::string_view source) {
  const std::string text(std::istreambuf_iterator<char>(in), {});
  if (in.bad()) {
    throw FileError(FileUse::reading, std::string(source), EIO);
  }
  return parse_json(text, source);
}

nlohmann::ordered_json parse_ordered_json(std::string_view text, std::string_view source) {
  return worded_ordered_json(text, source);
}

std::string shown(const nlohmann::json& value) { return beginning(value); }
std::string shown(const nlohmann::ordered_json& value) { return beginning(value); }

}  // namespace geom
