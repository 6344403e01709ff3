// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/provenance.h>

#include <gtest/gtest.h>

#include <nodal/file.h>
#include <nodal/random.h>

#include <fmt/format.h>

namespace nodal {
namespace {

Value without(Value table, const std::string& key) {
  std::erase_if(table.table(), [&key](const auto& entry) { return entry.first == key; });
  return table;
}

TEST(Provenance, KnowsTheProgramByItsContents) {
  const std::string program = read_file("/proc/self/exe", "program");
  EXPECT_EQ(provenance().at("executable").text(), fmt::format("{:016x}", hash64(program)));
}

TEST(Provenance, IdentifiesABuildByAllThatChangesResults) {
  const Value here = provenance();
  EXPECT_EQ(build_identity(here), build_identity(provenance()));
  for (const char* key : {"version", "revision", "compiler", "flags", "build_type", "executable"}) {
    Value other = here;
    other.set(key, "another");
    EXPECT_NE(build_identity(other), build_identity(here)) << key;
    EXPECT_NE(build_id(other), build_id(here)) << key;
    EXPECT_NE(build_id(without(here, key)), build_id(here)) << key;
  }
  for (const char* key : {"processor", "threads", "environment", "system"}) {
    Value other = here;
    other.set(key, "another");
    EXPECT_EQ(build_id(other), build_id(here)) << key;
  }
}

// The objects beside the system's count by what they hold: the same build may lie elsewhere.
TEST(Provenance, IdentifiesABuildByItsSharedObjects) {
  const auto with_object = [](const char* path, const char* hash) {
    Value objects, result = provenance();
    objects.set(path, hash);
    result.set("objects", objects);
    return build_id(result);
  };
  EXPECT_EQ(with_object("/a/libmine.so", "1"), with_object("/b/libmine.so", "1"));
  EXPECT_NE(with_object("/a/libmine.so", "1"), with_object("/a/libmine.so", "2"));
}

TEST(Provenance, NamesABuildBySixteenDigits) {
  const std::string id = build_id(provenance());
  EXPECT_EQ(id.size(), 16u);
  EXPECT_EQ(id.find_first_not_of("0123456789abcdef"), std::string::npos);
}

}  // namespace
}  // namespace nodal
