#pragma once

// What the prefixes of an XML document stand for, while it is read.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "xml_events.h"

namespace geom {

class XmlNamespaces {
 public:
  // An element with these attributes begins.
  void enter(std::span<const XmlAttribute> attributes) {
    ++depth_;
    for (const auto& [name, value] : attributes) {
      if (name != "xmlns" && !name.starts_with("xmlns:")) continue;
      const std::string_view prefix = name.substr(name.size() == 5 ? 5 : 6);
      declared_.push_back({depth_, std::string(prefix), std::string(value)});
    }
  }

  // The innermost element ends.
  void leave() {
    while (!declared_.empty() && declared_.back().depth == depth_) declared_.pop_back();
    --depth_;
  }

  // The URI that a prefix stands for here; "" is the prefix of a name without one. Empty if it
  // stands for none. Valid until the next enter() or leave().
  std::string_view of(std::string_view prefix) const {
    for (auto known = declared_.rbegin(); known != declared_.rend(); ++known) {
      if (known->prefix == prefix) return known->uri;
    }
    return {};
  }

 private:
  struct Declared {
    std::size_t depth;
    std::string prefix;
    std::string uri;
  };
  std::vector<Declared> declared_;
  std::size_t depth_ = 0;
};

}  // namespace geom
