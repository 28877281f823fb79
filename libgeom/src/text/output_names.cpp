#include "geom/text/output_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "geom/base/error.h"
#include "geom/base/usage_error.h"

namespace geom {
namespace {

constexpr std::size_t kLongest = 100;

bool is_safe(char c) {
  constexpr std::string_view kOthers = "._-";
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         kOthers.find(c) != std::string_view::npos;
}

// Of a name in which letters beyond ASCII are not looked at.
std::string without_case(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return name;
}

}  // namespace

std::string safe_name(const std::string& id) {
  std::string name = id.substr(0, kLongest);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !is_safe(c); }, '_');
  if (name.empty()) return "_";
  if (name.front() == '.') name.front() = '_';
  return name;
}

OutputNames::OutputNames(std::string pattern, const char* option)
    : pattern_(std::move(pattern)), at_(pattern_.find("%s")) {
  if (each() && pattern_.find("%s", at_ + 2) != std::string::npos) {
    throw UsageError(fmt::format("{}: expected one %s, which stands for the id, found \"{}\"",
                                 option, pattern_));
  }
}

std::string OutputNames::of(const std::string& id, const std::string& source) {
  if (!each()) return pattern_;
  std::string name = pattern_;
  name.replace(at_, 2, safe_name(id));
  const auto [there, is_new] = id_of_.emplace(without_case(name), id);
  if (!is_new) {
    throw InputError(source,
                     {.expected = "ids that give different files",
                      .found = fmt::format("\"{}\" and \"{}\" for {}", there->second, id, name),
                      .advice = "change one of them"});
  }
  return name;
}

}  // namespace geom
