#include "traj/mission/formats/mission_formats.h"

#include <algorithm>
#include <utility>

#include "mission/formats/text_head.h"

namespace traj {
namespace {

// What a text that no format knows is taken for, by how it begins: the reader says what is wrong.
constexpr std::pair<std::string_view, const MissionFormat*> kTakenFor[] = {
    {"{", &kQgcPlan}, {"PK", &kDjiWpml}, {"<", &kKml}, {"", &kPathsCsv}};

template <class Wanted>
std::vector<std::string_view> words_where(const Wanted& wanted) {
  std::vector<std::string_view> words;
  for (const MissionFormat* one : kMissionFormats) {
    if (wanted(*one)) words.push_back(one->format.word);
  }
  return words;
}

}  // namespace

const MissionFormat* mission_format_named(std::string_view word) {
  const auto* const found = std::find_if(std::begin(kMissionFormats), std::end(kMissionFormats),
                                         [&](const auto* one) { return one->format.word == word; });
  return found == std::end(kMissionFormats) ? nullptr : *found;
}

const MissionFormat& recognised_mission_format(std::string_view text) {
  const std::string_view head = text.substr(0, geom::kFormatHead);
  for (const MissionFormat* one : kMissionFormats) {
    if (one->format.begins && one->format.begins(head)) return *one;
  }
  for (const MissionFormat* one : kMissionFormats) {
    if (one->may_be && one->may_be(text)) return *one;
  }
  const auto* const taken =
      std::find_if(std::begin(kTakenFor), std::end(kTakenFor),
                   [&](const auto& one) { return text_head(text).starts_with(one.first); });
  return *taken->second;
}

std::vector<std::string_view> mission_words_of(std::string_view reader) {
  return words_where([&](const MissionFormat& one) {
    const auto& tools = one.format.readers;
    return one.read && std::find(tools.begin(), tools.end(), reader) != tools.end();
  });
}

std::vector<std::string_view> written_mission_words() {
  return words_where([](const MissionFormat& one) { return one.write || one.prove; });
}

}  // namespace traj
