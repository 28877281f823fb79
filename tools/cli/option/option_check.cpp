#include "option_check.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "cli/answer/exit.h"

namespace cli {

void check_values(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    const bool number = option->get_type_name().find("FLOAT") != std::string::npos ||
                        option->get_type_name().find("POSITIVE") != std::string::npos;
    for (const std::string& text : option->results()) {
      if (text.empty()) {
        throw UsageError(option->get_name() + ": expected a value, found an empty one");
      }
      if (number && !std::isfinite(std::strtod(text.c_str(), nullptr))) {
        throw UsageError(
            fmt::format("{}: expected a finite number, found \"{}\"", option->get_name(), text));
      }
    }
  }
  for (const CLI::App* verb : app.get_subcommands()) check_values(*verb);
}

void only_for(const CLI::App& app, bool apply, std::initializer_list<const char*> options,
              std::string_view to_what) {
  if (apply) return;
  for (const char* const name : options) {
    if (app.get_option(name)->count() > 0) {
      throw UsageError(fmt::format(
          "{} is only for {}: it would change nothing here, so leave it out", name, to_what));
    }
  }
}

}  // namespace cli
