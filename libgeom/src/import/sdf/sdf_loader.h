#pragma once

// A world of SDF with the models that it includes, as scopes.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "geom/import/sdf_world.h"
#include "sdf_scope.h"

namespace geom {

class SdfLoader {
 public:
  // What is not found, or may hold obstacles and is not known, is added to `skipped`.
  SdfLoader(const SdfOptions& options, Skipped& skipped) : options_(options), skipped_(skipped) {}

  // The world in the text; of a file without one, its models. It refers to what the loader holds.
  std::unique_ptr<SdfScope> load(const std::string& text, const std::string& source);

 private:
  struct Document {
    std::string source;
    XmlElement root;
  };

  const Document& document(const std::string& text, const std::string& source);
  void fill(SdfScope& scope);
  void add_model(SdfScope& scope, const SdfNode& model);
  void add_include(SdfScope& scope, const SdfNode& include);
  void count_model(const SdfNode& model);

  const SdfOptions& options_;
  Skipped& skipped_;
  std::map<std::string, std::unique_ptr<Document>> documents_;  // by their names
  std::vector<std::string> open_;                               // those that are being included
  std::size_t models_ = 0;
};

// "line 7: road", in messages about what a file holds; with the file where it is an included one.
std::string sdf_place(const SdfNode& node, const std::string& what);

}  // namespace geom
