// SPDX-License-Identifier: GPL-3.0-or-later
// What comes after a fit: the system that it wrote is read back as it is, and is a start like any other.
#include <gtest/gtest.h>

#include <set>

#include <nodal/store.h>
#include <nodal/value.h>

#include "program.h"

namespace nodal::program {
namespace {

Value evaluated(const Folder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"evaluate", "--json"});
  const Output output = run(folder, arguments);
  EXPECT_EQ(output.exit, 0) << output.err;
  return output.exit == 0 ? parse_json(output.out, "stdout") : Value();
}

std::set<std::string> ends_of(const Value& springs) {
  std::set<std::string> ends;
  for (const Value& spring : springs.list()) ends.insert(to_json(spring.at("nodes")));
  return ends;
}

// A plate of 3 × 3 nodes whose diagonals may hardly be soft, pruned, is a system of its own: as points and springs of
// another study it has the G that was fitted. So has the whole plate, with springs of next to nothing where there are
// none.
TEST(PrunedExport, IsReadBackAsAStudy) {
  const Folder folder;
  folder.write("narrow.toml",
               "[problem]\nkind = \"elastic\"\npoints = { counts = [3, 3] }\nsprings = { bounds = [0.39, 100] }\n");
  const Output fit = run(folder, {"fit", "narrow.toml", "--with", "gauss-newton", "--prune", "--prune-loss", "100",
                                  "--export", "f.json", "--picture", "f.svg"});
  ASSERT_EQ(fit.exit, 0) << fit.err;
  const Value pruned = parse_json(read_file(folder.path() / "f.json"), "f.json");
  const std::set<std::string> kept = ends_of(pruned.at("springs"));
  ASSERT_LT(kept.size(), 20u);
  ASSERT_GE(kept.size(), 14u);  // what rigidity needs under a stretch
  EXPECT_TRUE(contains(
      fit.err, "\npruned: " + std::to_string(20 - kept.size()) + " of 20 springs at the lower bound left out, "))
      << fit.err;
  EXPECT_TRUE(fit.err.ends_with("written: f.json\nwritten: f.svg\n")) << fit.err;

  folder.write("back.toml",
               "[problem]\nkind = \"elastic\"\nbody = { size = [4, 4] }\npoints = { file = \"f.json\" }\nsprings = { "
               "file = \"f.json\" }\n");
  const Value back = evaluated(folder, {"back.toml"});
  EXPECT_EQ(ends_of(back.at("springs")), kept);
  for (std::size_t e = 0; e < kept.size(); ++e)
    EXPECT_EQ(back.at("springs").list()[e].at("stiffness"), pruned.at("springs").list()[e].at("stiffness"));

  Value springs = evaluated(folder, {"narrow.toml"}).at("springs"), whole;
  for (Value& spring : springs.list()) {
    spring.set("stiffness", 1e-13);
    for (const Value& fitted : pruned.at("springs").list())
      if (fitted.at("nodes") == spring.at("nodes")) spring.set("stiffness", fitted.at("stiffness"));
  }
  whole.set("springs", springs);
  folder.write("whole.json", to_json(whole));
  const double quality = back.at("quality").number();
  EXPECT_NEAR(evaluated(folder, {"narrow.toml", "--stiffness", "whole.json"}).at("quality").number(), quality,
              1e-9 * quality);
  // What the last fit said of itself, in its four digits.
  const std::size_t again = fit.err.find("fitted again: gauss-newton, repeat 0: relative error ");
  ASSERT_NE(again, std::string::npos) << fit.err;
  const double said = std::stod(fit.err.substr(again + 53));
  EXPECT_NEAR(back.at("relative_error").number(), said, 5e-4 * said);
}

// Methods that find no way on from an optimum have finished.
TEST(FittedStart, IsAnOptimumWhereLineSearchesHaveFinished) {
  if (!NODAL_HAVE_NLOPT) GTEST_SKIP() << "no NLopt";
  const Folder folder;
  folder.write("plate.toml", "[problem]\nkind = \"elastic\"\n");
  ASSERT_EQ(run(folder, {"fit", "plate.toml", "--with", "gauss-newton", "--export", "fitted.json"}).exit, 0);
  folder.write("again.toml",
               "[study]\nname = \"again\"\nrepeats = 1\n[budget]\nevaluations = 2000\n[problem]\nkind = \"elastic\"\n"
               "springs = { initial = { file = \"fitted.json\" } }\n[[optimizer]]\nuse = \"nlopt-lbfgs\"\n"
               "[[optimizer]]\nuse = \"nlopt-var2\"\n");
  const Output output = run(folder, {"compare", "again.toml"});
  EXPECT_EQ(output.exit, 0) << output.err;
  EXPECT_FALSE(contains(output.out + output.err, "ailed")) << output.out << output.err;
  const Store store = Store::open_existing(folder.path() / "results" / "again");
  ASSERT_EQ(store.records().size(), 2u);
  for (const TrialRecord& record : store.records()) {
    EXPECT_EQ(record.end, End::finished) << record.optimizer << ": " << record.reason;
    ASSERT_TRUE(record.best && record.start.quality);
    EXPECT_NEAR(*record.start.quality, 0.7376255865, 1e-9);  // ten digits are known
    EXPECT_LE(*record.best->summary.quality, *record.start.quality);
  }
  EXPECT_EQ(run(folder, {"fit", "again.toml", "--with", "nlopt-lbfgs", "--export", "again.json"}).exit, 0);
}

// Of a lattice that fits perfectly, and of a fit that is as good as its best known to that one's digits.
TEST(BestStart, IsReachedByEveryTrialAtOnce) {
  const Folder folder;
  const std::string begin = "[study]\nname = \"best\"\nrepeats = 2\n[budget]\nevaluations = 500\n",
                    end =
                        "[[optimizer]]\nuse = \"annealing\"\nbaseline = true\n[[optimizer]]\nuse = \"gauss-newton\"\n"
                        "[[optimizer]]\nuse = \"random-search\"\n";
  folder.write("lattice.toml",
               begin +
                   "[problem]\nkind = \"elastic\"\nmaterial = { poisson = 0.3333333333333333 }\nsprings "
                   "= { initial = \"lattice\" }\n" +
                   end);
  folder.write("plate.toml", "[problem]\nkind = \"elastic\"\n");
  ASSERT_EQ(run(folder, {"fit", "plate.toml", "--with", "gauss-newton", "--export", "fitted.json"}).exit, 0);
  folder.write("known.toml", begin +
                                 "[problem]\nkind = \"elastic\"\nbest_known = { quality = 0.7376, origin = \"four "
                                 "digits\" }\nsprings = { initial = { file = \"fitted.json\" } }\n" +
                                 end);
  for (const std::string study : {"lattice", "known"}) {
    const Output output = run(folder, {"compare", study + ".toml", "--out", study});
    EXPECT_EQ(output.exit, 0) << output.err;
    EXPECT_TRUE(contains(output.out, ", the best there is: every trial has reached each gap at its start; G* = "))
        << output.out;
    EXPECT_FALSE(contains(output.out, "never")) << output.out;
  }
}

// A trust region that shrinks at a bound ends by its own tolerance, with way to go: the user is told so.
TEST(FitAtABound, IsNotCalledConvergedBecauseTheMethodStopped) {
  if (!NODAL_HAVE_CERES) GTEST_SKIP() << "no Ceres";
  const Folder folder;
  folder.write("nodes.csv", "node,x,y\n1,0,0\n2,4,0\n3,2,3\n");
  folder.write("springs.csv", "first,second,stiffness,group\n1,2,5,chord\n1,3,5.5,leg\n2,3,5.5,leg\n");
  folder.write("displacements.csv", "node,ux,uy\n3,0.1,-0.2\n");
  folder.write(
      "groups.toml",
      "[problem]\nkind = \"elastic\"\npoints = { file = \"nodes.csv\" }\nsprings = { file = \"springs.csv\", "
      "parameters = \"groups\" }\nreference = { file = \"displacements.csv\" }\n[[problem.loads.cases]]\nname = "
      "\"load\"\nsupports = [{ nodes = [1] }, { nodes = [2], fix = \"y\" }]\nforces = [{ nodes = [3], force = "
      "[0.373, -1.431] }]\n");
  const Output stopped = run(folder, {"fit", "groups.toml", "--with", "ceres-levenberg-marquardt"});
  EXPECT_EQ(stopped.exit, 0) << stopped.err;
  EXPECT_TRUE(contains(stopped.err, "(finished: ")) << stopped.err;
  EXPECT_TRUE(contains(stopped.err, "\nstopped by the method, not converged: a step of 0.1 % of the box promises "))
      << stopped.err;
  EXPECT_TRUE(contains(stopped.err, "; 1 of 2 coordinates at the upper bound\n")) << stopped.err;
  const Output converged = run(folder, {"fit", "groups.toml", "--with", "gauss-newton"});
  EXPECT_TRUE(contains(converged.err, "\nconverged; k_max/k_min ")) << converged.err;
}

}  // namespace
}  // namespace nodal::program
