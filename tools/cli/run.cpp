#include "run.h"

#include <errno.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <new>

#include "cli/file/cut_file.h"
#include "cli/file/missing_file.h"
#include "cli/file/run_files.h"
#include "cli/file/standard_streams.h"
#include "cli/file/wrong_file.h"
#include "cli/help/help_page.h"
#include "cli/option/completion.h"
#include "cli/option/option_check.h"
#include "cli/option/output_option.h"
#include "cli/option/parse_error.h"
#include "geom/base/error.h"
#include "geom/base/file_error.h"
#include "geom/base/mapped_file.h"
#include "geom/base/text_stream.h"

namespace cli {
namespace {

[[noreturn]] void end_without_memory() {
  say(program_invocation_short_name);
  say(": out of memory\n");
  _exit(static_cast<int>(Exit::failed));
}

// Memory may run out before run_tool() catches: while a tool makes its options, or before main().
// The exception itself takes memory. If there is none for it, there is no exception.
[[noreturn]] void end_without_catch() {
  constexpr std::size_t kException = 256;  // bytes: more than one takes
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
    if (!std::malloc(kException)) end_without_memory();
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (...) {
  }
  __gnu_cxx::__verbose_terminate_handler();
  std::abort();
}

// Before the other objects of the program are made.
[[gnu::constructor(101)]] void catch_from_the_start() { std::set_terminate(end_without_catch); }

// A message is one line, however the names in it are spelt.
int fail(const CLI::App& app, Exit code, std::string_view message) {
  say(fmt::format("{}: {}\n", app.get_name(), shown_message(message)));
  return static_cast<int>(code);
}

int usage(const CLI::App& app, std::string_view message) {
  const int code = fail(app, Exit::usage, message);
  say(fmt::format("Try '{} --help'.\n", app.get_name()));
  return code;
}

// What --help, --version and --completion print.
int answer(CLI::App& app, const CLI::Success& asked) {
  geom::TextOutput text;
  app.exit(asked, text, text);
  print(text.str());
  return static_cast<int>(Exit::yes);
}

Exit run(const CLI::App& app, const std::function<Exit()>& body) {
  const auto begin = std::chrono::steady_clock::now();
  RunFiles& files = *RunFiles::current();
  expect_outputs(files);
  const Exit exit = body();
  geom::require_mapped_files_unchanged();  // what is written was made of them
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  write_time(app, taken.count());
  files.publish();
  return exit;
}

// Runs `body`, and says what went wrong. `last_word`: of the command line.
int guarded(CLI::App& app, std::string_view last_word, const std::function<int()>& body) {
  try {
    return body();
  } catch (const geom::UsageError& error) {
    return usage(app, error.what());
  } catch (const CLI::ParseError& error) {
    return usage(app, in_words(app, error, last_word));
  } catch (const geom::InputError& error) {
    return fail(app, Exit::bad_input, wrong_file(app, error.source()).value_or(error.what()));
  } catch (const std::bad_alloc&) {
    return fail(app, Exit::failed, "out of memory");
  } catch (const geom::FileError& error) {
    return fail(app, Exit::failed, error.what() + missing_file_advice(error));
  } catch (const std::exception& error) {
    return fail(app, Exit::failed, error.what());
  }
}

}  // namespace

void complain(std::string_view tool, std::string_view message) {
  say(fmt::format("{}: {}\n", tool, shown_message(message)));
}

int run_tool(CLI::App& app, int argc, char** argv, const std::function<Exit()>& body) {
  prepare_standard_streams();
  static const std::string name = app.get_name();
  end_where_a_file_is_cut(name.c_str());
  app.set_version_flag("--version", app.get_name() + " " SKYWAY_VERSION, "print the version");
  add_completion(app);
  add_help(app);
  RunFiles files;
  return guarded(app, argc > 1 ? argv[argc - 1] : "", [&] {
    try {
      app.parse(argc, argv);
      check_values(app);
    } catch (const CLI::Success& asked) {
      return answer(app, asked);
    }
    return static_cast<int>(run(app, body));
  });
}

}  // namespace cli
