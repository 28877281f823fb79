#include "parse_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "cli/answer/nearest_word.h"
#include "unit_hint.h"

namespace cli {
namespace {

const CLI::Option* option_named(const CLI::App& app, const std::string& name) {
  if (const CLI::Option* const option = app.get_option_no_throw(name)) return option;
  for (const CLI::App* verb : app.get_subcommands()) {
    if (const CLI::Option* const option = option_named(*verb, name)) return option;
  }
  return nullptr;
}

// What stands between two marks of a text.
std::optional<std::string> between(std::string_view text, std::string_view open,
                                   std::string_view close) {
  const std::size_t begin = text.find(open);
  if (begin == text.npos) return std::nullopt;
  const std::size_t from = begin + open.size();
  const std::size_t end = text.find(close, from);
  if (end == text.npos) return std::nullopt;
  return std::string(text.substr(from, end - from));
}

// "a, b or c" of "a,b,c".
std::string alternatives(const std::string& list) {
  const std::vector<std::string> words = CLI::detail::split(list, ',');
  std::string out = words.front();
  for (std::size_t i = 1; i < words.size(); ++i) {
    out += (i + 1 < words.size() ? ", " : " or ") + words[i];
  }
  return out;
}

// What an option takes, as its type says: "TEXT:{a,b}", "FLOAT:FLOAT in [1 - 2]", "UINT".
std::string expectation(const std::string& type) {
  const bool whole = type.starts_with("UINT") || type.starts_with("INT");
  const std::string number = whole ? "a whole number" : "a number";
  if (const auto words = between(type, "{", "}")) return alternatives(*words);
  if (const auto range = between(type, " in [", "]")) {
    const std::size_t dash = range->find(" - ");
    return fmt::format("{} from {} to {}", number, range->substr(0, dash), range->substr(dash + 3));
  }
  if (type.find("POSITIVE") != type.npos) return number + " > 0";
  return type.starts_with("UINT") ? "a whole number >= 0" : number;
}

// What may have been meant by a value: another word, or a number that has a unit.
std::string meant(const CLI::Option& option, const std::string& value) {
  if (const auto words = between(option.get_type_name(), "{", "}")) {
    return did_you_mean(value, CLI::detail::split(*words, ','));
  }
  return unit_hint(value, option.get_description());
}

std::string refused(const CLI::Option& option, const std::string& name, const std::string& value) {
  return fmt::format("{}: expected {}, found \"{}\"{}", name, expectation(option.get_type_name()),
                     value, meant(option, value));
}

// The value that a validator refused; nothing where the message is the tool's own.
std::optional<std::string> refused_value(const std::string& message, const std::string& name) {
  std::string_view rest(message);
  rest.remove_prefix(std::min(rest.size(), name.size() + 2));  // "name: "
  constexpr std::string_view kValue = "Value ";
  const std::size_t range = rest.rfind(" not in range ");
  const std::size_t words = rest.rfind(" not in {");
  if (rest.ends_with('}') && words != rest.npos) return std::string(rest.substr(0, words));
  if (rest.starts_with(kValue) && range != rest.npos) {
    return std::string(rest.substr(kValue.size(), range - kValue.size()));
  }
  return std::nullopt;
}

std::optional<std::string> wrong_value(const CLI::App& app, const std::string& message) {
  const std::string name = message.substr(0, message.find(": "));
  const CLI::Option* const option = option_named(app, name);
  const auto value = refused_value(message, name);
  if (!option || !value) return std::nullopt;
  return refused(*option, name, *value);
}

// Of a value that is no number.
std::optional<std::string> not_converted(const CLI::App& app, const std::string& message) {
  const auto name = between(message, "Could not convert: ", " = ");
  const CLI::Option* const option = name ? option_named(app, *name) : nullptr;
  if (!option) return std::nullopt;
  return refused(*option, *name, message.substr(message.find(" = ") + 3));
}

std::string values(int count) { return count == 1 ? "a value" : fmt::format("{} values", count); }

// All that --help lists.
std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  for (const CLI::App* verb : app.get_subcommands()) {
    for (std::string& name : option_names(*verb)) names.push_back(std::move(name));
  }
  return names;
}

// An option that is not known, among what was left.
std::optional<std::string> unknown_option(const CLI::App& app) {
  for (const std::string& word : app.remaining(true)) {
    if (!word.starts_with('-') || word == "-") continue;
    const std::string name = word.substr(0, word.find('='));
    return fmt::format("there is no option {}{}", name, did_you_mean(name, option_names(app)));
  }
  return std::nullopt;
}

// Of too few or too many values.
std::optional<std::string> wrong_count(const CLI::App& app, const std::string& message) {
  const std::string name = message.substr(0, message.find(": "));
  const CLI::Option* const option = option_named(app, name);
  if (!option) return std::nullopt;
  if (auto unknown = unknown_option(app)) return unknown;  // its value was taken for an argument
  if (message.find(" missing") != message.npos || message.find("At least ") != message.npos) {
    const int least = option->get_items_expected_min();
    return fmt::format("{}: expected {}, found {}", name, values(least),
                       least == 1 ? "none" : "fewer");
  }
  if (message.find("At Most ") != message.npos) {
    return fmt::format("{}: expected {}, found more: give it once", name,
                       values(option->get_items_expected_max()));
  }
  return std::nullopt;
}

// The first argument that no option or place takes; options before others.
std::optional<std::string> unknown_argument(const CLI::App& app) {
  if (auto option = unknown_option(app)) return option;
  const std::vector<std::string> left = app.remaining(true);
  if (!left.empty()) return fmt::format("expected no more arguments, found \"{}\"", left.front());
  return std::nullopt;
}

std::string missing_verb(const CLI::App& app) {
  std::vector<std::string> verbs;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (!verb->get_name().empty()) verbs.push_back(verb->get_name());
  }
  const std::vector<std::string> left = app.remaining();
  const std::string found =
      left.empty() ? "none"
                   : fmt::format("\"{}\"{}", left.front(), did_you_mean(left.front(), verbs));
  return fmt::format("expected {}, found {}", alternatives(CLI::detail::join(verbs, ",")), found);
}

std::optional<std::string> missing_argument(const CLI::App& app, const std::string& message) {
  if (auto option = unknown_option(app)) return option;  // explains what is missing
  if (message == "A subcommand is required") return missing_verb(app);
  const std::string name = message.substr(0, message.rfind(" is required"));
  const CLI::Option* const option = option_named(app, name);
  if (!option) return std::nullopt;
  if (!option->get_positional()) return fmt::format("expected the option {}, found none", name);
  return option->get_items_expected_max() > 1
             ? fmt::format("expected at least one argument ({}), found none", name)
             : fmt::format("expected an argument ({}), found none", name);
}

// Two options, as the parser names them around a word.
std::optional<std::string> about_two(const std::string& message, std::string_view word,
                                     fmt::format_string<std::string, std::string> words) {
  const std::size_t at = message.find(word);
  if (at == message.npos) return std::nullopt;
  return fmt::format(words, message.substr(0, at), message.substr(at + word.size()));
}

// By the class: the name of an ExtrasError is that of the program.
template <class Kind>
bool is(const CLI::ParseError& error) {
  return dynamic_cast<const Kind*>(&error) != nullptr;
}

std::optional<std::string> known(const CLI::App& app, const CLI::ParseError& error) {
  const std::string message = error.what();
  if (is<CLI::ValidationError>(error)) return wrong_value(app, message);
  if (is<CLI::ConversionError>(error)) return not_converted(app, message);
  if (is<CLI::ArgumentMismatch>(error)) return wrong_count(app, message);
  if (is<CLI::ExtrasError>(error)) return unknown_argument(app);
  if (is<CLI::RequiredError>(error)) return missing_argument(app, message);
  if (is<CLI::RequiresError>(error)) {
    return about_two(message, " requires ", "{} needs {}: give both");
  }
  if (is<CLI::ExcludesError>(error)) {
    return about_two(message, " excludes ", "{} and {} exclude each other: give one of them");
  }
  return std::nullopt;
}

}  // namespace

std::string in_words(const CLI::App& app, const CLI::ParseError& error) {
  return known(app, error).value_or(error.what());
}

}  // namespace cli
