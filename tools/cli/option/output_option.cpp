#include "output_option.h"

#include <vector>

#include "cli/file/run_files.h"

namespace cli {
namespace {

struct OutputOption {
  const CLI::App* app;
  const CLI::Option* option;
  const std::string* file;
};

// Of the tool that this process is.
std::vector<OutputOption>& output_options() {
  static std::vector<OutputOption> options;
  return options;
}

}  // namespace

CLI::Option* add_output(CLI::App& app, const std::string& flags, std::string& file,
                        const std::string& description) {
  CLI::Option* const option = app.add_option(flags, file, description);
  output_options().push_back({&app, option, &file});
  return option;
}

void expect_outputs(RunFiles& files) {
  for (const auto& [app, option, file] : output_options()) {
    const bool of_other_verb = app->get_parent() && !app->parsed();
    if (of_other_verb) continue;
    if (!file->empty()) files.expect_output(*file, option->check_name("--output"));
  }
}

}  // namespace cli
