#include "command.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <map>
#include <memory>
#include <system_error>

#include "geom/text/json_line.h"

namespace bench {
namespace {

[[noreturn]] void refuse(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// A nameless file that holds `text`, at its start.
File holding(const std::string& text) {
  File file(std::tmpfile(), &std::fclose);
  if (!file) refuse("cannot make a temporary file");
  if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() ||
      std::fflush(file.get()) != 0) {
    refuse("cannot write a temporary file");
  }
  std::rewind(file.get());
  return file;
}

// The reading end of the stdout of a new process.
struct Child {
  pid_t id = 0;
  File output;
};

Child start(const std::string& command, std::FILE* input) {
  int ends[2];
  if (pipe(ends) != 0) refuse("cannot make a pipe");
  const pid_t id = fork();
  if (id < 0) refuse("cannot start a process");
  if (id == 0) {
    dup2(fileno(input), STDIN_FILENO);
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  close(ends[1]);
  return {id, File(fdopen(ends[0], "r"), &std::fclose)};
}

}  // namespace

CommandOutput run_command(const std::string& command, const std::string& input,
                          std::size_t expected, const geom::Execution& run) {
  const File queries = holding(input);
  CommandOutput out;
  const auto begin = std::chrono::steady_clock::now();
  const Child child = start(command, queries.get());
  std::string line;
  for (int c = 0; c != EOF;) {
    c = std::getc(child.output.get());
    if (c != '\n' && c != EOF) {
      line += static_cast<char>(c);
      continue;
    }
    if (line.find_first_not_of(" \t\r") != std::string::npos) {
      out.lines.push_back(std::move(line));
      if (run.progress && out.lines.size() < expected) run.progress(out.lines.size(), expected);
    }
    line.clear();
  }
  rusage used{};
  int status = 0;
  if (wait4(child.id, &status, 0, &used) < 0) refuse("cannot wait for the planner");
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (run.progress) run.progress(expected, expected);
  out.peak_rss = static_cast<std::size_t>(used.ru_maxrss) * 1024;
  out.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return out;
}

std::string to_json_lines(const std::vector<geom::PlanQuery>& queries) {
  std::string out;
  for (const geom::PlanQuery& query : queries) {
    out += geom::JsonLine().add("id", query.id).add("from", query.from).add("to", query.to).line();
  }
  return out;
}

plan::bench::Run judge_command(
    const std::string& command, const CommandOutput& output, const geom::CollisionScene& scene,
    const std::vector<geom::PlanQuery>& queries,
    const std::function<void(const geom::PathRecord&, std::size_t line)>& check) {
  plan::bench::Run run;
  run.method = command;
  run.one_process = true;
  run.peak_rss = output.peak_rss;
  std::map<std::string, plan::bench::Answer> answers;
  for (const geom::PlanQuery& query : queries) answers[query.id];
  std::map<std::string, bool> answered;
  for (std::size_t i = 0; i < output.lines.size(); ++i) {
    geom::PathRecord record = geom::parse_path_record(output.lines[i], "planner-cmd", i + 1);
    check(record, i + 1);
    const auto slot = answers.find(record.id);
    if (slot == answers.end() || std::exchange(answered[record.id], true)) {
      ++run.extra;
    } else {
      slot->second = {record.status, std::move(record.points), std::nullopt};
    }
  }
  const double mean = output.seconds / static_cast<double>(queries.size());
  for (const geom::PlanQuery& query : queries) {
    run.trials.push_back(plan::bench::trial_of(scene, query, answers.at(query.id), mean));
  }
  run.missing = queries.size() - (output.lines.size() - run.extra);
  return run;
}

}  // namespace bench
