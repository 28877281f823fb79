#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <streambuf>
#include <utility>
#include <vector>

#include "cli/answer/exit.h"
#include "destination.h"
#include "files.h"
#include "geom/text/last_end.h"
#include "io_failure.h"
#include "run_files.h"
#include "standard_streams.h"

namespace cli {
namespace {

std::string host() {
  char name[256] = "";
  gethostname(name, sizeof name - 1);
  return name;
}

// One that no other process, here or on another node, writes at the same time.
std::string temporary_name(const std::string& path) {
  return fmt::format("{}.{}.{}.part", path, host(), getpid());
}

std::string folder_of(const std::string& path) {
  const auto folder = std::filesystem::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

// Whether a process of this number runs here.
bool runs(std::string_view number) {
  pid_t process = 0;
  const auto [rest, error] = std::from_chars(number.data(), number.data() + number.size(), process);
  const bool whole = error == std::errc() && rest == number.data() + number.size() && process > 0;
  return !whole || kill(process, 0) == 0 || errno != ESRCH;
}

// Removes what processes of this machine that were killed left beside `path`.
void remove_left_behind(const std::string& path) {
  const std::string head = std::filesystem::path(path).filename().string() + "." + host() + ".";
  constexpr std::string_view kTail = ".part";
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder_of(path), error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(head) || !name.ends_with(kTail)) continue;
    if (name.size() <= head.size() + kTail.size()) continue;
    const auto number =
        std::string_view(name).substr(head.size(), name.size() - head.size() - kTail.size());
    if (!runs(number)) std::remove(entry.path().c_str());
  }
}

// A file without a name in the directory of `path`, which is gone with this process unless it is
// given one, which takes /proc; -1 where there is none of either.
int open_unnamed(const std::string& path) {
  if (access("/proc/self/fd", X_OK) != 0) return -1;
  return ::open(folder_of(path).c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
}

// A file on its way to `path`.
class Replacement : public Unpublished {
 public:
  explicit Replacement(const Destination& to) : path_(to.path), temporary_(temporary_name(path_)) {
    descriptor_ = open_unnamed(path_);
    named_ = descriptor_ < 0;
    if (named_) {
      descriptor_ =
          ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0666);
    }
    if (descriptor_ < 0) {
      named_ = false;
      cannot_write(path_);
    }
    if (to.mode) keep_permissions(*to.mode);
  }

  ~Replacement() override {
    if (descriptor_ >= 0) close(descriptor_);
    if (named_) std::remove(temporary_.c_str());
  }
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;

  int descriptor() const { return descriptor_; }

  void prepare() override {
    if (!named_) name();
    if (close(std::exchange(descriptor_, -1)) != 0) cannot_write(path_);
  }

  void publish() override {
    if (std::rename(temporary_.c_str(), path_.c_str()) != 0) cannot_write(path_);
    named_ = false;
  }

 private:
  void name() {
    std::remove(temporary_.c_str());  // of a process of this number that was killed
    const std::string self = fmt::format("/proc/self/fd/{}", descriptor_);
    if (linkat(AT_FDCWD, self.c_str(), AT_FDCWD, temporary_.c_str(), AT_SYMLINK_FOLLOW) != 0) {
      cannot_write(path_);
    }
    named_ = true;
  }

  // Those of the file that is there, and its owner where we may give files away.
  void keep_permissions(mode_t mode) {
    struct stat info {};
    if (geteuid() == 0 && stat(path_.c_str(), &info) == 0 &&
        fchown(descriptor_, info.st_uid, info.st_gid) != 0) {
      return;  // a file system without owners; then its modes say nothing either
    }
    (void)fchmod(descriptor_, mode);
  }

  std::string path_;
  std::string temporary_;
  int descriptor_ = -1;
  bool named_ = false;  // temporary_ is there
};

int open_in_place(const Destination& to, const std::string& path) {
  const int descriptor = to.descriptor >= 0
                             ? fcntl(to.descriptor, F_DUPFD_CLOEXEC, 3)
                             : ::open(to.path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
  if (descriptor < 0) cannot_write(path);
  return descriptor;
}

// Before hours of work, not after them.
void require_writable(int descriptor, const std::string& name) {
  const int flags = fcntl(descriptor, F_GETFL);
  if (flags >= 0 && (flags & O_ACCMODE) != O_RDONLY) return;
  errno = EBADF;
  cannot_write(name);
}

}  // namespace

struct OutputFile::Sink {
  // Writes to a file descriptor, and throws std::system_error with the reason when that fails.
  class Buffer : public std::streambuf {
   public:
    Buffer(int descriptor, std::string name, bool is_stdout)
        : descriptor_(descriptor), name_(std::move(name)), is_stdout_(is_stdout), buffer_(1 << 16) {
      rewind();
    }

    // Writes all that is there but the end of its last line.
    void pass_on() { pass_on(geom::up_to_last_end(held())); }

   private:
    std::string_view held() const { return {pbase(), pptr()}; }
    void rewind() { setp(buffer_.data(), buffer_.data() + buffer_.size()); }

    void pass_on(std::size_t size) {
      const std::string_view rest = held().substr(size);
      write({held().substr(0, size), {}});
      std::copy(rest.begin(), rest.end(), buffer_.data());
      rewind();
      pbump(static_cast<int>(rest.size()));
    }

    int sync() override {
      pass_on(held().size());
      return 0;
    }

    int_type overflow(int_type c) override {
      pass_on();
      if (pptr() == epptr()) sync();  // all of it is the end of a line
      if (!traits_type::eq_int_type(c, traits_type::eof())) {
        *pptr() = traits_type::to_char_type(c);
        pbump(1);
      }
      return traits_type::not_eof(c);
    }

    // A large piece is written as it stands, but for the end of its last line.
    std::streamsize xsputn(const char* text, std::streamsize size) override {
      const std::string_view piece(text, static_cast<std::size_t>(size));
      if (piece.size() < buffer_.size()) return std::streambuf::xsputn(text, size);
      const std::size_t before = piece.size() - buffer_.size();
      const std::size_t end = before + geom::up_to_last_end(piece.substr(before));
      write({held(), piece.substr(0, end)});
      rewind();
      const auto rest = static_cast<std::streamsize>(piece.size() - end);
      return size - rest + std::streambuf::xsputn(text + end, rest);
    }

    void write(std::array<std::string_view, 2> pieces) {
      while (!pieces[0].empty() || !pieces[1].empty()) {
        std::array<iovec, 2> from;
        for (std::size_t i = 0; i < 2; ++i) {
          from[i] = {const_cast<char*>(pieces[i].data()), pieces[i].size()};  // they are read only
        }
        const ssize_t written = ::writev(descriptor_, from.data(), 2);
        if (written < 0 && errno == EPIPE && is_stdout_) end_as_by_sigpipe();
        if (written < 0 && errno != EINTR) cannot_write(name_);
        auto left = static_cast<std::size_t>(std::max<ssize_t>(written, 0));
        for (std::string_view& piece : pieces) {
          const std::size_t n = std::min(left, piece.size());
          piece.remove_prefix(n);
          left -= n;
        }
      }
    }

    int descriptor_;
    std::string name_;
    bool is_stdout_;
    std::vector<char> buffer_;
  };

  Buffer buffer;
  std::ostream stream{&buffer};

  Sink(int descriptor, std::string name, bool is_stdout)
      : buffer(descriptor, std::move(name), is_stdout) {
    stream.exceptions(std::ios::badbit);
  }
};

OutputFile::OutputFile(const std::string& path, OutputKind kind, std::string_view updated) {
  if (RunFiles* const files = RunFiles::current()) files->add_output(path, updated);
  const std::string name = path == "-" ? "stdout" : path;
  const Destination to = destination_of(path);
  int descriptor = STDOUT_FILENO;
  if (!to.in_place) {
    auto replacement = std::make_unique<Replacement>(to);
    descriptor = replacement->descriptor();
    path_ = to.path;
    unpublished_ = std::move(replacement);
  } else if (path != "-") {
    descriptor = in_place_ = open_in_place(to, path);
  }
  require_writable(descriptor, name);
  if (to.in_place && kind == OutputKind::artefact && isatty(descriptor)) {
    throw UsageError("this output is binary and not for a terminal: use -o FILE or a pipe");
  }
  sink_ = std::make_unique<Sink>(descriptor, name, to.descriptor == STDOUT_FILENO);
}

OutputFile::~OutputFile() {
  if (in_place_ >= 0) close(in_place_);
}

std::ostream& OutputFile::stream() { return sink_->stream; }

void OutputFile::flush() { sink_->stream.flush(); }
void OutputFile::pass_on() { sink_->buffer.pass_on(); }

void OutputFile::commit() {
  RunFiles* const files = RunFiles::current();
  if (!files) return commit_now();
  flush();
  if (!path_.empty()) remove_left_behind(path_);
  if (unpublished_) files->add(std::move(unpublished_));
}

void OutputFile::commit_now() {
  flush();
  if (in_place_ >= 0 && close(std::exchange(in_place_, -1)) != 0) cannot_write("an output");
  if (!unpublished_) return;
  unpublished_->prepare();
  unpublished_->publish();
  unpublished_.reset();
}

}  // namespace cli
