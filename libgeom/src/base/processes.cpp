#include "geom/base/processes.h"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <new>
#include <string_view>
#include <system_error>
#include <vector>

#include "geom/base/error.h"
#include "geom/base/usage_error.h"

namespace geom {
namespace {

enum class Outcome : std::uint8_t { result, bad_input, usage, out_of_memory, failed };

struct Message {
  Outcome outcome = Outcome::result;
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

// Texts one after the other, each after its length.
std::string packed(const geom::InputError& error) {
  const geom::Fault& fault = error.fault();
  std::string out;
  for (const std::string& text :
       {error.source(), std::to_string(error.line()), fault.item, fault.key, fault.says,
        fault.expected, fault.found, fault.advice}) {
    out += std::to_string(text.size()) + ' ' + text;
  }
  return out;
}

geom::InputError unpacked_error(std::string_view bytes) {
  const auto next = [&] {
    std::size_t size = 0;
    const char* const end = std::from_chars(bytes.data(), bytes.data() + bytes.size(), size).ptr;
    bytes.remove_prefix(static_cast<std::size_t>(end - bytes.data()) + 1);
    const std::string text(bytes.substr(0, size));
    bytes.remove_prefix(size);
    return text;
  };
  const std::string source = next();
  const std::size_t line = std::stoul(next());
  return {source, line,
          geom::Fault{.item = next(),
                      .key = next(),
                      .says = next(),
                      .expected = next(),
                      .found = next(),
                      .advice = next()}};
}

Message run(const std::function<std::string(std::size_t)>& work, std::size_t i) {
  try {
    return {Outcome::result, work(i)};
  } catch (const geom::InputError& error) {
    return {Outcome::bad_input, packed(error)};
  } catch (const UsageError& error) {
    return {Outcome::usage, error.what()};
  } catch (const std::bad_alloc&) {
    return {Outcome::out_of_memory, {}};
  } catch (const std::exception& error) {
    return {Outcome::failed, error.what()};
  }
}

void send(int descriptor, const Message& message) {
  std::array<char, 9> head;
  const std::uint64_t size = message.text.size();
  head[0] = static_cast<char>(message.outcome);
  std::memcpy(&head[1], &size, sizeof size);
  write_all(descriptor, head.data(), head.size());
  write_all(descriptor, message.text.data(), message.text.size());
}

class Worker {
 public:
  // The child works on items first, first + step, ...
  Worker(std::size_t first, std::size_t step, std::size_t n,
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
        const Message message = run(work, i);
        send(ends[1], message);
        if (message.outcome != Outcome::result) break;
      }
    } catch (...) {
      ::_exit(1);
    }
    ::_exit(0);
  }
  Worker(Worker&& other) noexcept : process_(other.process_), from_(other.from_) {
    other.process_ = 0;
    other.from_ = -1;
  }
  Worker& operator=(Worker&&) = delete;

  ~Worker() {
    if (from_ >= 0) ::close(from_);
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }

  std::string receive() {
    std::array<char, 9> head;
    Message message;
    std::uint64_t size = 0;
    const bool whole = read_all(from_, head.data(), head.size());
    if (whole) {
      message.outcome = static_cast<Outcome>(head[0]);
      std::memcpy(&size, &head[1], sizeof size);
      message.text.resize(size);
    }
    if (!whole || !read_all(from_, message.text.data(), size)) {
      throw std::runtime_error(how_it_ended());
    }
    switch (message.outcome) {
      case Outcome::result:
        return std::move(message.text);
      case Outcome::bad_input:
        throw unpacked_error(message.text);
      case Outcome::usage:
        throw UsageError(message.text);
      case Outcome::out_of_memory:
        throw std::bad_alloc();
      default:
        throw std::runtime_error(message.text);
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
  std::vector<Worker> children;
  for (std::size_t k = 0; k < processes; ++k) children.emplace_back(k, processes, n, work);
  for (std::size_t i = 0; i < n; ++i) take(i, children[i % processes].receive());
}

}  // namespace geom
