#include "standard_streams.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "geom/text/excerpt.h"
#include "io_failure.h"

namespace cli {
namespace {

bool prepared = false;

void ignore(int) {}

// Where closed: opened so that what a tool would do with it fails, be there a /dev/null or not.
void hold(int descriptor, int mode) {
  if (fcntl(descriptor, F_GETFD) >= 0) return;
  // The lowest free number, which is this one: those below are taken already.
  if (::open("/dev/null", mode) < 0) (void)::open("/", O_RDONLY | O_DIRECTORY);
}

}  // namespace

void prepare_standard_streams() {
  hold(STDIN_FILENO, O_WRONLY);
  hold(STDOUT_FILENO, O_RDONLY);
  hold(STDERR_FILENO, O_WRONLY);
  // A handler, and not SIG_IGN, which the programs that we start would inherit.
  struct sigaction action {};
  action.sa_handler = ignore;
  action.sa_flags = SA_RESTART;
  sigaction(SIGPIPE, &action, nullptr);
  sigaction(SIGXFSZ, &action, nullptr);
  prepared = true;
}

void end_as_by_sigpipe() {
  if (!prepared) return;
  signal(SIGPIPE, SIG_DFL);
  raise(SIGPIPE);
}

bool takes_colour(int descriptor) {
  const char* const no = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  if ((no && *no) || !terminal || std::string_view(terminal) == "dumb") return false;
  return isatty(descriptor) != 0;
}

std::string shown_message(std::string_view message) {
  constexpr std::size_t kLongest = 2000;  // bytes
  return geom::excerpt(message, kLongest);
}

void say(std::string_view text) noexcept {
  while (!text.empty()) {
    const ssize_t n = ::write(STDERR_FILENO, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
}

void print(std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(STDOUT_FILENO, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 && errno == EPIPE) end_as_by_sigpipe();
    if (n < 0) cannot_write("stdout");
    text.remove_prefix(static_cast<std::size_t>(n));
  }
}

}  // namespace cli
