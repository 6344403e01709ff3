// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Studies with files beside them, in a directory of the test's own.

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "../../support/messages.h"
#include "../../support/temporary_directory.h"
#include "plate.h"

namespace nodal::elastic {

class StudyFiles : public testing::Test {
 protected:
  void write(const std::string& file, const std::string& text) { std::ofstream(directory_.path() / file) << text; }

  std::shared_ptr<const ElasticProblem> read(const std::string& problem) {
    return as_elastic(parse_study("[study]\nname = \"brought\"\n[problem]\nkind = \"elastic\"\n" + problem,
                                  directory_.path() / "study.toml", components()));
  }
  // What reading it complains of, without the directory.
  std::string refusal(const std::string& problem) {
    std::string message = toy::message_of([&] { (void)read(problem); });
    const std::string path = directory_.path().string() + "/";
    for (std::size_t at = message.find(path); at != std::string::npos; at = message.find(path))
      message.erase(at, path.size());
    return message;
  }

  toy::TemporaryDirectory directory_;
};

/// Three nodes, 1 (0, 0), 2 (4, 0), 3 (2, 3), joined by three springs; one load, a force on the node near a place.
class SmallSystem : public StudyFiles {
 protected:
  std::string study(const std::string& near) {
    write("nodes.csv", "node,x,y\n1,0,0\n2,4,0\n3,2,3\n");
    write("springs.csv", "first,second\n1,2\n1,3\n2,3\n");
    write("displacements.csv", "node,ux,uy\n3,0.1,-0.2\n");
    return "points = { file = \"nodes.csv\" }\nsprings = { file = \"springs.csv\" }\nreference = { file = "
           "\"displacements.csv\" }\n[[problem.loads.cases]]\nname = \"load\"\nsupports = [{ nodes = [1] }, { nodes = "
           "[2], fix = \"y\" }]\nforces = [{ near = " +
           near + ", force = [0.373, -1.431] }]\n";
  }
};

/// Whether a message has a part; for EXPECT_PRED2.
inline bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The nodes that a support group holds, ascending.
inline std::vector<std::size_t> held_nodes(const ElasticProblem& problem, std::size_t group = 0) {
  std::vector<std::size_t> nodes;
  for (const Support& s : problem.scene().loads.groups[group].supports)
    if (nodes.empty() || nodes.back() != s.node) nodes.push_back(s.node);
  return nodes;
}

}  // namespace nodal::elastic
