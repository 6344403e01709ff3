// SPDX-License-Identifier: GPL-3.0-or-later
// The first rule of the house: lib knows nobody, problems, optimizers and bench know only lib.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "layering.h"

namespace nodal::architecture {
namespace {

namespace fs = std::filesystem;

std::string lines(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += text + "\n";
  return all;
}

TEST(Architecture, IsKept) {
  EXPECT_GT(count_sources(NODAL_SOURCE_DIR), 50u);
  EXPECT_EQ(lines(find_breaches(NODAL_SOURCE_DIR)), "");
}

// A house of a few files, in which a breach can be planted.
class Planted : public testing::Test {
 protected:
  Planted() {
    std::string pattern = (fs::temp_directory_path() / "nodal-architecture-XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw std::runtime_error("cannot make a temporary folder");
    root_ = pattern;
    write("lib/include/nodal/problem.h", "#pragma once\n#include <vector>\n");
    write("lib/src/problem.cpp", "#include <nodal/problem.h>\n#include <fmt/format.h>\n#include <sys/wait.h>\n");
    write("problems/plate/include/nodal/plate/plate.h", "#include <nodal/problem.h>\n");
    write("problems/plate/src/plate.cpp",
          "#include <nodal/plate/plate.h>\n#include \"solver.h\"\n#include <cholmod.h>\n");
    write("problems/plate/src/solver.h", "// #include <nodal/optimizer/annealing.h>\n");
    write("optimizers/walk/walk.cpp", "#include <nodal/problem.h>\n");
    write("bench/program.cpp", "#include <nodal/components.h>\n#include <nodal/problem.h>\n#include <CLI/CLI.hpp>\n");
  }
  ~Planted() override {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
  }

  // With the licence on line 1.
  void write(const std::string& file, const std::string& text) {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << "// SPDX-License-Identifier: GPL-3.0-or-later\n" << text;
  }
  std::string breaches() const { return lines(find_breaches(root_)); }

  fs::path root_;
};

TEST_F(Planted, HouseIsClean) {
  EXPECT_EQ(breaches(), "");
  EXPECT_EQ(count_sources(root_), 7u);
}

TEST_F(Planted, LibThatKnowsAProblemIsFound) {
  write("lib/src/meter.cpp", "\n#include <nodal/plate/plate.h>\n");
  EXPECT_EQ(breaches(), "lib/src/meter.cpp:3: includes <nodal/plate/plate.h>, which is neither lib's nor its own\n");
}

TEST_F(Planted, LibThatKnowsAProblemByItsPathIsFound) {
  write("lib/src/meter.cpp", "#  include \"../../problems/plate/src/solver.h\"\n");
  EXPECT_EQ(breaches(),
            "lib/src/meter.cpp:2: includes \"../../problems/plate/src/solver.h\", which is not in its unit\n");
}

TEST_F(Planted, LibWithAnOptimizersLibraryIsFound) {
  write("lib/src/meter.cpp", "#include <nlopt.h>\n");
  EXPECT_EQ(breaches(), "lib/src/meter.cpp:2: lib includes <nlopt.h>, a library it does not stand on\n");
}

TEST_F(Planted, OptimizerThatKnowsAProblemIsFound) {
  write("optimizers/walk/walk.cpp", "#include <nodal/plate/plate.h>\n");
  EXPECT_EQ(breaches(),
            "optimizers/walk/walk.cpp:2: includes <nodal/plate/plate.h>, which is neither lib's nor its own\n");
}

TEST_F(Planted, ComponentThatKnowsAllComponentsIsFound) {
  write("problems/plate/src/solver.h", "#include <nodal/components.h>\n");
  EXPECT_EQ(breaches(),
            "problems/plate/src/solver.h:2: includes <nodal/components.h>, which is neither lib's nor its own\n");
}

TEST_F(Planted, OptimizerThatKnowsAnotherIsFound) {
  write("optimizers/run/run.cpp", "#include \"../walk/walk.cpp\"\n");
  EXPECT_EQ(breaches(), "optimizers/run/run.cpp:2: includes \"../walk/walk.cpp\", which is not in its unit\n");
}

TEST_F(Planted, ProgramThatReachesIntoAnotherUnitIsFound) {
  write("lib/src/lock.h", "");
  write("optimizers/walk/step.h", "");
  write("bench/report/page.cpp", "#include \"page.h\"\n#include \"lock.h\"\n#include \"generated.h\"\n");
  write("bench/report/page.h", "#include \"solver.h\"\n#include \"step.h\"\n");
  write("bench/micro/lock_time.cpp", "#include \"lock.h\"\n");
  EXPECT_EQ(breaches(),
            "bench/micro/lock_time.cpp:2: includes \"lock.h\", which is private to lib\n"
            "bench/report/page.cpp:3: includes \"lock.h\", which is private to lib\n"
            "bench/report/page.h:2: includes \"solver.h\", which is private to problems/plate\n"
            "bench/report/page.h:3: includes \"step.h\", which is private to optimizers/walk\n");
}

TEST_F(Planted, ProgramThatKnowsAProblemIsFound) {
  write("bench/program.cpp", "#include <nodal/plate/plate.h>\n");
  EXPECT_EQ(breaches(), "bench/program.cpp:2: includes <nodal/plate/plate.h>, which is neither lib's nor its own\n");
}

TEST_F(Planted, BenchmarksOfAComponentMeasureItsPartsAndRegisterAll) {
  write("problems/plate/micro/solving.cpp", "#include <nodal/components.h>\n#include \"solver.h\"\n");
  EXPECT_EQ(breaches(), "");
}

TEST_F(Planted, LibrarysHeaderInAPublicHeaderIsFound) {
  write("lib/include/nodal/problem.h", "#include <fmt/format.h>\n");
  write("problems/plate/include/nodal/plate/plate.h", "#include <Eigen/Dense>\n#include \"solver.h\"\n");
  EXPECT_EQ(breaches(),
            "lib/include/nodal/problem.h:2: a public header includes <fmt/format.h>, which is no standard header\n"
            "problems/plate/include/nodal/plate/plate.h:2: a public header includes <Eigen/Dense>, which is no "
            "standard header\n"
            "problems/plate/include/nodal/plate/plate.h:3: a public header includes \"solver.h\"; public headers are "
            "included as <nodal/…>\n");
}

TEST_F(Planted, QuestionToThePreprocessorIsFound) {
  write("bench/program.cpp", "#ifdef NODAL_HAVE_NLOPT\n#endif\n");
  EXPECT_EQ(breaches(),
            "bench/program.cpp:2: asks the preprocessor what is in the build: compile another file instead\n");
}

TEST_F(Planted, BugThatIsCaughtAsARefusalIsFound) {
  write("problems/plate/src/plate.cpp", "try {\n} catch (const std::invalid_argument& error) {\n}\n");
  write("optimizers/walk/walk.cpp", "throw std::invalid_argument(\"\");\ntry {} catch (const Refusal& refusal) {}\n");
  EXPECT_EQ(breaches(),
            "problems/plate/src/plate.cpp:3: catches std::invalid_argument, a caller's bug: what is refused is a "
            "Refusal\n");
}

TEST_F(Planted, SourceWithoutLicenceIsFound) {
  fs::create_directories(root_ / "tests/lib");
  std::ofstream(root_ / "tests/lib/meter_test.cpp") << "#include <vector>\n";
  std::ofstream(root_ / "bench/empty.h").flush();
  EXPECT_EQ(breaches(), "bench/empty.h:0: is empty\ntests/lib/meter_test.cpp:1: does not begin with the licence\n");
}

}  // namespace
}  // namespace nodal::architecture
