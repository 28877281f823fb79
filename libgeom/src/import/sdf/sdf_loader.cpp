#include "sdf_loader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

namespace geom {
namespace {

constexpr std::size_t kMostModels = 1000000;
constexpr std::size_t kDeepest = 50;  // includes in includes
// What an <include> may hold; anything else might change the model, as a <scale> would.
const std::set<std::string_view> kOfInclude = {"name", "placement_frame", "plugin",
                                               "pose", "static",          "uri"};

void require_version(const SdfNode& root) {
  if (root.name() != "sdf") {
    root.refuse({.expected = "<sdf>", .found = fmt::format("<{}>", root.name().substr(0, 40))});
  }
  constexpr std::array kKnown = {"1.4", "1.5", "1.6", "1.7", "1.8", "1.9", "1.10", "1.11", "1.12"};
  const std::string version = root.attribute("version");
  if (std::find(kKnown.begin(), kKnown.end(), version) == kKnown.end()) {
    root.refuse(
        {.expected = "<sdf version> from 1.4 to 1.12", .found = in_quotes(version.substr(0, 40))});
  }
}

}  // namespace

std::string sdf_place(const SdfNode& node, const std::string& what) {
  return fmt::format("{}:{}: {}", *node.source, node.element->line, what.substr(0, 60));
}

const SdfLoader::Document& SdfLoader::document(const std::string& text, const std::string& source) {
  std::unique_ptr<Document>& held = documents_[source];
  if (!held) {
    held = std::make_unique<Document>(Document{source, parse_xml(text, source)});
    require_version({&held->root, &held->source});
  }
  return *held;
}

std::unique_ptr<SdfScope> SdfLoader::load(const std::string& text, const std::string& source) {
  const Document& file = document(text, source);
  const SdfNode root{&file.root, &file.source};
  const std::optional<SdfNode> world = root.find("world");
  auto scope = std::make_unique<SdfScope>(world.value_or(root), "", nullptr);
  scope->name = scope->node.attribute("name");
  open_ = {source};
  fill(*scope);
  for (const XmlElement& beside : file.root.children) {
    if (!world || beside.name == "world" || beside.name == "light" || !beside.prefix.empty()) {
      continue;
    }
    skipped_.add("element beside the world", sdf_place(root.of(beside), beside.name));
  }
  return scope;
}

void SdfLoader::fill(SdfScope& scope) {
  for (const XmlElement& child : scope.node.element->children) {
    const SdfNode node = scope.node.of(child);
    if (!child.prefix.empty()) continue;
    if (child.name == "model") add_model(scope, node);
    if (child.name == "include") add_include(scope, node);
  }
}

void SdfLoader::count_model(const SdfNode& model) {
  if (++models_ > kMostModels) {
    model.refuse({.expected = fmt::format("at most {} models", kMostModels), .found = "more"});
  }
}

void SdfLoader::add_model(SdfScope& scope, const SdfNode& model) {
  count_model(model);
  auto made = std::make_unique<SdfScope>(model, model.attribute("name"), &scope);
  made->placing = model.find("pose");
  made->placement_frame = model.attribute("placement_frame");
  const std::optional<SdfNode> fixed = model.find("static");
  made->is_static = scope.is_static || (fixed && fixed->flag());
  fill(*made);
  scope.models.push_back(std::move(made));
}

void SdfLoader::add_include(SdfScope& scope, const SdfNode& include) {
  count_model(include);
  const std::string uri(include.child("uri").text());
  const SdfFile* file = options_.open ? options_.open(uri, *include.source) : nullptr;
  if (!file) {
    skipped_.add("model that is not found", sdf_place(include, uri));
    return;
  }
  if (std::find(open_.begin(), open_.end(), file->name) != open_.end()) {
    include.refuse({.expected = "includes that end",
                    .found = fmt::format("\"{}\", which includes itself", file->name)});
  }
  if (open_.size() >= kDeepest) {
    include.refuse(
        {.expected = fmt::format("includes at most {} deep", kDeepest), .found = "more"});
  }
  const Document& held = document(file->text, file->name);
  const SdfNode root{&held.root, &held.source};
  const std::optional<SdfNode> model = root.find("model");
  if (!model) {
    const bool light = root.find("light").has_value();
    if (!light) skipped_.add("include without a model", sdf_place(include, uri));
    return;
  }
  auto made = std::make_unique<SdfScope>(*model, model->attribute("name"), &scope);
  if (const auto name = include.find("name")) made->name = name->text();
  made->placing = include.find("pose");
  made->placement_frame = model->attribute("placement_frame");
  if (made->placing) made->placement_frame.clear();
  if (const auto placement = include.find("placement_frame")) {
    made->placement_frame = placement->text();
  }
  if (!made->placing) made->placing = model->find("pose");
  std::optional<SdfNode> fixed = include.find("static");
  if (!fixed) fixed = model->find("static");
  made->is_static = scope.is_static || (fixed && fixed->flag());
  for (const XmlElement& child : include.element->children) {
    const bool known = child.prefix.empty() && kOfInclude.contains(child.name);
    if (known || (!child.prefix.empty() && child.prefix != "experimental")) continue;
    skipped_.add("change of an included model", sdf_place(include.of(child), child.name));
  }
  open_.push_back(file->name);
  fill(*made);
  open_.pop_back();
  scope.models.push_back(std::move(made));
}

}  // namespace geom
