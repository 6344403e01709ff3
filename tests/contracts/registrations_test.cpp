// SPDX-License-Identifier: GPL-3.0-or-later
// What a description says, for `nodal list`, the config reference and the editor schema.
#include <gtest/gtest.h>

#include <nodal/unseen.h>

#include "registered.h"

namespace nodal::contracts {
namespace {

// Lower-case words and digits, joined by single separators, a letter first.
bool is_joined(std::string_view name, std::string_view separators) {
  bool word_ends = false;
  for (const char c : name) {
    const bool separator = separators.find(c) != std::string_view::npos;
    if (separator ? !word_ends : !(('a' <= c && c <= 'z') || ('0' <= c && c <= '9'))) return false;
    word_ends = !separator;
  }
  return word_ends && 'a' <= name[0] && name[0] <= 'z';
}

// Names in studies are kebab-case; keys of options may be snake_case.
bool is_kebab_case(std::string_view name) { return is_joined(name, "-"); }
bool is_key(std::string_view name) { return is_joined(name, "-_"); }

void check_option(const Option& option, const std::string& owner) {
  const std::string name = owner + "." + option.name;
  EXPECT_TRUE(is_key(option.name)) << name;
  EXPECT_FALSE(option.help.empty()) << name;
  EXPECT_EQ(option.help.find('\n'), std::string::npos) << name;
  EXPECT_LE(option.minimum, option.maximum) << name;
  EXPECT_FALSE(option.required && option.default_value) << name;
  if (!option.choices.empty()) {
    EXPECT_EQ(option.type, OptionType::text) << name;
  }
  if (!option.fields.empty()) {
    EXPECT_TRUE(option.type == OptionType::table || option.type == OptionType::table_list || option.or_table) << name;
  }
  for (const Option& field : option.fields) check_option(field, name);
}

void check_schema(const OptionSchema& schema, const std::string& owner) {
  for (const Option& option : schema) {
    check_option(option, owner);
    EXPECT_TRUE(option.default_value || option.required || !option.default_text.empty())
        << owner << "." << option.name << " doesn't say what happens when it is left out";
  }
  const Options defaults = resolve_options(schema, Value(), owner);
  EXPECT_EQ(resolve_options(schema, defaults.values(), owner).values(), defaults.values()) << owner;
}

TEST(Registrations, OfOptimizersAreComplete) {
  ASSERT_FALSE(components().optimizers().empty());
  for (const OptimizerDescription& optimizer : components().optimizers()) {
    EXPECT_TRUE(is_kebab_case(optimizer.name)) << optimizer.name;
    EXPECT_FALSE(optimizer.summary.empty()) << optimizer.name;
    EXPECT_FALSE(optimizer.reference.empty()) << optimizer.name;
    if (optimizer.local) {
      EXPECT_TRUE(optimizer.uses_start) << optimizer.name << ": a local method starts somewhere";
    }
    ASSERT_TRUE(optimizer.make) << optimizer.name;
    check_schema(optimizer.options, optimizer.name);
    EXPECT_NE(optimizer.make(resolve_options(optimizer.options, Value(), optimizer.name)), nullptr) << optimizer.name;
  }
}

TEST(Registrations, OfProblemsAreComplete) {
  ASSERT_FALSE(components().problems().empty());
  for (const ProblemDescription& problem : components().problems()) {
    EXPECT_TRUE(is_kebab_case(problem.kind)) << problem.kind;
    EXPECT_FALSE(problem.summary.empty()) << problem.kind;
    EXPECT_FALSE(problem.reference.empty()) << problem.kind;
    ASSERT_TRUE(problem.make) << problem.kind;
    check_schema(problem.options, problem.kind);
  }
}

TEST(Registrations, OfProblemsLeaveTheStudysOwnKeysAlone) {
  for (const ProblemDescription& problem : components().problems())
    for (const Option& own : problem_entry_schema())
      EXPECT_EQ(std::ranges::find(problem.options, own.name, &Option::name), problem.options.end())
          << problem.kind << "." << own.name;
}

TEST(Registrations, OfWhatIsAbsentSayWhy) {
  for (const AbsentDescription& absent : components().absent()) {
    EXPECT_FALSE(absent.reason.empty()) << absent.name;
    EXPECT_EQ(components().find_optimizer(absent.name), nullptr) << absent.name;
  }
}

// What nodal fit takes when nobody names a method is decided by rank alone, so no two are the same.
TEST(Registrations, RankMethodsThatSuitDifferently) {
  const std::shared_ptr<const Problem> problem = make_problem(samples().at(0));
  std::set<int> ranks;
  for (const OptimizerDescription& optimizer : components().optimizers()) {
    if (!optimizer.suits) continue;
    const std::optional<Suitability> suits = optimizer.suits(*problem);
    if (!suits) continue;
    EXPECT_FALSE(suits->reason.empty()) << optimizer.name;
    EXPECT_TRUE(ranks.insert(suits->rank).second) << optimizer.name << " has the rank of another";
  }
  EXPECT_FALSE(ranks.empty());
}

// A command or a list of a problem's that had a name of the program's own would hide it, or be hidden.
TEST(Registrations, BringCommandsAndListsOfOtherNames) {
  std::set<std::string> names = {"compare", "evaluate", "fit", "report", "explain", "list"};
  std::set<std::string> lists = {"optimizers", "problems", "scenes"};
  for (const ProblemDescription& problem : components().problems()) {
    for (const Command& command : problem.commands) {
      EXPECT_TRUE(names.insert(command.name).second) << command.name;
      EXPECT_FALSE(command.summary.empty()) << command.name;
      EXPECT_TRUE(command.run) << command.name;
    }
    for (const Listing& listing : problem.listings) EXPECT_TRUE(lists.insert(listing.name).second) << listing.name;
  }
}

TEST(Registrations, RefuseFindingsNamedLikeAnEntryOfEveryRecord) {
  Registry registry;
  for (const char* name : {"drift", kUnseenFinding})
    EXPECT_THROW(registry.add(ProblemDescription{.kind = "toy", .findings = {{.name = name}}}), std::logic_error);
  EXPECT_TRUE(registry.problems().empty());
}

}  // namespace
}  // namespace nodal::contracts
