#include "geom/base/processes.h"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <deque>
#include <exception>
#include <mutex>
#include <new>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "geom/base/error.h"
#include "geom/base/in_order.h"
#include "geom/base/usage_error.h"

namespace geom {
namespace {

constexpr std::size_t kHeld = 64;  // texts and answers

enum class Outcome : std::uint8_t { result, bad_input, usage, out_of_memory, failed };

struct Message {
  Outcome outcome = Outcome::result;
  std::string text;
};

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

// False where nobody reads any more.
bool write_all(int socket, const char* at, std::size_t size) {
  while (size > 0) {
    const ssize_t n = ::send(socket, at, size, MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 && (errno == EPIPE || errno == ECONNRESET)) return false;
    if (n < 0) fail("worker");
    at += n;
    size -= static_cast<std::size_t>(n);
  }
  return true;
}

// False at the end of the file.
bool read_all(int descriptor, char* at, std::size_t size) {
  while (size > 0) {
    const ssize_t n = ::read(descriptor, at, size);
    if (n < 0 && errno == EINTR) continue;
    if (n == 0 || (n < 0 && errno == ECONNRESET)) return false;
    if (n < 0) fail("worker");
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

using Next = std::function<std::optional<std::string>()>;
using Work = std::function<std::string(const std::string&)>;
using Take = std::function<void(const std::string&)>;

Message run(const Work& work, const std::string& text) {
  try {
    return {Outcome::result, work(text)};
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

bool send(int socket, const Message& message) {
  std::array<char, 9> head;
  const std::uint64_t size = message.text.size();
  head[0] = static_cast<char>(message.outcome);
  std::memcpy(&head[1], &size, sizeof size);
  return write_all(socket, head.data(), head.size()) &&
         write_all(socket, message.text.data(), message.text.size());
}

// Nothing where the other end is gone.
std::optional<Message> receive(int socket) {
  std::array<char, 9> head;
  if (!read_all(socket, head.data(), head.size())) return std::nullopt;
  Message message{static_cast<Outcome>(head[0]), {}};
  std::uint64_t size = 0;
  std::memcpy(&size, &head[1], sizeof size);
  message.text.resize(size);
  if (!read_all(socket, message.text.data(), size)) return std::nullopt;
  return message;
}

// Answers until nobody asks any more.
void serve(int socket, const Work& work) {
  while (const auto asked = receive(socket)) {
    if (!send(socket, run(work, asked->text))) return;
  }
}

class Worker {
 public:
  explicit Worker(const Work& work) {
    std::array<int, 2> ends;
    if (::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) fail("socketpair");
    const pid_t parent = ::getpid();
    std::signal(SIGCHLD, SIG_DFL);  // a parent may leave it ignored: then how it ended is not known
    process_ = ::fork();
    if (process_ < 0) fail("fork");
    if (process_ > 0) {
      ::close(ends[1]);
      socket_ = ends[0];
      return;
    }
    // Whatever happens, the child must not run on into the parent's code, nor outlive it.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(0);
    ::close(ends[0]);
    try {
      serve(ends[1], work);
    } catch (...) {
      ::_exit(1);
    }
    ::_exit(0);
  }
  Worker(Worker&& other) noexcept
      : process_(std::exchange(other.process_, 0)), socket_(std::exchange(other.socket_, -1)) {}
  Worker& operator=(Worker&&) = delete;

  ~Worker() {
    if (socket_ >= 0) ::close(socket_);
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }

  std::string answer(const std::string& text) {
    std::optional<Message> message;
    if (send(socket_, {Outcome::result, text})) message = receive(socket_);
    if (!message) throw std::runtime_error(how_it_ended());
    switch (message->outcome) {
      case Outcome::result:
        return std::move(message->text);
      case Outcome::bad_input:
        throw unpacked_error(message->text);
      case Outcome::usage:
        throw UsageError(message->text);
      case Outcome::out_of_memory:
        throw std::bad_alloc();
      default:
        throw std::runtime_error(message->text);
    }
  }

 private:
  // The socket is closed, so the child has ended or is about to.
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
  int socket_ = -1;
};

// The workers that nobody asks at the moment.
class IdleWorkers {
 public:
  IdleWorkers(std::size_t count, const Work& work) {
    workers_.reserve(count);
    for (std::size_t k = 0; k < count; ++k) workers_.emplace_back(work);
    for (Worker& worker : workers_) idle_.push_back(&worker);
  }

  // For as many threads at once as there are workers.
  std::string answer(const std::string& text) {
    Worker* const worker = take();
    const auto give_back = [&] {
      const std::lock_guard lock(mutex_);
      idle_.push_back(worker);
    };
    try {
      std::string answer = worker->answer(text);
      give_back();
      return answer;
    } catch (...) {
      give_back();
      throw;
    }
  }

 private:
  Worker* take() {
    const std::lock_guard lock(mutex_);
    Worker* const worker = idle_.back();
    idle_.pop_back();
    return worker;
  }

  std::vector<Worker> workers_;
  std::mutex mutex_;
  std::vector<Worker*> idle_;
};

// The first texts of a stream, and then the others. What next() throws is thrown when it is its
// turn.
class Texts {
 public:
  Texts(const Next& next, std::size_t count) : next_(next) {
    while (first_.size() < count && !failure_) {
      try {
        auto text = next();
        if (!text) break;
        first_.push_back(*std::move(text));
      } catch (...) {
        failure_ = std::current_exception();
      }
    }
    ended_ = first_.size() < count;
  }

  std::size_t held() const { return first_.size(); }

  std::optional<std::string> next() {
    if (!first_.empty()) {
      std::string text = std::move(first_.front());
      first_.pop_front();
      return text;
    }
    if (failure_) std::rethrow_exception(failure_);
    return ended_ ? std::nullopt : next_();
  }

 private:
  const Next& next_;
  std::deque<std::string> first_;
  std::exception_ptr failure_;
  bool ended_ = false;
};

}  // namespace

void in_processes(unsigned count, const Next& next, const Work& work, const Take& take) {
  Texts texts(next, count);
  const std::size_t processes = texts.held();
  if (processes <= 1) {
    while (const auto text = texts.next()) take(work(*text));
    return;
  }
  IdleWorkers workers(processes, work);
  in_order<std::string>(
      {.threads = static_cast<unsigned>(processes)}, kHeld, [&] { return texts.next(); },
      [&](std::string& text) { text = workers.answer(text); }, take);
}

}  // namespace geom
