#include "described_option.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "option_groups.h"

namespace cli {
namespace {

constexpr double kLargestShownRange = 360;  // ranges up to more than that only stop slips
constexpr std::size_t kLine = 68;           // characters of a text beside the names

std::string upper_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return text;
}

// "MAP FILE" of the argument "map_and_file".
std::string argument_name(const CLI::Option& option) {
  return upper_case(CLI::detail::find_and_replace(option.get_name(true, false), "_and_", " "));
}

bool is_flag(const CLI::Option& option) { return option.get_items_expected_max() == 0; }

bool is_plain_type(std::string_view type) {
  return type.starts_with("TEXT") || type.starts_with("FLOAT") || type.starts_with("UINT") ||
         type.starts_with("INT") || type.starts_with("POSITIVE");
}

// The parser's types are for programmers: "FLOAT:FLOAT in [0 - 1]".
std::string value_word(const CLI::Option& option, const std::string& word) {
  if (is_flag(option)) return "";
  const std::string type = option.get_type_name();
  if (type.starts_with("TEXT:{")) return type.ends_with("}|FILE") ? "WORD|FILE" : "WORD";
  if (!is_plain_type(type)) return type.substr(0, type.find(':'));
  if (!word.empty()) return word;
  if (type.starts_with("TEXT")) return "FILE";
  return type.starts_with("FLOAT") || type.starts_with("POSITIVE") ? "NUMBER" : "COUNT";
}

// The words of "TEXT:{a,b}" where the description leaves some of them out.
std::string words_left_out(const std::string& type, const std::string& description) {
  const std::size_t begin = type.find('{');
  const std::size_t end = type.find('}', begin);
  if (begin == std::string::npos || end == std::string::npos) return "";
  const auto words = CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
  const bool all = std::all_of(words.begin(), words.end(), [&](const std::string& word) {
    return description.find(word) != std::string::npos;
  });
  return all ? "" : fmt::format("; one of {}", fmt::join(words, ", "));
}

// The range of "FLOAT:FLOAT in [0 - 1]" where somebody may come near its ends.
std::string shown_range(const std::string& type) {
  const std::size_t begin = type.find(" in [");
  const std::size_t dash = type.find(" - ", begin);
  if (begin == std::string::npos || dash == std::string::npos) return "";
  const double least = std::strtod(type.c_str() + begin + 5, nullptr);
  const double most = std::strtod(type.c_str() + dash + 3, nullptr);
  if (most > kLargestShownRange) return "";
  if (least > 0 && least < 1e-3) return fmt::format("; at most {}", most);
  return fmt::format("; from {} to {}", least, most);
}

std::string shown_default(const CLI::Option& option, const std::string& description) {
  const std::string value = option.get_default_str();
  if (value.empty() || description.find("default") != std::string::npos) return "";
  return fmt::format(" (default {})", value);
}

std::string names_of(const std::set<CLI::Option*>& options, const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {  // a set has the order of addresses
    if (options.contains(const_cast<CLI::Option*>(option))) names.push_back(option->get_name());
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string described_text(const CLI::Option& option, const CLI::App& app) {
  const std::string& description = option.get_description();
  const std::string type = option.get_type_name();
  std::string text = description + words_left_out(type, description) + shown_range(type) +
                     shown_default(option, description);
  if (option.get_required() && !option.get_positional()) text += "; must be given";
  if (!option.get_needs().empty()) text += "; needs " + names_of(option.get_needs(), app);
  if (!option.get_excludes().empty()) text += "; not with " + names_of(option.get_excludes(), app);
  return text;
}

// Without a remark in brackets at its end, where that is too long or was cut.
std::string without_remark(std::string text) {
  const std::size_t open = text.rfind(" (");
  if (open == std::string::npos) return text;
  const bool cut = text.find(')', open) == std::string::npos;
  if (cut || (text.size() > kLine && text.ends_with(')'))) text.resize(open);
  return text;
}

// The first clause, and the words where there is room for them.
std::string brief_text(const CLI::Option& option) {
  constexpr std::size_t kShortest = 15;  // of what may stand before a mark
  std::string text = option.get_description();
  text.resize(std::min(text.size(), text.find("; ")));
  text = without_remark(text);
  const auto cut = [&](const char* mark, std::size_t room) {
    const std::size_t at = text.find(mark, kShortest);
    if (text.size() > room && at != std::string::npos) text.resize(at);
  };
  cut(": ", 2 * kLine);
  cut(", which ", kLine);
  const std::string words = words_left_out(option.get_type_name(), text);
  if (text.size() + words.size() <= 2 * kLine) text += words;
  if (option.get_required() && !option.get_positional()) text += "; must be given";
  return text;
}

std::vector<std::string> described_flags(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

std::string tool_of(const CLI::App& app) {
  return app.get_parent() ? app.get_parent()->get_name() : app.get_name();
}

// What arguments and options have in common.
DescribedOption described(const CLI::Option& option, const CLI::App& app) {
  DescribedOption out;
  out.text = described_text(option, app);
  out.brief = brief_text(option);
  out.required = option.get_required();
  out.repeats = option.get_items_expected_max() > 1 && option.get_type_size_max() == 1;
  return out;
}

DescribedOption described_argument(const CLI::Option& option, const CLI::App& app) {
  DescribedOption out = described(option, app);
  out.names = {argument_name(option)};
  return out;
}

DescribedOption described_flagged(const CLI::Option& option, const CLI::App& app) {
  DescribedOption out = described(option, app);
  out.names = described_flags(option);
  const bool is_long = !option.get_lnames().empty();
  const OptionPlace place = place_of_option(
      tool_of(app), is_long ? "--" + option.get_lnames().front() : out.names.front());
  out.group = place.group;
  out.value = value_word(option, place.word);
  return out;
}

}  // namespace

std::vector<DescribedOption> described_options(const CLI::App& app) {
  std::vector<DescribedOption> out;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    if (option->get_positional()) out.push_back(described_argument(*option, app));
    if (option->nonpositional()) out.push_back(described_flagged(*option, app));  // or both
  }
  return out;
}

}  // namespace cli
