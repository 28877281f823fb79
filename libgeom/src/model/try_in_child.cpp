#include "try_in_child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <stdexcept>
#include <system_error>

namespace geom {
namespace {

// In the child: what the library says as it falls is no message of ours, and a core of no use.
void be_quiet() {
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere >= 0) dup2(nowhere, STDERR_FILENO);
  for (const int signal : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV}) {
    std::signal(signal, SIG_DFL);
  }
}

}  // namespace

void try_in_child(const std::function<void()>& read, const std::string& library,
                  const std::string& source) {
  std::signal(SIGCHLD, SIG_DFL);  // a parent may leave it ignored: then no child can be waited for
  const pid_t child = fork();
  if (child < 0) {
    throw std::system_error(errno, std::generic_category(),
                            "cannot start a process that reads " + source);
  }
  if (child == 0) {
    be_quiet();
    try {
      read();
    } catch (...) {  // the parent reads it again, and hears of it there
    }
    _exit(0);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno == EINTR) continue;
    throw std::system_error(errno, std::generic_category(),
                            "cannot wait for the process that reads " + source);
  }
  if (!WIFSIGNALED(status)) return;
  throw std::runtime_error(
      fmt::format("{}: {} broke down while it read this file ({}): the file is damaged or made to "
                  "deceive, or {} has a fault; write the model as OBJ or glTF by another program",
                  source, library, strsignal(WTERMSIG(status)), library));
}

}  // namespace geom
