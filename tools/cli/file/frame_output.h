#pragma once

// Where frames go: one file, numbered files, or a stream of video.

#include <memory>
#include <string>

#include "cli/file/files.h"

namespace cli {

// "name-%05d.png" with a number in it; a plain name unchanged.
std::string numbered(const std::string& pattern, std::size_t number);
bool is_numbered(const std::string& pattern);

// One kind of picture of each frame. Each numbered file appears whole or not at all; a video and a
// single picture are one file.
class FrameOutput {
 public:
  // An empty name: nothing is wanted. Throws UsageError where several frames have neither numbers
  // in the name nor are a `video`.
  FrameOutput(std::string name, std::size_t frames, bool video);

  bool wanted() const { return !name_.empty(); }
  void begin(const std::string& header);  // of a video
  void write(std::size_t frame, const std::string& bytes);
  void commit();  // call last

 private:
  OutputFile& file(std::size_t frame);

  std::string name_;
  bool each_;  // a file a frame
  std::unique_ptr<OutputFile> file_;
};

}  // namespace cli
