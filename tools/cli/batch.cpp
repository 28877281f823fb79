#include "batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "tell.h"

namespace cli {
namespace {

constexpr std::size_t kSaid = 3;  // sentences: of more, the counts say enough

}  // namespace

void Batch::add_failed(std::string_view why, std::string sentence) {
  ++total_;
  ++failed_;
  ++reasons_.try_emplace(std::string(why), 0).first->second;
  if (!sentence.empty() && sentences_.size() < kSaid) sentences_.push_back(std::move(sentence));
}

std::string Batch::text(std::string_view what) const {
  if (failed_ == 0 || total_ < 2) return "";
  std::vector<std::pair<std::string, std::size_t>> reasons(reasons_.begin(), reasons_.end());
  std::stable_sort(reasons.begin(), reasons.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string out = fmt::format("{} of {} {}: ", failed_, total_, what);
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    out += fmt::format("{}{} {}", i == 0 ? "" : ", ", reasons[i].second, reasons[i].first);
  }
  return out;
}

void Batch::tell(const Common& common, std::string_view tool, std::string_view what) const {
  for (const std::string& sentence : sentences_) tell_no(common, tool, sentence);
  const std::string said = text(what);
  if (!said.empty()) cli::tell(common, tool, said);
}

}  // namespace cli
