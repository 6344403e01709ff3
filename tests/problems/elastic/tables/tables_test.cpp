// SPDX-License-Identifier: GPL-3.0-or-later
// What one table's entries say of another's, and of themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include <nodal/elastic/elastic_problem.h>

#include "moves/pricing_forms.h"
#include "points/layout.h"
#include "springs/connection.h"
#include "starts/start_rule.h"
#include "tables/table.h"

namespace nodal::elastic {
namespace {

template <class Entry>
void expect_well_kept(Table<Entry> table) {
  std::set<std::string> names;
  for (const Entry* entry : table) {
    EXPECT_TRUE(names.insert(std::string(entry->name)).second) << entry->name << " is listed twice";
    EXPECT_FALSE(entry->summary.empty()) << entry->name;
    ASSERT_NE(entry->make, nullptr) << entry->name;
    EXPECT_EQ(find_named(table, entry->name), entry);
  }
  EXPECT_EQ(find_named(table, "none of these"), nullptr);
}

TEST(Tables, NamesAreListedOnceAndFound) {
  expect_well_kept(start_rules());
  expect_well_kept(pricing_forms());
  expect_well_kept(layouts());
  expect_well_kept(connections());
}

TEST(Tables, AnotherRuleIsAdvisedWhereOneIsRefused) {
  for (const StartRule* rule : start_rules()) {
    // From each rule advice leads to one that is never refused, or back to none already tried.
    std::set<std::string_view> tried;
    for (const StartRule* next = rule; !next->instead.empty(); next = find_named(start_rules(), next->instead)) {
      ASSERT_TRUE(tried.insert(next->name).second) << "advice goes round from " << rule->name;
      ASSERT_NE(find_named(start_rules(), next->instead), nullptr) << next->instead << " is no rule";
    }
  }
}

TEST(Tables, FormsThatKeepNoListRemainForTiedSprings) {
  EXPECT_GE(std::ranges::count_if(pricing_forms(), [](const auto* form) { return !form->listed; }), 2);
  EXPECT_FALSE(kFullForm.listed);
  EXPECT_EQ(pricing_forms()[index_of(pricing_forms(), kFullForm)], &kFullForm);
}

TEST(Tables, LayoutsReadKeysThatThereAreAndEveryKeyIsReadBySomeLayout) {
  const OptionSchema schema = elastic_schema();
  const auto points = std::ranges::find(schema, std::string("points"), &Option::name);
  ASSERT_NE(points, schema.end());
  std::set<std::string> there, read = {"layout"};
  for (const Option& option : points->fields) there.insert(option.name);
  for (const Layout* layout : layouts())
    for (const std::string_view key : layout->keys)
      if (!key.empty()) read.insert(std::string(key));
  EXPECT_EQ(read, there);
}

TEST(Tables, EveryLayoutIsJoinedByItsConnectionAndEveryGridConnectionHasItsLayout) {
  for (const Layout* layout : layouts()) {
    const Connection* suits = find_named(connections(), layout->connection);
    ASSERT_NE(suits, nullptr) << layout->name;
    EXPECT_TRUE(suits->layout.empty() || suits->layout == layout->name) << layout->name;
    EXPECT_TRUE(suits->in_plane && !suits->mechanism) << layout->name;
    EXPECT_TRUE(!layout->in_space || suits->in_space) << layout->name;
  }
  for (const Connection* connection : connections()) {
    if (connection->layout.empty()) continue;
    const Layout* layout = find_named(layouts(), connection->layout);
    ASSERT_NE(layout, nullptr) << connection->name;
    EXPECT_TRUE(!connection->in_space || layout->in_space) << connection->name;
  }
}

}  // namespace
}  // namespace nodal::elastic
