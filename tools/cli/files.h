#pragma once

// Opening what the user named: "-" for the standard streams, and outputs that appear whole or
// not at all.

#include <fstream>
#include <functional>
#include <memory>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include "geom/box_map.h"
#include "geom/execution.h"
#include "geom/io/array_archive.h"

namespace cli {

// A text input. Throws std::system_error when it can't be opened.
class InputFile {
 public:
  explicit InputFile(const std::string& path);
  std::istream& stream();
  const std::string& name() const { return name_; }  // for messages: the path, or "stdin"

  // Calls f(line text, line number) for each line that is not blank; a final newline may be
  // missing. Throws geom::InputError when there was none, or when reading fails.
  void for_each_line(const std::function<void(const std::string&, std::size_t)>& f);

  std::string read_all();

 private:
  std::string name_;
  std::ifstream file_;
  bool is_stdin_;
};

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
// `path`) that takes the place of `path` in commit(); what is not committed is gone, even where the
// process is killed. "-" writes to stdout as it goes. Throws std::system_error on any failure.
class OutputFile {
 public:
  OutputFile(const std::string& path, OutputKind kind);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::ostream& stream();
  void flush();   // so that the next tool of a pipe sees what is there
  void commit();  // call last

 private:
  std::string path_;
  std::string temporary_;  // empty: written in place (stdout, a device, a pipe)
  bool unnamed_ = false;   // temporary_ is not there yet
  int descriptor_ = 1;
  struct Sink;  // a stream onto the descriptor that throws when writing fails
  std::unique_ptr<Sink> sink_;
};

// Refuses (UsageError) more than one input named "-".
void at_most_one_stdin(std::initializer_list<std::string_view> inputs);
void at_most_one_stdin(std::string_view first, std::span<const std::string> others);

}  // namespace cli
