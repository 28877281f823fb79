#include "geom/text/xml_element.h"

#include "xml_events.h"

namespace geom {
namespace {

class Tree : public XmlHandler {
 public:
  void begin(const XmlTag& tag) override {
    XmlElement& made = open_.empty() ? root : open_.back()->children.emplace_back();
    made.name = tag.name;
    made.prefix = tag.prefix;
    made.line = tag.line;
    made.attributes.reserve(tag.attributes.size());
    for (const auto& [name, value] : tag.attributes) made.attributes.emplace_back(name, value);
    open_.push_back(&made);
    if (texts_.size() < open_.size()) texts_.emplace_back();
  }

  void text(std::string_view part) override { texts_[open_.size() - 1] += part; }

  void end(std::size_t) override {
    std::string& text = texts_[open_.size() - 1];
    open_.back()->text = text;
    text.clear();
    open_.pop_back();
  }

  XmlElement root;

 private:
  std::vector<XmlElement*> open_;   // only the children of the last one may move
  std::vector<std::string> texts_;  // of the open ones, with room to grow that no element keeps
};

}  // namespace

XmlElement parse_xml(std::string_view text, std::string_view source) {
  Tree tree;
  read_xml(text, std::string(source), tree);
  return std::move(tree.root);
}

}  // namespace geom
