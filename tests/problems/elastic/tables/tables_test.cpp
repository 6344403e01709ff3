// SPDX-License-Identifier: GPL-3.0-or-later
// What one table's entries say of another's, and of themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <string>

#include <nodal/elastic/elastic_problem.h>
#include <nodal/toml.h>

#include "../../../support/messages.h"

#include "moves/pricing_forms.h"
#include "points/layout.h"
#include "read/read_points.h"
#include "springs/connection.h"
#include "starts/start_rule.h"
#include "tables/own_options.h"
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
  std::multiset<std::string> there, own = {"layout"};  // none has another's option for its own
  for (const Option& option : points->fields) there.insert(option.name);
  for (const Layout* layout : layouts()) {
    for (const Option& option : own_options(*layout)) own.insert(option.name);
    for (const std::string_view key : layout->keys)
      EXPECT_TRUE(key.empty() || there.contains(std::string(key))) << layout->name << " reads " << key;
  }
  EXPECT_EQ(own, there);
}

// As the page about adding one has it: each of the two words opens one kind of body, whatever the other says.
TEST(Tables, LayoutsAreAskedForBodiesThatTheySayTheyFill) {
  Layout layout = kGridLayout;
  layout.name = "mine";
  const Body box = space::box_body({}, {1, 1, 1}), none{.name = "none", .rings = {}},
             plate = plane::rectangle_body({}, {1, 1});
  const auto said = [&](const Body& body) {
    return toy::message_of([&] { require_body_for(layout, body, {"study.toml", 3}); });
  };
  for (const bool in_space : {false, true})
    for (const bool without_outline : {false, true}) {
      layout.in_space = in_space;
      layout.without_outline = without_outline;
      EXPECT_EQ(said(plate), "(nothing was thrown)");
      EXPECT_EQ(said(box), in_space ? "(nothing was thrown)"
                                    : "study.toml:3: layout 'mine' is one of the plane; a body in space takes a grid: "
                                      "points = { counts = [5, 5, 5] }");
      EXPECT_EQ(said(none), without_outline ? "(nothing was thrown)"
                                            : "study.toml:3: layout 'mine' needs a body with an outline, and this one "
                                              "has none; describe it, as by body = { size = [4, 4] }");
    }
}

TEST(Tables, OptionsBelongToThoseThatReadThem) {
  const Options study(parse_toml("total = 3\nseed = 1\n", "study.toml"));
  EXPECT_EQ(toy::message_of([&] { refuse_foreign_options(study, layouts(), kGridLayout, "layout"); }),
            "study.toml:1: 'total' belongs to layout 'random' or 'voronoi', and this one is 'grid'");
  EXPECT_NO_THROW(refuse_foreign_options(study, layouts(), *find_named(layouts(), "voronoi"), "layout"));
  const OptionSchema options = options_of(connections());
  const auto nearest = std::ranges::find(options, std::string("nearest"), &Option::name);
  ASSERT_NE(nearest, options.end());
  EXPECT_EQ(nearest->help, "nearest: with how many of its nearest nodes each is joined");
}

// Helps and refusals are made from the tables: whoever adds an entry needn't look for them.
TEST(Tables, EveryEntryIsToldOfInTheHelp) {
  const OptionSchema schema = elastic_schema();
  const auto option = [&](const char* table, const char* name) {
    const auto of = std::ranges::find(schema, std::string(table), &Option::name);
    return *std::ranges::find(of->fields, std::string(name), &Option::name);
  };
  for (const Connection* connection : connections())  // as an entry of a list, not in another's name
    EXPECT_TRUE(std::regex_search(option("springs", "topology").help,
                                  std::regex("[:,] " + std::string(connection->name) + "(,|;| \\()")))
        << connection->name;
  for (const Layout* layout : layouts()) {
    EXPECT_NE(option("springs", "topology").default_text.find(layout->name), std::string::npos) << layout->name;
    EXPECT_NE(option("points", "layout").help.find(layout->summary), std::string::npos) << layout->name;
  }
  for (const StartRule* rule : start_rules())
    EXPECT_NE(option("springs", "initial").help.find(rule->summary), std::string::npos) << rule->name;
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
    EXPECT_EQ(connection->needs.empty(), connection->lacks == nullptr) << connection->name;
    if (connection->layout.empty()) continue;
    const Layout* layout = find_named(layouts(), connection->layout);
    ASSERT_NE(layout, nullptr) << connection->name;
    EXPECT_TRUE(!connection->in_space || layout->in_space) << connection->name;
  }
}

}  // namespace
}  // namespace nodal::elastic
