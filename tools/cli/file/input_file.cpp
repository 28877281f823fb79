#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <thread>

#include "cli/answer/exit.h"
#include "files.h"
#include "geom/base/file_buffer.h"
#include "geom/base/format.h"
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

void note_stdin(std::string_view first) {
  if (RunFiles* const files = RunFiles::current()) files->note_stdin(first.substr(0, 4096));
}

}  // namespace

struct InputFile::Source {
  geom::FileBuffer buffer;
  std::istream stream{&buffer};

  template <class... From>
  explicit Source(const From&... from) : buffer(from...) {
    stream.exceptions(std::ios::badbit);  // so that what failed is thrown on with its reason
  }
};

InputFile::InputFile(const std::string& path) : name_(path == "-" ? "stdin" : path) {
  note_input(path);
  if (path != "-") {
    source_ = std::make_shared<Source>(path);
    return;
  }
  // One buffer for whoever reads it next.
  static const auto standard = std::make_shared<Source>(STDIN_FILENO, name_, note_stdin);
  source_ = standard;
  if (::isatty(STDIN_FILENO)) fmt::print(stderr, "reads from the terminal; Ctrl-D ends it\n");
}

std::istream& InputFile::stream() { return source_->stream; }

void InputFile::for_each_line(const std::function<void(const std::string&, std::size_t)>& f) {
  geom::for_each_line(stream(), name_, f);
}

std::string InputFile::read_all() { return {std::istreambuf_iterator<char>(stream()), {}}; }

std::string_view InputFile::head_until(const std::function<bool(std::string_view)>& enough) {
  return source_->buffer.head_until(enough, geom::kFormatHead);
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
  const std::string directory = archive.directory_hash();
  geom::BoxMap map = geom::read_box_map(archive, marked(*file, directory));
  if (map.verified() < level) {
    map.require(level, run);
    mark(archive.name(), *file, directory, level, clock_now());
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
