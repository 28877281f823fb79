#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <optional>
#include <streambuf>
#include <thread>
#include <vector>

#include "cli/answer/exit.h"
#include "files.h"
#include "geom/base/error.h"
#include "geom/base/format.h"
#include "geom/base/mapped_file.h"
#include "geom/map/box_map_file.h"
#include "geom/text/record_lines.h"
#include "io_failure.h"
#include "run_files.h"
#include "verified_mark.h"

namespace cli {
namespace {

void note_input(const std::string& path) {
  if (RunFiles* const files = RunFiles::current()) files->add_input(path);
}

}  // namespace

struct InputFile::Source {
  // Reads a file descriptor, and throws std::system_error with the reason when that fails: an input
  // that breaks off never looks like one that ends.
  class Buffer : public std::streambuf {
   public:
    Buffer(int descriptor, std::string name)
        : descriptor_(descriptor),
          name_(std::move(name)),
          opened_(geom::state_of(descriptor)),
          buffer_(1 << 16) {}

    std::string_view head_until(const std::function<bool(std::string_view)>& enough) {
      if (gptr() == nullptr) underflow();
      const auto head = [&] {
        return std::string_view(gptr(), std::min<std::size_t>(geom::kFormatHead, egptr() - gptr()));
      };
      while (!enough(head()) && head().size() < geom::kFormatHead) {
        const std::size_t n = fill(egptr());
        if (n == 0) break;
        setg(eback(), gptr(), egptr() + n);
      }
      return head();
    }

   private:
    int_type underflow() override {
      if (gptr() < egptr()) return traits_type::to_int_type(*gptr());
      const std::size_t n = fill(buffer_.data());
      setg(buffer_.data(), buffer_.data(), buffer_.data() + n);
      if (n == 0) return traits_type::eof();
      note_head();
      return traits_type::to_int_type(*gptr());
    }

    // Reads to a place of the buffer, once; 0 at the end, where what somebody wrote to meanwhile is
    // refused.
    std::size_t fill(char* place) {
      const auto room = static_cast<std::size_t>(buffer_.data() + buffer_.size() - place);
      ssize_t n = -1;
      do {
        n = ::read(descriptor_, place, room);
      } while (n < 0 && errno == EINTR);
      if (n < 0) cannot_read(name_, errno);
      if (n == 0 && opened_) geom::require_unchanged_file(descriptor_, *opened_, name_);
      return static_cast<std::size_t>(n);
    }

    void note_head() {
      RunFiles* const files = RunFiles::current();
      if (!first_ || descriptor_ != STDIN_FILENO || !files) return;
      first_ = false;
      files->note_stdin({eback(), std::min<std::size_t>(4096, egptr() - eback())});
    }

    int descriptor_;
    std::string name_;
    std::optional<geom::FileState> opened_;
    std::vector<char> buffer_;
    bool first_ = true;
  };

  Buffer buffer;
  std::istream stream{&buffer};

  Source(int descriptor, const std::string& name) : buffer(descriptor, name) {
    stream.exceptions(std::ios::badbit);  // so that what failed is thrown on with its reason
  }
};

InputFile::InputFile(const std::string& path) : name_(path == "-" ? "stdin" : path) {
  note_input(path);
  if (path == "-") {
    // One buffer for whoever reads it next.
    static const auto standard = std::make_shared<Source>(STDIN_FILENO, name_);
    source_ = standard;
    if (::isatty(STDIN_FILENO)) fmt::print(stderr, "reads from the terminal; Ctrl-D ends it\n");
    return;
  }
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) cannot_read(path, errno);
  source_ = std::shared_ptr<Source>(new Source(descriptor, path), [descriptor](Source* source) {
    delete source;
    ::close(descriptor);
  });
  struct stat info {};
  if (fstat(descriptor, &info) == 0 && S_ISDIR(info.st_mode)) cannot_read(path, EISDIR);
}

std::istream& InputFile::stream() { return source_->stream; }

void InputFile::for_each_line(const std::function<void(const std::string&, std::size_t)>& f) {
  geom::for_each_line(stream(), name_, f);
}

std::string InputFile::read_all() { return {std::istreambuf_iterator<char>(stream()), {}}; }

std::string_view InputFile::head_until(const std::function<bool(std::string_view)>& enough) {
  return source_->buffer.head_until(enough);
}

std::shared_ptr<std::istream> open_input(const std::string& path) {
  const auto file = std::make_shared<InputFile>(path);
  return {file, &file->stream()};
}

geom::ArrayArchive open_archive(const std::string& path) {
  if (path != "-") {
    if (access(path.c_str(), R_OK) != 0) cannot_read(path, errno);
    note_input(path);
    return geom::ArrayArchive::map(path);
  }
  const std::string text = InputFile(path).read_all();
  return geom::ArrayArchive::from_bytes(std::as_bytes(std::span(text)), "stdin");
}

geom::Execution all_cores() { return {std::max(1u, std::thread::hardware_concurrency()), {}}; }

geom::BoxMap open_map(const std::string& path, geom::Verified level, const geom::Execution& run) {
  return open_map(open_archive(path), level, run);
}

geom::BoxMap open_map(const geom::ArrayArchive& archive, geom::Verified level,
                      const geom::Execution& run) {
  const auto file = archive.file();
  if (!file) {  // it was read from a stream
    geom::BoxMap map = geom::read_box_map(archive);
    map.require(level, run);
    return map;
  }
  geom::BoxMap map = geom::read_box_map(archive, marked(*file));
  if (map.verified() < level) {
    map.require(level, run);
    mark(archive.name(), *file, level, clock_now());
  }
  return map;
}

namespace {

void at_most_one(std::ptrdiff_t count) {
  if (count > 1) throw UsageError("expected at most one input from stdin (\"-\"), found more");
}

}  // namespace

void at_most_one_stdin(std::initializer_list<std::string_view> inputs) {
  at_most_one(std::count(inputs.begin(), inputs.end(), "-"));
}

void at_most_one_stdin(std::string_view first, std::span<const std::string> others) {
  at_most_one((first == "-") + std::count(others.begin(), others.end(), "-"));
}

}  // namespace cli
