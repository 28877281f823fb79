#pragma once

// Members of JSON objects that others wrote, with errors that say where they stand.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geom/base/error.h"

namespace geom {

class JsonMembers {
 public:
  // `where`: "node 3". Both must outlive this.
  JsonMembers(const nlohmann::json& object, std::string source, std::string where);

  bool has(const char* key) const { return object_.contains(key); }
  const nlohmann::json& object() const { return object_; }
  const std::string& source() const { return source_; }

  // Each refuses (InputError) a member of another type. Whole numbers are >= 0.
  std::optional<std::uint64_t> find_whole(const char* key) const;
  std::uint64_t whole(const char* key) const;  // must be there
  std::uint64_t whole(const char* key, std::uint64_t fallback) const;
  std::optional<std::string> find_text(const char* key) const;
  std::string text(const char* key) const;
  bool truth(const char* key) const;  // false where it is not there

  // Exactly `count` finite numbers; nothing where it is not there.
  std::optional<std::vector<double>> numbers(const char* key, std::size_t count) const;

  // The members of a list or an object; an empty one where it is not there.
  const nlohmann::json& list(const char* key) const;
  const nlohmann::json& members(const char* key) const;

  // Member `i` of the object's list `key`, an object itself: "mesh 2".
  JsonMembers at(const char* key, std::uint64_t i, const std::string& what) const;

  [[noreturn]] void refuse(Fault fault) const;

 private:
  [[noreturn]] void refuse_type(const char* key, const char* expected) const;

  const nlohmann::json& object_;
  std::string source_;
  std::string where_;
};

}  // namespace geom
