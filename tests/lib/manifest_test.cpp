// SPDX-License-Identifier: GPL-3.0-or-later
// What a manifest holds is of the type that its readers take for granted, or file and key are named.
#include <gtest/gtest.h>

#include <fstream>

#include <nodal/store.h>

#include "../support/temporary_directory.h"

namespace nodal {
namespace {

using toy::TemporaryDirectory;

std::string refusal_of(const std::string& rest, const std::string& schema = "1") {
  const TemporaryDirectory temporary;
  const std::string path = (temporary.path() / "manifest.json").string();
  std::ofstream(path) << "{\"schema\": " << schema << ", " << rest << "}";
  try {
    (void)Store::open_existing(temporary.path());
  } catch (const InputError& error) {
    const std::string begin = "'" + path + "' is not the manifest of a store: ", end = "; choose another directory";
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with(begin) && message.ends_with(end)) << message;
    return message.substr(begin.size(), message.size() - begin.size() - end.size());
  }
  return "taken";
}

TEST(Manifest, NamesTheKeyThatIsOfAnotherType) {
  const std::pair<const char*, const char*> cases[] = {
      {R"("study": 3)", "'study' is an integer, not a table"},
      {R"("study": {"text": []})", "'study.text' is a list, not a text"},
      {R"("study": {"directory": 1.5})", "'study.directory' is a number, not a text"},
      {R"("problems": {})", "'problems' is a table, not a list"},
      {R"("problems": [{}, 2])", "'problems[1]' is an integer, not a table"},
      {R"("problems": [{"label": true}])", "'problems[0].label' is a boolean, not a text"},
      {R"("problems": [{"options": "x"}])", "'problems[0].options' is a text, not a table"},
      {R"("problems": [{"best_known": 3}])", "'problems[0].best_known' is an integer, not a table"},
      {R"("problems": [{"best_known": {"quality": "x"}}])", "'problems[0].best_known.quality' is a text, not a number"},
      {R"("optimizers": [1, []])", "'optimizers[0]' is an integer, not a table"},
      {R"("optimizers": [{"baseline": "yes"}])", "'optimizers[0].baseline' is a text, not a boolean"},
      {R"("left_out": [{"reason": 7}])", "'left_out[0].reason' is an integer, not a text"},
      {R"("keys": ["a", 2])", "'keys[1]' is an integer, not a text"},
  };
  for (const auto& [rest, message] : cases) EXPECT_EQ(refusal_of(rest), message) << rest;
}

TEST(Manifest, IsTakenWithKeysThatAreMissingOrUnknown) {
  for (const char* rest : {R"("study": {})", R"("problems": [{"more": 1}], "keys": [])", R"("other": [[]])"})
    EXPECT_EQ(refusal_of(rest), "taken");
}

TEST(Manifest, HasASchemaAboveZero) {
  for (const char* schema : {"-7", "0"})
    EXPECT_EQ(refusal_of(R"("keys": [])", schema), std::string("its schema is ") + schema);
}

}  // namespace
}  // namespace nodal
