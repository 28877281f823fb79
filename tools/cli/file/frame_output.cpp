#include "frame_output.h"

#include <fmt/format.h>

#include <optional>

#include "cli/answer/exit.h"

namespace cli {
namespace {

struct Place {
  std::size_t first;
  std::size_t length;
  std::size_t digits;
};

// Of %d or %0Nd, N from 1 to 9.
std::optional<Place> number_in(const std::string& pattern) {
  const std::size_t at = pattern.find('%');
  if (at == std::string::npos) return std::nullopt;
  if (pattern.compare(at, 2, "%d") == 0) return Place{at, 2, 1};
  if (at + 3 < pattern.size() && pattern[at + 1] == '0' && pattern[at + 2] >= '1' &&
      pattern[at + 2] <= '9' && pattern[at + 3] == 'd') {
    return Place{at, 4, static_cast<std::size_t>(pattern[at + 2] - '0')};
  }
  return std::nullopt;
}

}  // namespace

bool is_numbered(const std::string& pattern) { return number_in(pattern).has_value(); }

std::string numbered(const std::string& pattern, std::size_t number) {
  const auto place = number_in(pattern);
  if (!place) return pattern;
  return pattern.substr(0, place->first) + fmt::format("{:0{}}", number, place->digits) +
         pattern.substr(place->first + place->length);
}

FrameOutput::FrameOutput(std::string name, std::size_t frames, bool video)
    : name_(std::move(name)), each_(!video && is_numbered(name_)) {
  if (wanted() && frames > 1 && !video && !each_) {
    throw UsageError(
        fmt::format("expected a name with a number for {} frames, as \"frame-%05d.png\", found "
                    "\"{}\"; or draw one frame with --at SECONDS",
                    frames, name_));
  }
}

OutputFile& FrameOutput::file(std::size_t frame) {
  if (!file_) {
    file_ =
        std::make_unique<OutputFile>(each_ ? numbered(name_, frame) : name_, OutputKind::artefact);
  }
  return *file_;
}

void FrameOutput::begin(const std::string& header) {
  if (wanted()) file(0).stream() << header;
}

void FrameOutput::write(std::size_t frame, const std::string& bytes) {
  if (!wanted()) return;
  file(frame).stream() << bytes;
  if (!each_) return;
  file_->commit_now();
  file_.reset();
}

void FrameOutput::commit() {
  if (!file_) return;
  file_->commit();
  file_.reset();
}

}  // namespace cli
