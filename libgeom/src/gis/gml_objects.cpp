#include "gml_objects.h"

#include <fmt/format.h>

#include "gml_words.h"

namespace geom::gis {

GmlObjects::Index GmlObjects::begin(const XmlTag& tag, bool member, bool kept) {
  Entry entry;
  entry.kept = kept;
  entry.object.type = tag.name;
  entry.object.name = tag.attribute("id");
  const Index made = entries_.size();
  if (entry.object.name.empty()) {
    entry.object.name = fmt::format("{} of line {}", tag.name, tag.line);
  } else if (!by_id_.emplace(entry.object.name, made).second) {
    twice_.insert(entry.object.name);
  }
  if (!open_.empty() && !member) entry.within = open_.back();
  open_.push_back(made);
  entries_.push_back(std::move(entry));
  return made;
}

void GmlObjects::end() {
  const Index ended = open_.back();
  open_.pop_back();
  const bool last = ended + 1 == entries_.size();
  if (!last || entries_[ended].kept || entries_[ended].used) return;
  const auto known = by_id_.find(entries_[ended].object.name);  // nothing but data
  if (known != by_id_.end() && known->second == ended) by_id_.erase(known);
  entries_.pop_back();
}

CityObject& GmlObjects::use() {
  entries_[open_.back()].used = true;
  return entries_[open_.back()].object;
}

std::optional<GmlObjects::Index> GmlObjects::find(const std::string& id) const {
  const auto known = by_id_.find(id);
  if (known == by_id_.end() || twice_.contains(id)) return std::nullopt;
  return known->second;
}

GmlObjects::Index GmlObjects::whole_of(Index i) const {
  while (entries_[i].within) i = *entries_[i].within;
  return i;
}

void GmlObjects::join(Index whole, Index part) {
  const std::string& type = entries_[part].object.type;
  if (!kNested.contains(type) && !kInterior.contains(type) && !is_boundary(type)) return;
  joined_.emplace_back(whole, part);
  const bool alone = !entries_[part].within && whole_of(whole) != part;
  if (alone) entries_[part].within = whole;
}

std::vector<CityObject> GmlObjects::settle() {
  std::vector<bool> stays(entries_.size());
  for (Index i = 0; i < entries_.size(); ++i) {
    const CityObject& object = entries_[i].object;
    const bool shaped = !object.geometries.empty() || object.drawn > 0;
    stays[i] = shaped || (entries_[i].kept && !kInterior.contains(object.type));
    if (stays[i] && entries_[i].within) entries_[*entries_[i].within].object.has_parts = true;
  }
  for (const auto& [whole, part] : joined_) {
    if (stays[part]) entries_[whole].object.has_parts = true;
  }
  std::vector<CityObject> out;
  for (Index i = 0; i < entries_.size(); ++i) {
    if (!stays[i]) continue;
    CityObject& object = entries_[i].object;
    // Names may come twice; what belongs together must not depend on them.
    object.whole = fmt::format("{}", whole_of(i));
    object.is_part = entries_[i].within.has_value();
    out.push_back(std::move(object));
  }
  return out;
}

}  // namespace geom::gis
