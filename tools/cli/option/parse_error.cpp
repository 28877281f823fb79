#include "parse_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "geom/text/nearest_word.h"
#include "geom/text/unit_hint.h"

namespace cli {
namespace {

// The first option, in the order in which the parser looks at them.
template <class Is>
CLI::Option* first_option(CLI::App& app, const Is& is) {
  for (CLI::Option* option : app.get_options()) {
    if (is(*option)) return option;
  }
  for (CLI::App* verb : app.get_subcommands()) {
    if (CLI::Option* const option = first_option(*verb, is)) return option;
  }
  return nullptr;
}

// The parser gives each option its values, checks and takes them in turn: so this one is the option
// at which it stopped.
CLI::Option* stopped_at(CLI::App& app) {
  return first_option(app, [](const CLI::Option& option) {
    return option.count() > 0 && !option.get_callback_run();
  });
}

// The last option whose values were taken.
CLI::Option* last_taken(CLI::App& app) {
  CLI::Option* last = nullptr;
  first_option(app, [&](CLI::Option& option) {
    if (option.count() > 0 && option.get_callback_run()) last = &option;
    return false;
  });
  return last;
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
    return geom::did_you_mean(value, CLI::detail::split(*words, ','));
  }
  return geom::unit_hint(value, option.get_description());
}

std::string refused(const CLI::Option& option, const std::string& value) {
  return fmt::format("{}: expected {}, found \"{}\"{}", option.get_name(),
                     expectation(option.get_type_name()), value, meant(option, value));
}

// Whether the option describes what it takes, and this is none of it. Those that do not describe it
// say in their own words what is wrong.
bool refuses(CLI::Option& option, std::string value) {
  for (int i = 0;; ++i) {
    try {
      const CLI::Validator& validator = *option.get_validator(i);
      if (!validator.get_description().empty() && !validator(value).empty()) return true;
    } catch (const CLI::ValidationError&) {  // a word where the validator looks for a number
      return true;
    } catch (const CLI::OptionNotFound&) {  // there are no more validators
      return false;
    }
  }
}

std::optional<std::string> wrong_value(CLI::App& app) {
  CLI::Option* const option = stopped_at(app);
  if (!option) return std::nullopt;
  for (const std::string& value : option->results()) {
    if (refuses(*option, value)) return refused(*option, value);
  }
  return std::nullopt;
}

// Of a value that is no number.
std::optional<std::string> not_converted(CLI::App& app) {
  const CLI::Option* const option = last_taken(app);
  if (!option) return std::nullopt;
  return refused(*option, CLI::detail::join(option->results()));
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
    return fmt::format("there is no option {}{}", name,
                       geom::did_you_mean(name, option_names(app)));
  }
  return std::nullopt;
}

std::string too_few(const CLI::Option& option) {
  const int least = option.get_items_expected_min();
  return fmt::format("{}: expected {}, found {}", option.get_name(), values(least),
                     least == 1 ? "none" : "fewer");
}

// The option that a last word of the command line names, if a value must follow.
const CLI::Option* named_last(CLI::App& app, std::string_view last_word) {
  const std::size_t equals = std::min(last_word.find('='), last_word.size());
  if (equals + 1 < last_word.size()) return nullptr;
  const std::string_view name = last_word.substr(0, equals);
  return first_option(app, [&](const CLI::Option& option) {
    const bool named = name.starts_with("--") ? option.check_lname(std::string(name.substr(2)))
                                              : name.size() > 1 && name.front() == '-' &&
                                                    option.check_sname(std::string(1, name.back()));
    return named && option.get_items_expected_min() > 0;
  });
}

bool is_value(CLI::App& app, std::string_view word) {
  return first_option(app, [&](const CLI::Option& option) {
    return option.count() > 0 && option.results().back() == word;
  });
}

// Of the option at which the parser stopped.
std::optional<std::string> miscounted(CLI::App& app) {
  const CLI::Option* const option = stopped_at(app);
  if (!option) return std::nullopt;
  const int count = static_cast<int>(option->count());
  const int most = option->get_items_expected_max();
  if (count < option->get_items_expected_min()) return too_few(*option);
  if (most == 0 || count <= most) return std::nullopt;  // 0: a flag
  return fmt::format("{}: expected {}, found more: give it once", option->get_name(), values(most));
}

// Of too few or too many values.
std::optional<std::string> wrong_count(CLI::App& app, std::string_view last_word) {
  if (auto unknown = unknown_option(app)) return unknown;  // its value was taken for an argument
  const CLI::Option* const named = named_last(app, last_word);
  if (named && !is_value(app, last_word)) return too_few(*named);
  if (auto fault = miscounted(app)) return fault;
  return named ? std::optional(too_few(*named)) : std::nullopt;
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
                   : fmt::format("\"{}\"{}", left.front(), geom::did_you_mean(left.front(), verbs));
  return fmt::format("expected {}, found {}", alternatives(CLI::detail::join(verbs, ",")), found);
}

// A word that stands where a verb was expected: options of the verb are unknown for it alone.
bool has_wrong_verb(const CLI::App& app) {
  const std::vector<std::string> left = app.remaining();
  return app.get_require_subcommand_min() > app.get_subcommands().size() && !left.empty() &&
         !left.front().starts_with('-');
}

std::optional<std::string> missing_argument(CLI::App& app) {
  if (has_wrong_verb(app)) return missing_verb(app);
  if (auto option = unknown_option(app)) return option;  // explains what is missing
  const CLI::Option* const option = first_option(
      app, [](const CLI::Option& one) { return one.get_required() && one.count() == 0; });
  const bool verb = app.get_require_subcommand_min() > app.get_subcommands().size();
  if (verb && !(option && app.get_option_no_throw(option->get_name()))) return missing_verb(app);
  if (!option) return std::nullopt;
  const std::string name = option->get_name();
  if (!option->get_positional()) return fmt::format("expected the option {}, found none", name);
  return option->get_items_expected_max() > 1
             ? fmt::format("expected at least one argument ({}), found none", name)
             : fmt::format("expected an argument ({}), found none", name);
}

// The other options of the first that was given and goes with them, or without them.
struct Pair {
  std::string option;
  std::string other;
};

std::optional<Pair> pair_of(CLI::App& app, std::set<CLI::Option*> (CLI::Option::*others)() const,
                            bool given) {
  std::optional<Pair> pair;
  first_option(app, [&](const CLI::Option& option) {
    if (option.count() == 0) return false;
    for (const CLI::Option* other : (option.*others)()) {
      if ((other->count() > 0) != given) continue;
      pair = Pair{option.get_name(), other->get_name()};
      return true;
    }
    return false;
  });
  return pair;
}

std::optional<std::string> missing_other(CLI::App& app) {
  const auto pair = pair_of(app, &CLI::Option::get_needs, false);
  if (!pair) return std::nullopt;
  return fmt::format("{} needs {}: give both", pair->option, pair->other);
}

std::optional<std::string> excluded(CLI::App& app) {
  const auto pair = pair_of(app, &CLI::Option::get_excludes, true);
  if (!pair) return std::nullopt;
  return fmt::format("{} and {} exclude each other: give one of them", pair->option, pair->other);
}

// By the class: the name of an ExtrasError is that of the program.
template <class Kind>
bool is(const CLI::ParseError& error) {
  return dynamic_cast<const Kind*>(&error) != nullptr;
}

std::optional<std::string> known(CLI::App& app, const CLI::ParseError& error,
                                 std::string_view last_word) {
  if (is<CLI::ValidationError>(error)) return wrong_value(app);
  if (is<CLI::ConversionError>(error)) return not_converted(app);
  if (is<CLI::ArgumentMismatch>(error)) return wrong_count(app, last_word);
  if (is<CLI::ExtrasError>(error)) return unknown_argument(app);
  if (is<CLI::RequiredError>(error)) return missing_argument(app);
  if (is<CLI::RequiresError>(error)) return missing_other(app);
  if (is<CLI::ExcludesError>(error)) return excluded(app);
  return std::nullopt;
}

}  // namespace

std::string in_words(CLI::App& app, const CLI::ParseError& error, std::string_view last_word) {
  return known(app, error, last_word).value_or(error.what());
}

}  // namespace cli
