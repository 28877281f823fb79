#include "run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <new>
#include <sstream>
#include <system_error>
#include <thread>

#include "cli/file/cut_file.h"
#include "cli/file/files.h"
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
#include "geom/base/mapped_file.h"
#include "geom/text/excerpt.h"
#include "geom/text/json_line.h"

namespace cli {
namespace {

constexpr std::size_t kLongestMessage = 2000;  // bytes

// As it may reach a terminal: no file can write its own lines there, or steer it.
std::string shown_message(std::string_view message) {
  return geom::excerpt(message, kLongestMessage);
}

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

// One line on stderr, drawn anew at most ten times a second.
class ProgressLine {
 public:
  ProgressLine(std::string label, bool json) : label_(std::move(label)), json_(json) {}

  void operator()(std::size_t done, std::size_t total) {
    const auto now = std::chrono::steady_clock::now();
    if (done < total && now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    if (json_) {
      say(geom::JsonLine().add("progress", label_).add("done", done).add("total", total).line());
    } else {
      say(fmt::format("\r{} {}/{}{}", label_, done, total, done == total ? "\n" : ""));
    }
  }

 private:
  std::string label_;
  bool json_;
  std::chrono::steady_clock::time_point last_{};
};

// What --help, --version and --completion print.
int answer(CLI::App& app, const CLI::Success& asked) {
  std::ostringstream text;
  app.exit(asked, text, text);
  print(text.str());
  return static_cast<int>(Exit::yes);
}

bool stats_written = false;

void write_stats_to(const std::string& path, const nlohmann::ordered_json& stats) {
  if (path.empty()) return;
  OutputFile file(path, OutputKind::text);
  file.stream() << stats.dump(2) << '\n';
  file.commit();
  stats_written = true;
}

// Of a tool that has nothing to count.
void write_time(const CLI::App& app, std::chrono::steady_clock::time_point begin) {
  const CLI::Option* const asked = app.get_option_no_throw("--stats");
  if (!asked || asked->count() == 0 || stats_written) return;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  write_stats_to(asked->results().front(), {{"seconds", seconds.count()}});
}

Exit run(const CLI::App& app, const std::function<Exit()>& body) {
  const auto begin = std::chrono::steady_clock::now();
  RunFiles& files = *RunFiles::current();
  expect_outputs(files);
  const Exit exit = body();
  geom::require_mapped_files_unchanged();  // what is written was made of them
  write_time(app, begin);
  files.publish();
  return exit;
}

// Runs `body`, and says what went wrong.
int guarded(CLI::App& app, const std::function<int()>& body) {
  try {
    return body();
  } catch (const UsageError& error) {
    return usage(app, error.what());
  } catch (const CLI::ParseError& error) {
    return usage(app, in_words(app, error));
  } catch (const geom::InputError& error) {
    return fail(app, Exit::bad_input, wrong_file(app, error.what()).value_or(error.what()));
  } catch (const std::bad_alloc&) {
    return fail(app, Exit::failed, "out of memory");
  } catch (const std::system_error& error) {
    return fail(app, Exit::failed, error.what() + missing_file_advice(error));
  } catch (const std::exception& error) {
    return fail(app, Exit::failed, error.what());
  }
}

}  // namespace

Common::Common(CLI::App& app, bool with_threads) : tool_(app.get_name()) {
  if (with_threads) {
    app.add_option("--threads", threads_, "worker threads; changes the time only (default: all)")
        ->check(CLI::Range(1u, 1024u));
  }
  app.add_option("--progress", progress_, "progress on stderr: auto, none, bar or json")
      ->check(CLI::IsMember({"auto", "none", "bar", "json"}));
  add_output(app, "--stats", stats_, "write counts and times to this JSON file");
  app.add_flag("-q,--quiet", quiet_, "no warnings and no progress");
}

geom::Execution Common::execution(std::string label) const {
  geom::Execution run;
  run.threads = threads_ ? threads_ : std::max(1u, std::thread::hardware_concurrency());
  const bool bar = progress_ == "bar" || (progress_ == "auto" && isatty(STDERR_FILENO));
  if (!quiet_ && (bar || progress_ == "json")) {
    run.progress = ProgressLine(std::move(label), progress_ == "json");
  }
  return run;
}

void Common::warn(const std::string& message) const {
  if (!quiet_) say(fmt::format("{}: warning: {}\n", tool_, shown_message(message)));
}

void Common::note(const std::string& text) const {
  if (!quiet_) say(text);
}

void Common::write_stats(nlohmann::ordered_json stats) const { write_stats_to(stats_, stats); }

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
  return guarded(app, [&] {
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
