#pragma once

// Opening what the user named: "-" for the standard streams, and outputs that appear whole or
// not at all.

#include <functional>
#include <istream>
#include <memory>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include "geom/archive/array_archive.h"
#include "geom/base/execution.h"
#include "geom/map/box_map.h"

namespace cli {

class Unpublished;

// A text input. Throws std::system_error when it can't be opened, and wherever reading it fails:
// an input that breaks off never looks like one that ends.
class InputFile {
 public:
  explicit InputFile(const std::string& path);
  std::istream& stream();
  const std::string& name() const { return name_; }  // for messages: the path, or "stdin"

  // Calls f(line text, line number) for each line that is not blank; a final newline may be
  // missing. Throws geom::InputError when there was none.
  void for_each_line(const std::function<void(const std::string&, std::size_t)>& f);

  std::string read_all();

  // The beginning, which stays to be read: more of it is waited for until `enough` says so, up to
  // geom::kFormatHead bytes or its end. Only before anything else was read.
  std::string_view head_until(const std::function<bool(std::string_view)>& enough);

 private:
  struct Source;  // a stream from a descriptor
  std::string name_;
  std::shared_ptr<Source> source_;  // all of stdin have the same
};

// A file that a reader asks for, as the inputs of the run that it is (geom::OpenFile).
std::shared_ptr<std::istream> open_input(const std::string& path);

geom::ArrayArchive open_archive(const std::string& path);  // mapped; "-" is read into memory

geom::Execution all_cores();

// A map that was verified so far: held against its file once, and not again while the file stays as
// it is (verified_mark.h).
geom::BoxMap open_map(const std::string& path, geom::Verified level,
                      const geom::Execution& run = all_cores());
geom::BoxMap open_map(const geom::ArrayArchive& archive, geom::Verified level,
                      const geom::Execution& run = all_cores());

enum class OutputKind { text, artefact };  // an artefact is refused where a terminal would get it

// Writes to a file without a name (where the file system has such, else to a temporary one beside
// `path`) that takes the place of `path`, with its permissions, when the run ends well; what is not
// committed is gone, even where the process is killed. Symbolic links are followed and stay. "-",
// devices, pipes and descriptors (/dev/stderr, /dev/fd/3) are written as it goes. Throws
// std::system_error on any failure, and UsageError where the file is another output or an input.
class OutputFile {
 public:
  // `updated`: an input that the output may take the place of, as it was read whole by then.
  OutputFile(const std::string& path, OutputKind kind, std::string_view updated = {});
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::ostream& stream();
  void flush();       // so that whoever waits for an answer sees it
  void pass_on();     // to the next tool of a pipe, but for the end of the last line (last_end.h)
  void commit();      // call last: all outputs of a run appear together, at its end
  void commit_now();  // the same, but it appears at once: one of very many

 private:
  std::string path_;                          // that it will take; empty: written in place
  std::unique_ptr<Unpublished> unpublished_;  // unless written in place
  int in_place_ = -1;                         // ours to close
  struct Sink;  // a stream onto the descriptor that throws when writing fails
  std::unique_ptr<Sink> sink_;
};

// Refuses (UsageError) more than one input named "-".
void at_most_one_stdin(std::initializer_list<std::string_view> inputs);
void at_most_one_stdin(std::string_view first, std::span<const std::string> others);

}  // namespace cli
