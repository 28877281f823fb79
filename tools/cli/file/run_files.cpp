#include "run_files.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <filesystem>
#include <system_error>
#include <utility>

#include "cli/answer/exit.h"

namespace cli {
namespace {

namespace fs = std::filesystem;

RunFiles* the_current = nullptr;

// Terminals and /dev/null may be taken twice, and a socket goes both ways.
void add_inode(std::vector<std::string>& keys, const struct stat& info) {
  if (S_ISCHR(info.st_mode) || S_ISSOCK(info.st_mode) || S_ISDIR(info.st_mode)) return;
  keys.push_back(fmt::format("inode {} {}", info.st_dev, info.st_ino));
}

void add_path(std::vector<std::string>& keys, const fs::path& path) {
  std::error_code error;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const fs::path real = fs::canonical(folder, error);
  keys.push_back("path " + (error ? path : real / path.filename()).string());
}

// While it lives, signals that would end this process wait: so all outputs appear, or none, and no
// temporary file stays behind.
class Undisturbed {
 public:
  Undisturbed() {
    sigset_t ends;
    sigemptyset(&ends);
    for (const int signal : {SIGHUP, SIGINT, SIGTERM}) sigaddset(&ends, signal);
    pthread_sigmask(SIG_BLOCK, &ends, &before_);
  }
  ~Undisturbed() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_;
};

std::string output_in_words(const std::string& path) { return path == "-" ? "stdout" : path; }

}  // namespace

RunFiles::RunFiles() {
  assert(!the_current);
  the_current = this;
}

RunFiles::~RunFiles() { the_current = nullptr; }

RunFiles* RunFiles::current() { return the_current; }

RunFiles::Keys RunFiles::keys_of_input(const std::string& path) {
  Keys keys;
  struct stat info {};
  const bool there = path == "-" ? fstat(STDIN_FILENO, &info) == 0 : stat(path.c_str(), &info) == 0;
  if (there) add_inode(keys, info);
  return keys;
}

RunFiles::Keys RunFiles::keys_of_output(const std::string& path) {
  const Destination to = destination_of(path);
  Keys keys;
  struct stat info {};
  const bool there =
      to.descriptor >= 0 ? fstat(to.descriptor, &info) == 0 : stat(to.path.c_str(), &info) == 0;
  if (there) add_inode(keys, info);
  if (to.descriptor >= 0) {
    keys.push_back(fmt::format("descriptor {}", to.descriptor));
  } else if (!to.in_place) {
    add_path(keys, to.path);
  }
  return keys;
}

void RunFiles::refuse_another(const std::string& path, const Keys& keys) const {
  for (const std::string& key : keys) {
    const auto other = outputs_by_key_.find(key);
    if (other == outputs_by_key_.end()) continue;
    if (other->second.expected && other->second.path == path) continue;
    throw UsageError(fmt::format(
        "two outputs go to one file, {}{}: one of them would be lost", output_in_words(path),
        other->second.path == path ? "" : " and " + output_in_words(other->second.path)));
  }
}

void RunFiles::expect_output(const std::string& path, bool main) {
  const Keys keys = keys_of_output(path);
  for (const std::string& key : keys) {
    // Two options of one name expect two outputs, too.
    if (const auto other = outputs_by_key_.find(key); other != outputs_by_key_.end()) {
      other->second.expected = false;
    }
  }
  refuse_another(path, keys);
  for (const std::string& key : keys) outputs_by_key_[key] = {path, true, main};
}

void RunFiles::add_input(const std::string& path) {
  const std::lock_guard lock(mutex_);
  for (const std::string& key : keys_of_input(path)) {
    const auto output = outputs_by_key_.find(key);
    if (output != outputs_by_key_.end() && !(output->second.expected && output->second.main)) {
      throw UsageError(fmt::format("the output {} is the input {}: give it another name",
                                   output_in_words(output->second.path),
                                   path == "-" ? "stdin" : path));
    }
    inputs_by_key_.emplace(key, path);
  }
  inputs_.push_back({path == "-" ? "stdin" : path, ""});
}

void RunFiles::add_output(const std::string& path, std::string_view updated) {
  const std::lock_guard lock(mutex_);
  const Keys keys = keys_of_output(path);
  refuse_another(path, keys);
  for (const std::string& key : keys) {
    const auto input = inputs_by_key_.find(key);
    if (input == inputs_by_key_.end() || input->second == updated) continue;
    throw UsageError(fmt::format("the output {} is the input {}: give it another name",
                                 output_in_words(path),
                                 input->second == "-" ? "stdin" : input->second));
  }
  for (const std::string& key : keys) outputs_by_key_[key] = {path, false, false};
}

void RunFiles::add(std::unique_ptr<Unpublished> output) {
  const std::lock_guard lock(mutex_);
  unpublished_.push_back(std::move(output));
}

void RunFiles::publish() {
  const Undisturbed undisturbed;
  for (const auto& output : unpublished_) output->prepare();
  for (const auto& output : unpublished_) output->publish();
  unpublished_.clear();
}

void RunFiles::note_stdin(std::string_view head) {
  const std::lock_guard lock(mutex_);
  for (Input& input : inputs_) {
    if (input.path == "stdin" && input.head.empty()) input.head = head;
  }
}

}  // namespace cli
