#include "ending.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/answer/exit.h"

namespace cli {

void require_ending(std::string_view option, const std::string& name,
                    std::initializer_list<std::string_view> endings, std::string_view advice) {
  const std::string ending = std::filesystem::path(name).extension().string();
  if (ending.empty() || std::find(endings.begin(), endings.end(), ending) != endings.end()) return;
  throw UsageError(fmt::format("{}: expected a name that ends in {}, found \"{}\"{}", option,
                               fmt::join(endings, " or "), name, advice));
}

}  // namespace cli
