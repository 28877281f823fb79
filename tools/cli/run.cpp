#include "run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <new>
#include <thread>

#include "completion.h"
#include "cut_file.h"
#include "files.h"
#include "geom/error.h"
#include "geom/mapped_file.h"

namespace cli {
namespace {

int fail(const CLI::App& app, Exit code, std::string_view message) {
  std::fflush(stdout);
  fmt::print(stderr, "{}: {}\n", app.get_name(), message);
  return static_cast<int>(code);
}

int usage(const CLI::App& app, std::string_view message) {
  return fail(app, Exit::usage, fmt::format("{}\nTry '{} --help'.", message, app.get_name()));
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
      fmt::print(stderr,
                 R"({{"progress":"{}","done":{},"total":{}}})"
                 "\n",
                 label_, done, total);
    } else {
      fmt::print(stderr, "\r{} {}/{}{}", label_, done, total, done == total ? "\n" : "");
    }
    std::fflush(stderr);
  }

 private:
  std::string label_;
  bool json_;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace

Common::Common(CLI::App& app, bool with_threads) : tool_(app.get_name()) {
  if (with_threads) {
    app.add_option("--threads", threads_, "worker threads; changes the time only (default: all)")
        ->check(CLI::Range(1u, 1024u));
  }
  app.add_option("--progress", progress_, "progress on stderr: auto, none, bar or json")
      ->check(CLI::IsMember({"auto", "none", "bar", "json"}));
  app.add_option("--stats", stats_, "write counts and times to this JSON file");
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
  if (!quiet_) fmt::print(stderr, "{}: warning: {}\n", tool_, message);
}

void Common::note(const std::string& text) const {
  if (!quiet_) fmt::print(stderr, "{}", text);
}

void Common::write_stats(nlohmann::ordered_json stats) const {
  if (stats_.empty()) return;
  OutputFile file(stats_, OutputKind::text);
  file.stream() << stats.dump(2) << '\n';
  file.commit();
}

int run_tool(CLI::App& app, int argc, char** argv, const std::function<Exit()>& body) {
  std::signal(SIGPIPE, SIG_DFL);
  static const std::string name = app.get_name();
  end_where_a_file_is_cut(name.c_str());
  app.set_version_flag("--version", app.get_name() + " " SKYWAY_VERSION);
  add_completion(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    return usage(app, error.what());
  }
  try {
    const Exit exit = body();
    geom::require_mapped_files_unchanged();
    return static_cast<int>(exit);
  } catch (const UsageError& error) {
    return usage(app, error.what());
  } catch (const geom::InputError& error) {
    return fail(app, Exit::bad_input, error.what());
  } catch (const std::bad_alloc&) {
    return fail(app, Exit::failed, "out of memory");
  } catch (const std::exception& error) {
    return fail(app, Exit::failed, error.what());
  }
}

}  // namespace cli
