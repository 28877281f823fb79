#include "help_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "cli/file/standard_streams.h"
#include "described_option.h"
#include "option_groups.h"
#include "tool_page.h"

namespace cli {
namespace {

constexpr std::size_t kWidth = 100;
constexpr std::size_t kColumn = 30;  // where texts begin

// The text in lines that begin at the column, the first behind `head`.
std::string entry(const std::string& head, const std::string& text) {
  std::string out = "  " + head;
  if (out.size() + 2 > kColumn) {
    out += "\n" + std::string(kColumn, ' ');
  } else {
    out.resize(kColumn, ' ');
  }
  std::size_t column = kColumn;
  for (const std::string& word : CLI::detail::split(text, ' ')) {
    if (column > kColumn && column + 1 + word.size() > kWidth) {
      out += "\n" + std::string(kColumn, ' ');
      column = kColumn;
    }
    if (column > kColumn) {
      out += ' ';
      ++column;
    }
    out += word;
    column += word.size();
  }
  return out + "\n";
}

std::string value_of(const DescribedOption& option) {
  if (option.value.empty()) return "";
  return " " + option.value + (option.repeats ? " ..." : "");
}

std::string head_of(const DescribedOption& option) {
  return fmt::format("{}{}", fmt::join(option.names, ", "), value_of(option));
}

using Options = std::vector<DescribedOption>;

Options of_group(const Options& options, std::string_view group) {
  Options out;
  std::copy_if(options.begin(), options.end(), std::back_inserter(out),
               [&](const DescribedOption& option) { return option.group == group; });
  return out;
}

std::string usage_line(const CLI::App& app, const Options& options) {
  std::string out = "Usage: ";
  if (app.get_parent()) out += app.get_parent()->get_name() + " ";
  out += app.get_name() + " [OPTIONS]";
  if (!app.get_subcommands({}).empty()) out += " VERB ...";
  for (const DescribedOption& argument : of_group(options, "")) {
    const std::string name = argument.names.front() + (argument.repeats ? " ..." : "");
    out += argument.required ? " " + name : " [" + name + "]";
  }
  return out + "\n";
}

// Those that --help shows; its last lines say how to see the others.
Options common_of(const Options& options, const ToolPage& page) {
  if (page.common.empty()) return options;
  Options out;
  std::copy_if(options.begin(), options.end(), std::back_inserter(out),
               [&](const DescribedOption& option) {
                 return option.group.empty() || page.common.contains(option.names.back());
               });
  for (DescribedOption& option : out) {
    if (!option.group.empty()) option.text = option.brief;
  }
  return out;
}

std::string arguments_text(const Options& options) {
  std::string out;
  for (const DescribedOption& argument : of_group(options, "")) {
    out += entry(argument.names.front(), argument.text);
  }
  return out.empty() ? "" : "\n" + out;
}

std::string groups_text(const Options& options) {
  std::string out;
  for (const char* const title : kOptionGroups) {
    const Options group = of_group(options, title);
    if (group.empty()) continue;
    out += fmt::format("{}:\n", title);
    for (const DescribedOption& option : group) out += entry(head_of(option), option.text);
  }
  return out.empty() ? "" : "\n" + out;
}

std::vector<const CLI::App*> verbs_in(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* verb) { return !verb->get_name().empty(); });
}

std::string verbs_text(const CLI::App& app) {
  std::string out;
  for (const CLI::App* verb : verbs_in(app)) {
    out += entry(verb->get_name(), verb->get_description());
  }
  return out.empty() ? "" : "\nVerbs:\n" + out;
}

std::string page_text(const CLI::App& app, bool all) {
  const Options options = described_options(app);
  const ToolPage page = app.get_parent() ? ToolPage{} : page_of_tool(app.get_name());
  const Options shown = all ? options : common_of(options, page);
  std::string out = app.get_description() + "\n" + usage_line(app, options) +
                    arguments_text(shown) + groups_text(shown) + verbs_text(app);
  if (!page.example.empty()) out += "\nExample:\n  " + page.example + "\n";
  if (shown.size() < options.size()) {
    out +=
        fmt::format("All {} options: {} --help-all. The manual: man {}.\n",
                    options.size() - of_group(options, "").size(), app.get_name(), app.get_name());
  }
  return out;
}

class HelpFormatter : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* app, std::string, CLI::AppFormatMode mode) const override {
    const bool all = mode == CLI::AppFormatMode::All;
    std::string out = page_text(*app, all);
    if (!all) return out;
    for (const CLI::App* verb : verbs_in(*app)) out += "\n" + page_text(*verb, true);
    return out;
  }
};

// ---- Markdown

std::string markdown(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("\\`*_{}[]<>#|~^$@").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string markdown_entry(const DescribedOption& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names) names.push_back("**" + markdown(name) + "**");
  return fmt::format("{}{}\n:   {}\n\n", fmt::join(names, ", "), markdown(value_of(option)),
                     markdown(option.text));
}

std::string manual_options(const CLI::App& app, std::string_view marks) {
  const Options options = described_options(app);
  std::string out;
  for (const DescribedOption& argument : of_group(options, "")) out += markdown_entry(argument);
  for (const char* const title : kOptionGroups) {
    const Options group = of_group(options, title);
    if (group.empty()) continue;
    if (!app.get_parent()) out += fmt::format("{} {}\n\n", marks, title);
    for (const DescribedOption& option : group) {
      const bool of_every_verb = app.get_parent() && option.names.back().starts_with("--help");
      if (!of_every_verb) out += markdown_entry(option);
    }
  }
  for (const CLI::App* verb : verbs_in(app)) {
    out += fmt::format("{} {}\n\n{}.\n\n{}", marks, verb->get_name(),
                       markdown(verb->get_description()), manual_options(*verb, marks));
  }
  return out;
}

void set_texts(CLI::App& app, const std::shared_ptr<HelpFormatter>& formatter) {
  app.formatter(formatter);
  app.set_help_flag("-h,--help", "show the options that are used most, and an example");
  app.set_help_all_flag("--help-all", "show all options");
  for (CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    set_texts(*verb, formatter);
  }
}

}  // namespace

std::string manual_options(const CLI::App& app) { return "\n" + manual_options(app, "##"); }

void add_help(CLI::App& app) {
  set_texts(app, std::make_shared<HelpFormatter>());
  app.add_flag_function("--help-man",
                        [&app](std::int64_t) {
                          print(manual_options(app));
                          throw CLI::Success();
                        })
      ->group("");
}

}  // namespace cli
