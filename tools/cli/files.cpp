#include "files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <streambuf>
#include <system_error>
#include <utility>
#include <vector>

#include "geom/error.h"
#include "geom/io/box_map_file.h"
#include "geom/mapped_file.h"
#include "run.h"

namespace cli {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno ? errno : EIO, std::generic_category(), what);
}

// Writes to a file descriptor, and throws std::system_error with the reason when that fails.
class DescriptorBuffer : public std::streambuf {
 public:
  DescriptorBuffer(int descriptor, std::string name)
      : descriptor_(descriptor), name_(std::move(name)), buffer_(1 << 16) {
    rewind();
  }

 private:
  void rewind() { setp(buffer_.data(), buffer_.data() + buffer_.size()); }

  int sync() override {
    const char* const begin = pbase();
    const char* const end = pptr();
    rewind();
    for (const char* at = begin; at < end;) {
      const ssize_t written = ::write(descriptor_, at, static_cast<std::size_t>(end - at));
      if (written < 0 && errno != EINTR) fail("cannot write " + name_);
      at += std::max<ssize_t>(written, 0);
    }
    return 0;
  }

  int_type overflow(int_type c) override {
    sync();
    if (!traits_type::eq_int_type(c, traits_type::eof())) {
      *pptr() = traits_type::to_char_type(c);
      pbump(1);
    }
    return traits_type::not_eof(c);
  }

  int descriptor_;
  std::string name_;
  std::vector<char> buffer_;
};

// One that no other process, here or on another node, writes at the same time.
std::string temporary_name(const std::string& path) {
  char host[256] = "";
  gethostname(host, sizeof host - 1);
  return fmt::format("{}.{}.{}.part", path, host, getpid());
}

// A file without a name in the directory of `path`, which is gone with this process unless it is
// given one, which takes /proc; -1 where there is none of either.
int open_unnamed(const std::string& path) {
  if (access("/proc/self/fd", X_OK) != 0) return -1;
  const auto folder = std::filesystem::path(path).parent_path();
  return ::open(folder.empty() ? "." : folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
}

bool is_blank(const std::string& line) {
  return line.find_first_not_of(" \t\r") == std::string::npos;
}

}  // namespace

InputFile::InputFile(const std::string& path)
    : name_(path == "-" ? "stdin" : path), is_stdin_(path == "-") {
  if (is_stdin_) return;
  errno = 0;
  file_.open(path, std::ios::binary);
  if (!file_) fail("cannot read " + path);
  struct stat info {};
  if (stat(path.c_str(), &info) == 0 && S_ISDIR(info.st_mode)) {
    errno = EISDIR;
    fail("cannot read " + path);
  }
}

std::istream& InputFile::stream() { return is_stdin_ ? std::cin : file_; }

void InputFile::for_each_line(const std::function<void(const std::string&, std::size_t)>& f) {
  std::string line;
  std::size_t number = 0;
  bool any = false;
  while (std::getline(stream(), line)) {
    ++number;
    if (is_blank(line)) continue;
    if (!any && line.starts_with("PK\x03\x04")) {
      throw geom::InputError(name_,
                             "expected JSON Lines, found an archive (skyway-info says more)");
    }
    any = true;
    f(line, number);
  }
  if (stream().bad()) fail("cannot read " + name_);
  if (!any) throw geom::InputError(name_, "expected at least one record, found an empty stream");
}

std::string InputFile::read_all() {
  std::string text(std::istreambuf_iterator<char>(stream()), {});
  if (stream().bad()) fail("cannot read " + name_);
  return text;
}

geom::ArrayArchive open_archive(const std::string& path) {
  if (path != "-") {
    errno = 0;
    if (access(path.c_str(), R_OK) != 0) fail("cannot read " + path);
    return geom::ArrayArchive::map(path);
  }
  const std::string text = InputFile(path).read_all();
  return geom::ArrayArchive::from_bytes(std::as_bytes(std::span(text)), "stdin");
}

geom::BoxMap open_map(const std::string& path) { return geom::read_box_map(open_archive(path)); }

struct OutputFile::Sink {
  DescriptorBuffer buffer;
  std::ostream stream{&buffer};

  Sink(int descriptor, std::string name) : buffer(descriptor, std::move(name)) {
    stream.exceptions(std::ios::badbit);
  }
};

OutputFile::OutputFile(const std::string& path, OutputKind kind) : path_(path) {
  if (path == "-") {
    if (kind == OutputKind::artefact && isatty(STDOUT_FILENO)) {
      throw UsageError("this output is binary and not for a terminal: use -o FILE or a pipe");
    }
    sink_ = std::make_unique<Sink>(STDOUT_FILENO, "stdout");
    return;
  }
  struct stat info {};
  const bool in_place = stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode);
  if (!in_place) {
    temporary_ = temporary_name(path);
    descriptor_ = open_unnamed(path);
    unnamed_ = descriptor_ >= 0;
  }
  const std::string& name = in_place ? path : temporary_;
  if (!unnamed_) {
    descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  }
  if (descriptor_ < 0) {
    temporary_.clear();
    fail("cannot write " + path);
  }
  sink_ = std::make_unique<Sink>(descriptor_, path);
}

OutputFile::~OutputFile() {
  if (descriptor_ > STDOUT_FILENO) close(descriptor_);
  if (!temporary_.empty() && !unnamed_) std::remove(temporary_.c_str());
}

std::ostream& OutputFile::stream() { return sink_->stream; }

void OutputFile::flush() { sink_->stream.flush(); }

void OutputFile::commit() {
  geom::require_mapped_files_unchanged();  // what is written was made of them
  flush();
  if (temporary_.empty()) return;
  if (unnamed_) {
    std::remove(temporary_.c_str());  // of a process of this number that was killed
    const std::string self = fmt::format("/proc/self/fd/{}", descriptor_);
    if (linkat(AT_FDCWD, self.c_str(), AT_FDCWD, temporary_.c_str(), AT_SYMLINK_FOLLOW) != 0) {
      fail("cannot write " + path_);
    }
    unnamed_ = false;
  }
  if (close(std::exchange(descriptor_, -1)) != 0) fail("cannot write " + path_);
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail("cannot write " + path_);
  temporary_.clear();
}

namespace {

void at_most_one(std::ptrdiff_t count) {
  if (count > 1) throw UsageError("at most one input may be \"-\"");
}

}  // namespace

void at_most_one_stdin(std::initializer_list<std::string_view> inputs) {
  at_most_one(std::count(inputs.begin(), inputs.end(), "-"));
}

void at_most_one_stdin(std::string_view first, std::span<const std::string> others) {
  at_most_one((first == "-") + std::count(others.begin(), others.end(), "-"));
}

}  // namespace cli
