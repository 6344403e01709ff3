// SPDX-License-Identifier: GPL-3.0-or-later
// Systems as other programs write them, each read as it is meant or refused in words that name the cause.
//
// All are the same triangle of three springs, whose relative error at the start is known.
#include <gtest/gtest.h>

#include <cstring>

#include <fmt/format.h>

#include <nodal/trial.h>

#include "../study_files.h"

namespace nodal::elastic {
namespace {

// What the selections of the studies' load take, which is told of every load.
constexpr const char* kTakes =
    "load 'load': support of nodes [1]: 1 node; support of nodes [2]: 1 node; force on nodes [3]: 1 node";

class ForeignFiles : public StudyFiles {
 protected:
  ForeignFiles() {
    write("nodes.csv", "node,x,y\n1,0,0\n2,4,0\n3,2,3\n");
    write("springs.csv", "first,second,stiffness\n1,2,5\n1,3,5.5\n2,3,5.5\n");
    write("disp.csv", "node,ux,uy\n3,0.1,-0.2\n");
  }

  static std::string study(const std::string& more_of_points = "", const std::string& more_of_springs = "",
                           const std::string& more_of_reference = "") {
    return "points = { file = \"nodes.csv\"" + more_of_points + " }\nsprings = { file = \"springs.csv\"" +
           more_of_springs + " }\nreference = { file = \"disp.csv\"" + more_of_reference +
           " }\n[[problem.loads.cases]]\nname = \"load\"\nsupports = [{ nodes = [1] }, { nodes = [2], fix = \"y\" "
           "}]\nforces = [{ nodes = [3], force = [0.373, -1.431] }]\n";
  }
  static std::string json_study(const std::string& more_of_springs = "") {
    std::string text = study("", more_of_springs);
    for (const char* file : {"nodes.csv", "springs.csv"}) text.replace(text.find(file), std::strlen(file), "s.json");
    return text;
  }

  double relative_error(const std::string& problem) {
    const auto elastic = read(problem);
    return elastic->solve(elastic->stiffness(elastic->space().start())).relative_error;
  }
  void expect_the_triangle(const std::string& problem, const std::string& what) {
    ASSERT_EQ(refusal(problem), "(nothing was thrown)") << what;
    EXPECT_NEAR(relative_error(problem), 0.371315, 5e-7) << what;
  }
  std::vector<std::string> remarks(const std::string& problem) { return read(problem)->account().remarks(); }
};

TEST_F(ForeignFiles, NodesAreReadWhereTheyAreUnambiguous) {
  expect_the_triangle(study(), "as it should be");
  for (const char* text :
       {"node,x,y\n1,0,0\n2,4,0\n3,2,3", "node,x,y\n1.0,0,0\n2.0,4,0\n3.0,2,3\n", "node,x,y\n1,0,0\n2,4,0\n3,2,3\n,,\n",
        "\"node\";\"x\";\"y\"\n\"1\";\"0\";\"0\"\n\"2\";\"4\";\"0\"\n\"3\";\"2\";\"3\"\n",
        "sep=;\r\nnode;x;y\r\n1;0;0\r\n2;4;0\r\n3;2;3\r\n", "node,x,y,\n1,0,0,\n2,4,0,\n3,2,3,\n",
        "node,x,y\n1,0,0,\n2,4,0,\n3,2,3,\n", "node,x,y,z\n1,0,0,0\n2,4,0,0\n3,2,3,0\n"}) {
    write("nodes.csv", text);
    expect_the_triangle(study(), text);
  }
}

TEST_F(ForeignFiles, DisplacementsAreReadWhereTheyAreUnambiguous) {
  for (const char* text : {"\xEF\xBB\xBFnode,ux,uy\n3,0.1,-0.2\n", "node,ux,uy\n1,0,0\n2,NaN,NaN\n3,0.1,-0.2\n",
                           "node,ux,uy\n1,0,0\n2,-nan(ind),0\n3,0.1,-0.2\n", "node;ux;uy\n3;0.1;-0.2\n",
                           "node,ux,uy,uz\n3,0.1,-0.2,0\n", "x,y,z,ux,uy,uz\n2,3,7,0.1,-0.2,nan\n"}) {
    write("disp.csv", text);
    expect_the_triangle(study(), text);
  }
}

TEST_F(ForeignFiles, ColumnsCanBeNamedAndTheOthersAreSaidToBeLeftOut) {
  write("disp.csv", "d,x,y,ux,uy,true_strain_xx,true_strain_yy\n0,2,3,0.1,-0.2,-9.8e-05,0.0023\n");
  EXPECT_EQ(refusal(study()),
            "disp.csv:1: unknown column 'd'; did you mean 'x', 'y' or 'z'? such a table is read by columns = { x = "
            "\"x\", y = "
            "\"y\", ux = \"ux\", uy = \"uy\" }");
  const std::string named = study("", "", ", columns = { x = \"x\", y = \"y\", ux = \"ux\", uy = \"uy\" }");
  expect_the_triangle(named, "of a measurement");
  EXPECT_EQ(remarks(named),
            (std::vector<std::string>{kTakes, "disp.csv: columns d, true_strain_xx, true_strain_yy are left out"}));

  write("disp.csv", "node,ux,uy\n3,0.1,-0.2\n");
  write("nodes.csv", "id,x [m],y [m]\n1,0,0\n2,4,0\n3,2,3\n");
  expect_the_triangle(study(", columns = { node = \"id\", x = \"x [m]\", y = \"y [m]\" }"), "other names");
  write("nodes.csv", "node,x,y\n1,0,0\n2,4,0\n3,2,3\n");
  write("springs.csv", "bar,from,to,k\nA,1,2,5\nB,1,3,5.5\nC,2,3,5.5\n");
  expect_the_triangle(study("", ", columns = { first = \"from\", second = \"to\", stiffness = \"k\" }"), "springs");
  EXPECT_EQ(refusal(study("", ", columns = {}")),
            "study.toml:6: 'columns' names no column; say which to read, or leave it out");
}

// What a refusal says of 'columns', put where it belongs, reads the table that was refused.
TEST_F(ForeignFiles, AdviceAboutColumnsCanBePasted) {
  struct Row {
    const char *file, *text;
  };
  for (const Row& row : {Row{"nodes.csv", "id,x,y\n1,0,0\n2,4,0\n3,2,3\n"},
                         {"nodes.csv", "Nr,X [m],Y [m],colour\n1,0,0,red\n2,4,0,red\n3,2,3,blue\n"},
                         {"nodes.csv", "nod,x,y\n1,0,0\n2,4,0\n3,2,3\n"},
                         {"springs.csv", "first,second,stifness\n1,2,5\n1,3,5.5\n2,3,5.5\n"},
                         {"springs.csv", "bar,frist,secnd,stiffness\nA,1,2,5\nB,1,3,5.5\nC,2,3,5.5\n"},
                         {"disp.csv", "id,ux,uy\n3,0.1,-0.2\n"},
                         {"disp.csv", "Node,UX (m),UY (m),RZ\n3,0.1,-0.2,7\n"}}) {
    write("nodes.csv", "node,x,y\n1,0,0\n2,4,0\n3,2,3\n");
    write("springs.csv", "first,second,stiffness\n1,2,5\n1,3,5.5\n2,3,5.5\n");
    write("disp.csv", "node,ux,uy\n3,0.1,-0.2\n");
    write(row.file, row.text);
    const std::string message = refusal(study());
    const std::size_t begin = message.find("columns = {");
    ASSERT_NE(begin, std::string::npos) << row.text << message;
    const std::string advice = ", " + message.substr(begin, message.find('}', begin) + 1 - begin);
    const bool nodes = row.file == std::string("nodes.csv"), springs = row.file == std::string("springs.csv");
    expect_the_triangle(study(nodes ? advice : "", springs ? advice : "", nodes || springs ? "" : advice), advice);
  }
}

TEST_F(ForeignFiles, MillimetresAreScaled) {
  write("disp.csv", "x,y,ux,uy\n2000,3000,100,-200\n");
  EXPECT_EQ(refusal(study()),
            "disp.csv:2: there is no node at (2000, 3000); the nearest is node 3 at (2, 3), 3.6e+03 m away; 'scale' "
            "says what "
            "the table's unit of length is");
  expect_the_triangle(study("", "", ", scale = 0.001"), "displacements and places");
  write("nodes.csv", "node,x,y\n1,0,0\n2,4000,0\n3,2000,3000\n");
  write("springs.csv", "first,second,stiffness,length\n1,2,5,4000\n1,3,5.5,3605.55\n2,3,5.5,3605.55\n");
  expect_the_triangle(study(", scale = 0.001", "", ", scale = 0.001"), "nodes and lengths, too");
  // Another scale makes other trials.
  write("disp.csv", "node,ux,uy\n3,100,-200\n");
  const auto key = [&](const char* scale) {
    const std::string text = "[study]\nname = \"b\"\n[budget]\nevaluations = 10\n[problem]\nkind = \"elastic\"\n" +
                             study(", scale = 0.001", "", scale) + "[[optimizer]]\nuse = \"random-search\"\n";
    return trial_key(parse_study(text, directory_.path() / "s.toml", components()), {0, 0, 0});
  };
  EXPECT_NE(key(", scale = 0.001"), key(", scale = 0.002"));
  EXPECT_EQ(key(", scale = 0.001"), key(", scale = 1e-3"));
}

TEST_F(ForeignFiles, WhatIsRefusedIsNamed) {
  const auto refused = [&](const char* file, const std::string& text) {
    const std::string before = file;
    write(file, text);
    const std::string message = refusal(study());
    ForeignFiles::write("nodes.csv", "node,x,y\n1,0,0\n2,4,0\n3,2,3\n");
    ForeignFiles::write("springs.csv", "first,second,stiffness\n1,2,5\n1,3,5.5\n2,3,5.5\n");
    ForeignFiles::write("disp.csv", "node,ux,uy\n3,0.1,-0.2\n");
    return message;
  };
  EXPECT_EQ(refused("nodes.csv", "Node,X,Y\n1,0,0\n"),
            "nodes.csv:1: unknown column 'Node'; did you mean 'node'? such a table is read by columns = { node = "
            "\"Node\", x = "
            "\"X\", y = \"Y\" }");
  EXPECT_EQ(refused("nodes.csv", "node;x;y\r\n1;0,0;0,0\r\n"),
            "nodes.csv:2: 'x' is '0,0'; it must be a finite number; a point is the decimal separator");
  EXPECT_EQ(refused("nodes.csv", "node,x,y\n1,0,0\n2,4,0\n3,2,3\n1,0,0\n"), "nodes.csv:5: node 1 stands twice");
  EXPECT_EQ(refused("nodes.csv", "node,x,y\n-,m,m\n1,0,0\n"),
            "nodes.csv:2: '-,m,m' has no numbers: of lines above the rows there may be one, which names the columns; "
            "put # in "
            "front of others");
  EXPECT_EQ(refused("nodes.csv", "node,x,y,z\n1,0,0,0\n2,4,0,0\n3,2,3,50\n"),
            "nodes.csv:4: z is 50 here and 0 before: a plane system has one z; give x and y in its plane. Systems in "
            "space are read as starts only");
  EXPECT_EQ(
      refused("nodes.csv", "node,x,y\n1,0,0\n2,4,0\n3,2,3\n4,9,9\n"),
      "study.toml:6: the net is a mechanism under the supports of load: 2 motions without resistance move node 4; no "
      "spring ends at node 4: join it, or leave it out");
  EXPECT_EQ(refused("springs.csv", "first,second,stiffness\n1,2,5\n2,1,5\n").substr(0, 52),
            "springs.csv:3: spring (2, 1) stands twice; the other");
  EXPECT_EQ(refused("springs.csv", "first,second,stiffness\n1,2,5\n1,3,0\n2,3,5.5\n"),
            "springs.csv:3: the stiffness is 0; it must be a number > 0");
  EXPECT_EQ(refused("springs.csv", "first,second,stiffness,length\n1,2,5,4\n1,3,5.5,3.6\n2,3,5.5,3.6\n"),
            "springs.csv:3: spring (1, 3) has length 3.6, and its nodes are 3.60555 apart: springs at rest only can be "
            "computed "
            "with; leave the length out if this one is");
  EXPECT_EQ(refused("disp.csv", "node,ux,uy,uz\n3,0.1,-0.2,0.3\n"),
            "disp.csv:2: 'uz' is 0.3: a plane system moves in x and y only; name the columns to be read with "
            "'columns', and it "
            "is left out");
  EXPECT_EQ(refused("disp.csv", "node,ux,uy\n3,N/A,-0.2\n"),
            "disp.csv:2: 'ux' is 'N/A'; it must be a finite number, or empty or NaN where nothing was measured");
  EXPECT_EQ(refusal("loads = { supports = \"minimal\" }\nreference = { scale = 2 }\n"),
            "study.toml:6: 'scale' in 'reference' belongs to a 'file'");
  EXPECT_EQ(refusal("points = { scale = 2 }\n"),
            "study.toml:5: 'scale' belongs to layout 'file', and this one is 'grid'");
  EXPECT_EQ(refusal("springs = { columns = { first = \"a\" } }\n"),
            "study.toml:5: 'columns' belongs to a 'file' of springs");
}

// ── system files in JSON

TEST_F(ForeignFiles, JsonIsReadByItsKeys) {
  for (
      const char* text :
      {R"({"nodes":[{"node":1,"x":0,"y":0},{"node":2,"x":4,"y":0},{"node":3,"x":2,"y":3}],
 "springs":[{"nodes":[1,2],"stiffness":5},{"nodes":[1,3],"stiffness":5.5},{"nodes":[2,3],"stiffness":5.5}]})",
       R"({"schema":1,"nodes":[{"node":1,"x":0,"y":0,"z":7},{"node":2,"x":4,"y":0,"z":7.0},{"node":3,"x":2,"y":3,"z":7}],
 "springs":[{"nodes":[1,2],"stiffness":5,"length":4},{"nodes":[1,3],"stiffness":5.5,"length":3.60555},{"nodes":[2,3],"stiffness":5.5}]})"}) {
    write("s.json", text);
    expect_the_triangle(json_study(), text);
  }
  EXPECT_EQ(remarks(json_study()), (std::vector<std::string>{"s.json: z, 7 everywhere, is left out", kTakes}));
}

TEST_F(ForeignFiles, JsonGroupsTieSprings) {
  write("s.json", R"({"nodes":[{"node":1,"x":0,"y":0},{"node":2,"x":4,"y":0},{"node":3,"x":2,"y":3}],
 "springs":[{"nodes":[1,2],"stiffness":5,"group":"chord"},{"nodes":[1,3],"stiffness":5.5,"group":"leg"},{"nodes":[2,3],"stiffness":5.5,"group":"leg"}]})");
  expect_the_triangle(json_study(), "free");
  expect_the_triangle(json_study(", parameters = \"groups\""), "tied");
  EXPECT_EQ(read(json_study(", parameters = \"groups\""))->parameters().size(), 2u);
}

TEST_F(ForeignFiles, JsonOfAnotherMeaningIsRefused) {
  const auto refused = [&](const std::string& nodes, const std::string& springs, const std::string& more = "") {
    write("s.json", "{\"nodes\":[" + nodes + "],\n\"springs\":[" + springs + "]" + more + "}");
    return refusal(json_study());
  };
  const std::string nodes = R"({"node":1,"x":0,"y":0},{"node":2,"x":4,"y":0},{"node":3,"x":2,"y":3})";
  const std::string springs =
      R"({"nodes":[1,2],"stiffness":5},{"nodes":[1,3],"stiffness":5.5},{"nodes":[2,3],"stiffness":5.5})";
  EXPECT_EQ(refused(nodes, springs), "(nothing was thrown)");
  EXPECT_EQ(refused(nodes, R"({"nodes":[1,2],"stifness":5})"),
            "s.json:2: unknown key 'stifness' in a spring; did you mean 'stiffness'?");
  EXPECT_EQ(refused(R"({"id":1,"x":0,"y":0})", springs),
            "s.json:1: unknown key 'id' in a node; valid: 'node', 'x', 'y', 'z', 'mass'");
  EXPECT_EQ(
      refused(R"({"node":1,"x":0,"y":0,"z":0},{"node":2,"x":4,"y":0,"z":0},{"node":3,"x":2,"y":3,"z":50})", springs),
      "s.json:1: z is 50 here and 0 before: a plane system has one z; give x and y in its plane. Systems in "
      "space are read as starts only");
  EXPECT_EQ(refused(R"({"node":1,"x":0,"y":0,"z":0},{"node":2,"x":4,"y":0})", springs),
            "s.json:1: some points have a z and others don't; give x and y only, the system is plane");
  EXPECT_EQ(refused(nodes, R"({"nodes":[1,2],"stiffness":5,"length":3.0})"),
            "s.json:2: spring (1, 2) has length 3, and its nodes are 4 apart: springs at rest only can be computed "
            "with; leave "
            "the length out if this one is");
  EXPECT_EQ(refused(nodes, R"({"nodes":[1,2],"group":"a"},{"nodes":[1,3]})"),
            "s.json:2: the group is missing; give it everywhere or nowhere");
  EXPECT_EQ(refused(nodes, R"({"nodes":[1,2],"group":3})"), "s.json:2: \"group\" must be a text that is not empty");
  EXPECT_EQ(refused(nodes, springs, ",\n\"schema\":2,\"kinds\":[]"),
            "s.json:3: the file has schema 2, this build reads up to 1; use a newer nodal");
  EXPECT_EQ(refused(nodes, springs, ",\n\"links\":[]"),
            "s.json:3: unknown key 'links' in a system file; valid: 'schema', 'bounds', 'nodes', 'springs'");
  write("s.json", R"({"nodes":[{"node":1,"x":0,"y":0},{"node":2,"x":4,"y":0}]})");
  EXPECT_EQ(refusal(json_study()), "s.json: a system file must have a list \"springs\"");
  write("s.json", "{\"springs\":[" + springs + "]}");
  EXPECT_EQ(refusal(json_study()), "s.json: a system file must have a list \"nodes\"");
  write("s.json", "{\"directed\":false}");
  EXPECT_EQ(refusal(json_study()), "s.json: a system file is {\"nodes\": […], \"springs\": […]}");
  std::string named = json_study();
  named.replace(named.find("s.json\""), 7, "s.json\", columns = { x = \"x\" }");
  EXPECT_EQ(refusal(named), "study.toml:5: 'columns' belongs to a CSV file, and this one is JSON");
}

}  // namespace
}  // namespace nodal::elastic
