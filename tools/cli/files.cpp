#include "files.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <system_error>

#include "geom/error.h"
#include "geom/io/box_map_file.h"
#include "run.h"

namespace cli {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno ? errno : EIO, std::generic_category(), what);
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

OutputFile::OutputFile(const std::string& path, OutputKind kind) : path_(path) {
  if (path == "-") {
    if (kind == OutputKind::artefact && isatty(STDOUT_FILENO)) {
      throw UsageError("this output is binary and not for a terminal: use -o FILE or a pipe");
    }
    return;
  }
  struct stat info {};
  const bool in_place = stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode);
  if (!in_place) temporary_ = fmt::format("{}.{}.part", path, getpid());
  errno = 0;
  file_.open(in_place ? path : temporary_, std::ios::binary);
  if (!file_) fail("cannot write " + path);
}

OutputFile::~OutputFile() {
  if (temporary_.empty()) return;
  file_.close();
  std::remove(temporary_.c_str());
}

std::ostream& OutputFile::stream() { return path_ == "-" ? std::cout : file_; }

void OutputFile::flush() {
  errno = 0;
  if (!stream().flush()) fail("cannot write " + (path_ == "-" ? "stdout" : path_));
}

void OutputFile::commit() {
  flush();
  if (temporary_.empty()) return;
  file_.close();
  if (!file_) fail("cannot write " + path_);
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail("cannot write " + path_);
  temporary_.clear();
}

void at_most_one_stdin(std::initializer_list<std::string_view> inputs) {
  if (std::count(inputs.begin(), inputs.end(), "-") > 1) {
    throw UsageError("at most one input may be \"-\"");
  }
}

}  // namespace cli
