// SPDX-License-Identifier: GPL-3.0-or-later
#include "require_manifest.h"

#include <fmt/format.h>

#include <nodal/record.h>

#include "manifest.h"

namespace nodal {

namespace {

using Test = bool (Value::*)() const noexcept;

// Follows a manifest down; `where_` is the way so far: "problems[0].best_known".
class Checked {
 public:
  Checked(const Value& value, std::string where, const std::string& path)
      : value_(value), where_(std::move(where)), path_(path) {}

  Checked require(Test is, const char* wanted) const {
    if (!(value_.*is)()) fail(fmt::format("'{}' is {}, not {}", where_, value_.type_name(), wanted));
    return *this;
  }

  template <class Check>
  void with(const char* key, Check check) const {
    if (const Value* found = value_.find(key)) check(Checked(*found, where_.empty() ? key : where_ + "." + key, path_));
  }
  void texts(std::initializer_list<const char*> keys) const {
    for (const char* key : keys) with(key, [](const Checked& c) { c.require(&Value::is_text, "a text"); });
  }
  void table(const char* key) const {
    with(key, [](const Checked& c) { c.require(&Value::is_table, "a table"); });
  }

  template <class Check>
  void each(const char* key, Check check) const {
    with(key, [&check](const Checked& list) {
      list.require(&Value::is_list, "a list");
      for (std::size_t i = 0; i < list.value_.list().size(); ++i)
        check(Checked(list.value_.list()[i], fmt::format("{}[{}]", list.where_, i), list.path_));
    });
  }
  template <class Check>
  void each_table(const char* key, Check check) const {
    each(key, [&check](const Checked& item) { check(item.require(&Value::is_table, "a table")); });
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("'{}' is not the manifest of a store: {}; choose another directory", path_, what));
  }

  const Value& value_;
  std::string where_;
  const std::string& path_;
};

void check_problem(const Checked& problem) {
  problem.texts({"label", "kind", "inputs"});
  problem.table("options");
  problem.with("best_known", [](const Checked& known) {
    known.require(&Value::is_table, "a table").texts({"origin"});
    known.with("quality", [](const Checked& quality) { quality.require(&Value::is_number, "a number"); });
    known.each("x", [](const Checked& x) { x.require(&Value::is_number, "a number"); });
  });
}

void check_study(const Checked& study) {
  study.texts({"name", "file", "directory", "text"});
  study.each_table("included", [](const Checked& file) { file.texts({"file", "text"}); });
  study.each("settings", [](const Checked& setting) { setting.require(&Value::is_text, "a text"); });
}

void check_schema(const Value& manifest, const std::string& path) {
  const Value* schema = manifest.is_table() ? manifest.find("schema") : nullptr;
  if (!schema || !schema->is_integer())
    throw InputError(
        fmt::format("'{}' is not the manifest of a store: it has no schema; choose another directory", path));
  if (schema->integer() < 1)
    throw InputError(fmt::format("'{}' is not the manifest of a store: its schema is {}; choose another directory",
                                 path, schema->integer()));
  if (schema->integer() > kManifestSchema)
    throw NewerSchemaError(
        fmt::format("'{}' has schema {}, this build reads up to {}; use a newer nodal or another directory", path,
                    schema->integer(), kManifestSchema));
}

}  // namespace

void require_manifest(const Value& manifest, const std::string& path) {
  check_schema(manifest, path);
  const Checked top(manifest, "", path);
  top.with("study", [](const Checked& study) { check_study(study.require(&Value::is_table, "a table")); });
  top.each_table("other_studies", check_study);
  top.each_table("problems", check_problem);
  top.each_table("optimizers", [](const Checked& optimizer) {
    optimizer.texts({"label", "use"});
    optimizer.table("options");
    for (const char* flag : {"baseline", "multi_start", "deterministic"})
      optimizer.with(flag, [](const Checked& c) { c.require(&Value::is_boolean, "a boolean"); });
  });
  top.each_table("left_out", [](const Checked& entry) { entry.texts({"label", "use", "reason"}); });
  top.each("keys", [](const Checked& key) { key.require(&Value::is_text, "a text"); });
}

}  // namespace nodal
