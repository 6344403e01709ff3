// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Studies of systems brought from elsewhere, with their files in a directory of their own.

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <string>

#include "../../support/messages.h"
#include "../../support/temporary_directory.h"
#include "plate.h"

namespace nodal::elastic {

class BroughtFiles : public testing::Test {
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

}  // namespace nodal::elastic
