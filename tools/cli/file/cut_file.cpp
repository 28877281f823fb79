#include "cut_file.h"

#include <unistd.h>

#include <array>
#include <csignal>
#include <cstddef>
#include <string_view>

#include "cli/answer/exit.h"
#include "geom/base/mapped_file.h"

namespace cli {
namespace {

const char* name_of_tool = "";

// One write(), so that lines of several threads or processes do not mix. For a signal handler.
class Line {
 public:
  Line& operator<<(std::string_view text) {
    for (const char c : text) {
      if (size_ == text_.size() - 1) break;
      // A file's name reaches a terminal: no control bytes.
      text_[size_++] = static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    }
    return *this;
  }
  void write() {
    text_[size_++] = '\n';
    static_cast<void>(::write(STDERR_FILENO, text_.data(), size_));
  }

 private:
  std::array<char, 1024> text_;
  std::size_t size_ = 0;
};

void on_bus_error(int signal, siginfo_t* info, void*) {
  const char* const path =
      info->si_code == BUS_ADRERR ? geom::mapped_file_at(info->si_addr) : nullptr;
  if (path) {
    Line line;
    line << name_of_tool << ": " << path << " was cut while it was read, or its disk fails";
    line.write();
    // Outputs that are not whole have no name yet, and buffers are not written.
    ::_exit(static_cast<int>(Exit::failed));
  }
  struct sigaction usual {};
  usual.sa_handler = SIG_DFL;
  sigaction(signal, &usual, nullptr);
  raise(signal);
}

}  // namespace

void end_where_a_file_is_cut(const char* tool) {
  name_of_tool = tool;
  struct sigaction action {};
  action.sa_sigaction = on_bus_error;
  action.sa_flags = SA_SIGINFO;
  sigemptyset(&action.sa_mask);
  sigaction(SIGBUS, &action, nullptr);
}

}  // namespace cli
