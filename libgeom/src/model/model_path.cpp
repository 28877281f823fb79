#include "model_path.h"

#include <fmt/format.h>

#include <vector>

#include "geom/base/error.h"
#include "geom/text/excerpt.h"

namespace geom {
namespace {

int hexadecimal(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string percent_decoded(std::string_view text, std::string_view source) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      out += text[i];
      continue;
    }
    const int high = i + 2 < text.size() ? hexadecimal(text[i + 1]) : -1;
    const int low = i + 2 < text.size() ? hexadecimal(text[i + 2]) : -1;
    if (high < 0 || low < 0 || high + low == 0) {
      throw InputError(source,
                       {.expected = fmt::format("two hexadecimal digits after % in the URI \"{}\"",
                                                excerpt(text))});
    }
    out += static_cast<char>(16 * high + low);
    i += 2;
  }
  return out;
}

int base64_value(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return -1;
}

std::string base64_decoded(std::string_view text, std::string_view source) {
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string out;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    const int value = base64_value(c);
    if (value < 0)
      throw InputError(source, {.expected = "base64 in a data URI", .found = "another letter"});
    bits = (bits << 6 | static_cast<unsigned>(value)) & 0xFFFFFF;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    out += static_cast<char>(bits >> count & 0xFF);
  }
  if (count == 6) throw InputError(source, {.says = "the base64 of a data URI is cut short"});
  return out;
}

}  // namespace

bool is_data_uri(std::string_view uri) { return uri.starts_with("data:"); }

std::string data_of_uri(std::string_view uri, std::string_view source) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) {
    throw InputError(source, {.expected = "a comma in a data URI", .found = "none"});
  }
  const std::string_view data = uri.substr(comma + 1);
  if (uri.substr(0, comma).ends_with(";base64")) return base64_decoded(data, source);
  return percent_decoded(data, source);
}

std::string path_of_uri(std::string_view uri, std::string_view base, std::string_view source) {
  const auto refuse = [&](const char* why) {
    throw InputError(source, {.expected = "the path of a file beside this one",
                              .found = fmt::format("\"{}\": {}", excerpt(uri), why)});
  };
  if (uri.empty() || uri.starts_with('/') || uri.find('\\') != std::string_view::npos) {
    refuse("it is empty, absolute, or has a backslash");
  }
  if (uri.substr(0, uri.find('/')).find(':') != std::string_view::npos) {
    refuse("nothing is fetched from elsewhere; download the files first");
  }
  const std::string decoded = percent_decoded(uri.substr(0, uri.find_first_of("?#")), source);
  const std::size_t folder = base.rfind('/');
  std::string all(folder == std::string_view::npos ? "" : base.substr(0, folder + 1));
  all += decoded;
  std::vector<std::string_view> steps;
  const std::string_view whole = all;
  for (std::size_t at = 0; at <= whole.size();) {
    const std::size_t end = std::min(whole.find('/', at), whole.size());
    const std::string_view step = whole.substr(at, end - at);
    if (step == "..") {
      if (steps.empty()) refuse("it leads above the folder of the first file");
      steps.pop_back();
    } else if (!step.empty() && step != ".") {
      steps.push_back(step);
    }
    at = end + 1;
  }
  std::string out;
  for (const std::string_view step : steps) out += (out.empty() ? "" : "/") + std::string(step);
  if (out.empty()) refuse("it names no file");
  return out;
}

}  // namespace geom
