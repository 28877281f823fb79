#include "common.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "cli/file/files.h"
#include "cli/file/standard_streams.h"
#include "geom/text/json_line.h"
#include "output_option.h"

namespace cli {
namespace {

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

bool stats_written = false;

void write_stats_to(const std::string& path, const nlohmann::ordered_json& stats) {
  if (path.empty()) return;
  OutputFile file(path, OutputKind::text);
  file.stream() << stats.dump(2) << '\n';
  file.commit();
  stats_written = true;
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

void write_time(const CLI::App& app, double seconds) {
  const CLI::Option* const asked = app.get_option_no_throw("--stats");
  if (!asked || asked->count() == 0 || stats_written) return;
  write_stats_to(asked->results().front(), {{"seconds", seconds}});
}

}  // namespace cli
