// Options of the tools in messages, as the keyword arguments that they are in Python.

#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "pybind_module.h"

namespace binding {
namespace {

std::string keyword_of(const std::string& option) {
  for (const traj::LimitKind& kind : traj::kLimitKinds) {
    if (option == kind.option) return fmt::format("limits[\"{}\"]", kind.name);
  }
  std::string out = option.substr(2);
  std::replace(out.begin(), out.end(), '-', '_');
  return out;
}

}  // namespace

std::string in_python(std::string_view message) {
  // Commands of other programs stay. A tool's name may stand before its option; a quotation mark
  // does not, as what was found is kept.
  static const std::regex option(
      R"((`[^`]*`|xmllint(?: --[a-z]+)+)|(^|[ (])(?:skyway-[a-z-]+ )?(--[a-z][a-z0-9-]*))");
  std::string out;
  std::string rest(message);
  std::smatch found;
  while (std::regex_search(rest, found, option)) {
    out += found.prefix().str() + found[1].str() + found[2].str();
    if (found[3].matched) out += keyword_of(found[3]);
    rest = found.suffix();
  }
  return out + rest;
}

}  // namespace binding
