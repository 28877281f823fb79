#pragma once

// What the help text of a tool shows first.

#include <set>
#include <string>
#include <string_view>

namespace cli {

struct ToolPage {
  std::string example;  // a command that runs beside the folder `data`; empty: unknown tool
  std::set<std::string> common;  // the options that --help shows; empty: all of them
};

ToolPage page_of_tool(std::string_view tool);

}  // namespace cli
