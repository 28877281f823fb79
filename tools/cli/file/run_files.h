#pragma once

// The files of one run of a tool: which they are, that none is taken twice, and the moment in which
// the outputs appear.

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "destination.h"

namespace cli {

// A written file that has not taken its place yet.
class Unpublished {
 public:
  virtual ~Unpublished() = default;  // what was not published is gone
  virtual void prepare() = 0;        // all that can fail for want of space or of permission
  virtual void publish() = 0;        // takes the place; after prepare()
};

// One at a time, from the start of a run to its end. While there is none (in a library's or
// Python's process) nothing is noted, and each output appears as it is committed.
class RunFiles {
 public:
  RunFiles();
  ~RunFiles();
  RunFiles(const RunFiles&) = delete;
  RunFiles& operator=(const RunFiles&) = delete;

  static RunFiles* current();

  // What the options name as outputs, before any work is done: these are not two of them one file,
  // nor an input. `main`: -o, which may update an input; add_output() will tell.
  void expect_output(const std::string& path, bool main);

  // Threads may call the add_ functions at once.
  // Throws UsageError where an output goes there. "-" is stdin.
  void add_input(const std::string& path);
  // Throws UsageError where another output goes there, or where it is an input other than
  // `updated`, which was or will be read whole before the output takes its place.
  void add_output(const std::string& path, std::string_view updated);

  void add(std::unique_ptr<Unpublished> output);
  // Lets all outputs appear, in the order of add(): only when each is whole on its file system.
  void publish();

  // The inputs, as messages name them, and the first bytes of stdin as far as they were read.
  struct Input {
    std::string path;
    std::string head;
  };
  const std::vector<Input>& inputs() const { return inputs_; }
  void note_stdin(std::string_view head);

 private:
  // What tells that two names are one file: where they lead and, where that is there, what is.
  using Keys = std::vector<std::string>;
  static Keys keys_of_input(const std::string& path);
  static Keys keys_of_output(const std::string& path);

  struct Output {
    std::string path;
    bool expected = false;  // and not opened yet
    bool main = false;
  };
  void refuse_another(const std::string& path, const Keys& keys) const;

  std::mutex mutex_;  // guards what follows
  std::vector<Input> inputs_;
  std::map<std::string, std::string> inputs_by_key_;
  std::map<std::string, Output> outputs_by_key_;
  std::vector<std::unique_ptr<Unpublished>> unpublished_;
};

}  // namespace cli
