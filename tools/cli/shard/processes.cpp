#include "processes.h"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <new>
#include <system_error>
#include <vector>

#include "cli/answer/exit.h"
#include "geom/base/error.h"

namespace cli {
namespace {

enum class Kind : std::uint8_t { result, bad_input, usage, out_of_memory, failed };

struct Frame {
  Kind kind = Kind::result;
  std::string text;
};

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

void write_all(int descriptor, const char* at, std::size_t size) {
  while (size > 0) {
    const ssize_t n = ::write(descriptor, at, size);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail("worker");
    at += n;
    size -= static_cast<std::size_t>(n);
  }
}

// False at the end of the file.
bool read_all(int descriptor, char* at, std::size_t size) {
  while (size > 0) {
    const ssize_t n = ::read(descriptor, at, size);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail("worker");
    if (n == 0) return false;
    at += n;
    size -= static_cast<std::size_t>(n);
  }
  return true;
}

Frame run(const std::function<std::string(std::size_t)>& work, std::size_t i) {
  try {
    return {Kind::result, work(i)};
  } catch (const geom::InputError& error) {
    return {Kind::bad_input, error.what()};
  } catch (const geom::OptionError& error) {
    return {Kind::usage, error.what()};
  } catch (const std::bad_alloc&) {
    return {Kind::out_of_memory, {}};
  } catch (const std::exception& error) {
    return {Kind::failed, error.what()};
  }
}

void send(int descriptor, const Frame& frame) {
  std::array<char, 9> head;
  const std::uint64_t size = frame.text.size();
  head[0] = static_cast<char>(frame.kind);
  std::memcpy(&head[1], &size, sizeof size);
  write_all(descriptor, head.data(), head.size());
  write_all(descriptor, frame.text.data(), frame.text.size());
}

class Child {
 public:
  // The child works on items first, first + step, ...
  Child(std::size_t first, std::size_t step, std::size_t n,
        const std::function<std::string(std::size_t)>& work) {
    std::array<int, 2> ends;
    if (::pipe(ends.data()) != 0) fail("pipe");
    const pid_t parent = ::getpid();
    std::signal(SIGCHLD, SIG_DFL);  // a parent may leave it ignored: then how it ended is not known
    process_ = ::fork();
    if (process_ < 0) fail("fork");
    if (process_ > 0) {
      ::close(ends[1]);
      from_ = ends[0];
      return;
    }
    // Whatever happens, the child must not run on into the parent's code, nor outlive it.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(0);
    ::close(ends[0]);
    try {
      for (std::size_t i = first; i < n; i += step) {
        const Frame frame = run(work, i);
        send(ends[1], frame);
        if (frame.kind != Kind::result) break;
      }
    } catch (...) {
      ::_exit(1);
    }
    ::_exit(0);
  }
  Child(Child&& other) noexcept : process_(other.process_), from_(other.from_) {
    other.process_ = 0;
    other.from_ = -1;
  }
  Child& operator=(Child&&) = delete;

  ~Child() {
    if (from_ >= 0) ::close(from_);
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }

  std::string receive() {
    std::array<char, 9> head;
    Frame frame;
    std::uint64_t size = 0;
    const bool whole = read_all(from_, head.data(), head.size());
    if (whole) {
      frame.kind = static_cast<Kind>(head[0]);
      std::memcpy(&size, &head[1], sizeof size);
      frame.text.resize(size);
    }
    if (!whole || !read_all(from_, frame.text.data(), size)) {
      throw std::runtime_error(how_it_ended());
    }
    switch (frame.kind) {
      case Kind::result:
        return std::move(frame.text);
      case Kind::bad_input: {  // "source: message"
        const std::size_t end = std::min(frame.text.find(": "), frame.text.size() - 2);
        throw geom::InputError(frame.text.substr(0, end), frame.text.substr(end + 2));
      }
      case Kind::usage:
        throw UsageError(frame.text);
      case Kind::out_of_memory:
        throw std::bad_alloc();
      default:
        throw std::runtime_error(frame.text);
    }
  }

 private:
  // The pipe is closed, so the child has ended or is about to.
  std::string how_it_ended() {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = 0;
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) {
      return "a worker process was killed, perhaps for want of memory: fewer --threads need less";
    }
    if (WIFSIGNALED(status)) {
      return fmt::format("a worker process was ended by signal {}", WTERMSIG(status));
    }
    return fmt::format("a worker process ended early (exit {})", WEXITSTATUS(status));
  }

  pid_t process_ = 0;
  int from_ = -1;
};

}  // namespace

void in_processes(std::size_t n, unsigned count,
                  const std::function<std::string(std::size_t)>& work,
                  const std::function<void(std::size_t, const std::string&)>& take) {
  const std::size_t processes = std::min<std::size_t>(n, count);
  if (processes <= 1) {
    for (std::size_t i = 0; i < n; ++i) take(i, work(i));
    return;
  }
  std::vector<Child> children;
  for (std::size_t k = 0; k < processes; ++k) children.emplace_back(k, processes, n, work);
  for (std::size_t i = 0; i < n; ++i) take(i, children[i % processes].receive());
}

}  // namespace cli
