#include "completion.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/answer/exit.h"
#include "cli/file/standard_streams.h"

namespace cli {
namespace {

enum class Takes { nothing, word, number, file };

struct OptionView {
  std::vector<std::string> flags;  // "-o", "--output"; empty: a positional argument
  std::string description;
  Takes takes = Takes::file;
  std::vector<std::string> words;  // of Takes::word
  bool file_too = false;           // or the name of a file instead of a word
  bool repeats = false;
};

// CLI11 names what a value may be by validators: "TEXT:{a,b}"; ours is "TEXT:{a,b}|FILE".
std::vector<std::string> words_of(const std::string& type) {
  const std::size_t begin = type.find('{');
  const std::size_t end = type.find('}', begin);
  if (begin == std::string::npos || end == std::string::npos) return {};
  return CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
}

Takes takes(const CLI::Option& option, const std::vector<std::string>& words) {
  if (!option.get_positional() && option.get_items_expected_max() == 0) return Takes::nothing;
  if (!words.empty()) return Takes::word;
  const std::string type = option.get_type_name();
  const bool number =
      type.starts_with("FLOAT") || type.starts_with("UINT") || type.starts_with("INT");
  return number ? Takes::number : Takes::file;
}

OptionView view(const CLI::Option& option) {
  OptionView out;
  for (const std::string& name : option.get_snames()) out.flags.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.flags.push_back("--" + name);
  out.description = option.get_description();
  out.words = words_of(option.get_type_name());
  out.takes = takes(option, out.words);
  out.file_too = option.get_type_name().ends_with("}|FILE");
  out.repeats = option.get_items_expected_max() > 1;
  return out;
}

std::vector<OptionView> options_of(const CLI::App& app) {
  std::vector<OptionView> out;
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_group().empty()) out.push_back(view(*option));
  }
  return out;
}

std::vector<const CLI::App*> verbs_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* verb) { return !verb->get_name().empty(); });
}

std::string joined(const std::vector<std::string>& words, std::string_view between) {
  return fmt::format("{}", fmt::join(words, between));
}

// The name of a shell function.
std::string function_name(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return "_" + name;
}

// ---- bash

// The cases of a value that follows an option; what no case names completes to files.
std::string bash_values(const std::vector<OptionView>& options) {
  std::string out;
  for (const OptionView& option : options) {
    if (option.flags.empty()) continue;
    const std::string flags = joined(option.flags, "|");
    if (option.takes == Takes::word) {
      out += fmt::format("        {}) COMPREPLY=($(compgen -W '{}' -- \"$word\")); return ;;\n",
                         flags, joined(option.words, " "));
    } else if (option.takes == Takes::number) {
      out += fmt::format("        {}) compopt +o default; return ;;\n", flags);
    } else if (option.takes == Takes::file) {
      out += fmt::format("        {}) return ;;\n", flags);
    }
  }
  return out;
}

// What completes the arguments of a tool, or of one of its verbs.
std::string bash_case(const CLI::App& app, std::string_view pattern) {
  const std::vector<OptionView> options = options_of(app);
  std::vector<std::string> flags;
  std::vector<std::string> first;  // words that may stand where no option does
  for (const OptionView& option : options) {
    flags.insert(flags.end(), option.flags.begin(), option.flags.end());
    if (option.flags.empty()) first.insert(first.end(), option.words.begin(), option.words.end());
  }
  for (const CLI::App* verb : verbs_of(app)) first.push_back(verb->get_name());
  std::string out = fmt::format("    {})\n      case $previous in\n{}      esac\n", pattern,
                                bash_values(options));
  out += fmt::format(
      "      if [[ $word == -* ]]; then COMPREPLY=($(compgen -W '{}' -- \"$word\")); return; fi\n",
      joined(flags, " "));
  if (!first.empty()) {
    out += fmt::format("      COMPREPLY=($(compgen -W '{}' -- \"$word\"))\n", joined(first, " "));
  }
  return out + "      ;;\n";
}

std::string bash(const CLI::App& app) {
  const std::string name = app.get_name();
  const std::string function = function_name(name);
  std::vector<std::string> verbs;
  std::string cases;
  for (const CLI::App* verb : verbs_of(app)) {
    verbs.push_back(verb->get_name());
    cases += bash_case(*verb, verb->get_name());
  }
  std::string out = fmt::format("# bash completion of {}; made by {} --completion bash\n{}() {{\n",
                                name, name, function);
  out += R"(  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} verb= i
  COMPREPLY=()
  if [[ $word == = ]]; then
    word=
  elif [[ $previous == = ]]; then  # --option=value is three words
    previous=${COMP_WORDS[COMP_CWORD-2]}
  fi
)";
  if (!verbs.empty()) {
    out += fmt::format(
        "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
        "    case ${{COMP_WORDS[i]}} in {}) verb=${{COMP_WORDS[i]}}; break ;; esac\n  done\n",
        joined(verbs, "|"));
  }
  out += "  case $verb in\n" + cases + bash_case(app, "*") + "  esac\n}\n";
  return out + fmt::format("complete -o default -F {} {}\n", function, name);
}

// ---- zsh

// Text within single quotes, and within the [] or : of an _arguments specification.
std::string zsh_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'') {
      out += "'\\''";
    } else {
      if (std::string_view("[]:\\").find(c) != std::string_view::npos) out += '\\';
      out += c;
    }
  }
  return out;
}

std::string zsh_value(const OptionView& option) {
  const std::string words = joined(option.words, " ");
  if (option.file_too) return fmt::format(":word or file:{{compadd {}; _files}}", words);
  if (option.takes == Takes::word) return fmt::format(":word:({})", words);
  if (option.takes == Takes::number) return ":number: ";
  return option.takes == Takes::file ? ":file:_files" : "";
}

// The specifications of one option: one for each of its spellings, which exclude each other.
std::string zsh_option(const OptionView& option) {
  std::string out;
  for (const std::string& flag : option.flags) {
    // "--output=" takes "--output x" and "--output=x"; "-o+" takes "-o x" and "-ox".
    const std::string_view form = option.takes == Takes::nothing ? ""
                                  : flag.starts_with("--")       ? "="
                                                                 : "+";
    const std::string others = option.repeats ? "*" : "(" + joined(option.flags, " ") + ")";
    out += fmt::format(" \\\n    '{}{}{}[{}]{}'", others, flag, form, zsh_text(option.description),
                       zsh_value(option));
  }
  return out;
}

std::string zsh_arguments(const CLI::App& app, std::string_view flags) {
  std::string out = fmt::format("  _arguments -s {}", flags);
  for (const OptionView& option : options_of(app)) {
    if (!option.flags.empty()) {
      out += zsh_option(option);
    } else {
      out += fmt::format(" \\\n    '{}{}'", option.repeats ? "*" : ":", zsh_value(option));
    }
  }
  return out;
}

std::string zsh_verb_list(const std::vector<const CLI::App*>& verbs) {
  std::string out;
  for (const CLI::App* verb : verbs) {
    out += fmt::format("      '{}:{}'\n", verb->get_name(), zsh_text(verb->get_description()));
  }
  return out;
}

std::string zsh(const CLI::App& app) {
  const std::string name = app.get_name();
  const std::string function = function_name(name);
  const auto verbs = verbs_of(app);
  std::string out = fmt::format("#compdef {}\n# made by {} --completion zsh\n", name, name);
  for (const CLI::App* verb : verbs) {
    out += fmt::format("{}{}() {{\n{}\n}}\n", function, function_name(verb->get_name()),
                       zsh_arguments(*verb, "-S"));
  }
  out += function + "() {\n";
  if (verbs.empty()) {
    out += zsh_arguments(app, "-S") + "\n";
  } else {
    out += "  local state line curcontext=$curcontext\n  typeset -A opt_args\n" +
           zsh_arguments(app, "-C") + " \\\n    ': :->verb' '*:: :->rest'\n";
    out += fmt::format(R"(  case $state in
    verb)
      local -a verbs=(
{}      )
      _describe verb verbs ;;
    rest)
      local of={}_${{words[1]//-/_}}
      (( $+functions[$of] )) && $of ;;
  esac
)",
                       zsh_verb_list(verbs), function);
  }
  return out + "}\n" + function + " \"$@\"\n";
}

}  // namespace

std::optional<Shell> shell_from(std::string_view word) {
  if (word == "bash") return Shell::bash;
  if (word == "zsh") return Shell::zsh;
  return std::nullopt;
}

std::string completion(const CLI::App& app, Shell shell) {
  return shell == Shell::bash ? bash(app) : zsh(app);
}

std::string completion(const std::string& front,
                       std::span<const std::pair<const char*, const char*>> verbs, Shell shell) {
  if (shell == Shell::zsh) {
    std::string out = fmt::format(
        "#compdef {0}\nif (( CURRENT == 2 )); then\n  local -a verbs=(\n    'help:list the "
        "verbs'\n",
        front);
    for (const auto& [verb, what] : verbs) {
      out += fmt::format("    '{}:{}'\n", verb, zsh_text(what));
    }
    return out + fmt::format(
                     "  )\n  _describe verb verbs\nelse\n  shift words\n  (( CURRENT-- ))\n"
                     "  words[1]={}-$words[1]\n  _normal\nfi\n",
                     front);
  }
  std::string words = "help";
  for (const auto& [verb, what] : verbs) words += std::string(" ") + verb;
  return fmt::format(R"(# bash completion of {0}; made by {0} --completion bash
_{0}() {{
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    COMPREPLY=($(compgen -W '{1}' -- "${{COMP_WORDS[1]}}"))
    return
  fi
  local tool={0}-${{COMP_WORDS[1]}}
  local of=_${{tool//-/_}}
  if ! declare -F "$of" > /dev/null; then  # the tool itself knows
    type -P "$tool" > /dev/null && source <("$tool" --completion bash)
  fi
  COMP_WORDS=("$tool" "${{COMP_WORDS[@]:2}}")
  ((COMP_CWORD--))
  declare -F "$of" > /dev/null && "$of"
}}
complete -o default -F _{0} {0}
)",
                     front, words);
}

void add_completion(CLI::App& app) {
  app.add_option_function<std::string>("--completion",
                                       [&app](const std::string& word) {
                                         const auto shell = shell_from(word);
                                         if (!shell)
                                           throw UsageError("--completion: expected bash or zsh");
                                         const std::string script = completion(app, *shell);
                                         print(script);
                                         throw CLI::Success();
                                       })
      ->group("");
}

}  // namespace cli
