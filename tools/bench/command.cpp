#include "command.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <memory>
#include <system_error>

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
  std::vector<std::string>& lines = out.answers.lines;
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
      lines.push_back(std::move(line));
      if (run.progress && lines.size() < expected) run.progress(lines.size(), expected);
    }
    line.clear();
  }
  rusage used{};
  int status = 0;
  if (wait4(child.id, &status, 0, &used) < 0) refuse("cannot wait for the planner");
  out.answers.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (run.progress) run.progress(expected, expected);
  out.answers.peak_rss = static_cast<std::size_t>(used.ru_maxrss) * 1024;
  out.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return out;
}

}  // namespace bench
