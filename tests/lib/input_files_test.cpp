// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/input_files.h>

#include <gtest/gtest.h>

#include <fstream>

#include <nodal/error.h>
#include <nodal/random.h>

#include "../support/temporary_directory.h"

namespace nodal {
namespace {

class InputFilesTest : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(directory_.path() / name) << text;
  }

  toy::TemporaryDirectory directory_;
};

TEST_F(InputFilesTest, ReadsBesideTheStudyAndEachFileOnce) {
  write("nodes.csv", "x,y\n");
  InputFiles files(directory_.path());
  const std::string& text = files.read(files.path("nodes.csv"), "node file");
  EXPECT_EQ(text, "x,y\n");
  write("nodes.csv", "changed meanwhile");
  EXPECT_EQ(&files.read(files.path("nodes.csv"), "node file"), &text);
  EXPECT_EQ(text, "x,y\n");
}

TEST_F(InputFilesTest, FingerprintIsOfContentsInTheOrderInWhichTheyAreAskedFor) {
  write("a", "one");
  write("b", "two");
  write("c", "one");
  const auto fingerprint = [this](const std::vector<std::string>& names) {
    InputFiles files(directory_.path());
    for (const std::string& name : names) (void)files.read(files.path(name), "file");
    return files.fingerprint();
  };
  EXPECT_EQ(fingerprint({}), "");
  EXPECT_EQ(fingerprint({"a", "b"}), hash128(std::string("one\0two\0", 8)));
  EXPECT_EQ(fingerprint({"a", "b"}), fingerprint({"c", "b", "c"}));  // names don't count, nor how often
  EXPECT_NE(fingerprint({"a", "b"}), fingerprint({"b", "a"}));
}

TEST_F(InputFilesTest, RefusesAFileThatIsNotThereAndForgetsIt) {
  InputFiles files(directory_.path());
  try {
    (void)files.read(files.path("none.csv"), "node file");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("cannot read node file"), std::string::npos) << error.what();
  }
  EXPECT_EQ(files.fingerprint(), "");
}

}  // namespace
}  // namespace nodal
