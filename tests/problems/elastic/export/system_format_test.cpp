// SPDX-License-Identifier: GPL-3.0-or-later
// The formats that systems are written in, and what is read back of them.
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <set>

#include <nodal/elastic/stiffness.h>
#include <nodal/exhibit.h>
#include <nodal/random.h>

#include "../study_files.h"
#include "export/system_format.h"

namespace nodal::elastic {
namespace {

class Formats : public StudyFiles {
 protected:
  std::vector<double> random_stiffness() const {
    RandomStream random(5);
    std::vector<double> k(plate_->net().springs.size());
    for (double& e : k) e = std::exp(random.uniform(-4.0, 4.0));
    return k;
  }

  std::shared_ptr<const ElasticProblem> plate_ = make_plate({.counts = "[4, 3]"});
};

// As people and --export tell them apart.
TEST_F(Formats, AreToldApartByNameAndEnding) {
  std::set<std::string_view> names, endings;
  for (const SystemFormat* format : system_formats()) {
    EXPECT_TRUE(names.insert(format->name).second) << format->name << " is listed twice";
    EXPECT_TRUE(endings.insert(format->extension).second) << format->extension << " is listed twice";
    ASSERT_GE(format->extension.size(), 2u);
    EXPECT_EQ(format->extension[0], '.');
    EXPECT_TRUE(std::ranges::none_of(format->extension, [](unsigned char c) { return std::isupper(c); }));
    EXPECT_FALSE(format->summary.empty()) << format->name;
    ASSERT_NE(format->write, nullptr) << format->name;
  }
  EXPECT_NE(system_formats().front()->read, nullptr);  // what ends in nothing known is read as the first
}

TEST_F(Formats, AreWhatTheExhibitOffersAndWrites) {
  const std::vector<double> k = random_stiffness();
  const std::vector<ExportFormat> offered = plate_->exhibit()->formats();
  ASSERT_EQ(offered.size(), system_formats().size());
  for (std::size_t i = 0; i < offered.size(); ++i) {
    EXPECT_EQ(offered[i].name, system_formats()[i]->name);
    EXPECT_EQ(offered[i].extension, system_formats()[i]->extension);
    EXPECT_EQ(plate_->exhibit()->write(offered[i], k), system_formats()[i]->write(*plate_, k));
  }
  EXPECT_EQ(plate_->exhibit()->write(offered[0], k), system_json(*plate_, k));
  EXPECT_THROW((void)plate_->exhibit()->write({"none of these", ".json", "JSON"}, k), std::logic_error);
}

// To the last bit, by every format that says it can be.
TEST_F(Formats, AreReadBackByWhatAFileEndsIn) {
  const std::vector<double> k = random_stiffness();
  for (const SystemFormat* format : system_formats()) {
    if (!format->read) continue;
    const std::string name = "fitted" + std::string(format->extension);
    write(name, format->write(*plate_, k));
    EXPECT_EQ(plate_->exhibit()->read(directory_.path() / name), k) << name;
  }
  write("fitted", system_json(*plate_, k));
  EXPECT_EQ(plate_->exhibit()->read(directory_.path() / "fitted"), k);
}

// A start of springs of one's own that have no bounds is read twice: for its bounds, too.
TEST_F(Formats, OfAStartAreReadTheSameWayForItsBounds) {
  write("nodes.csv", "x,y\n0,0\n1,0\n0,1\n");
  write("springs.csv", "first,second\n0,1\n1,2\n0,2\n");
  for (const SystemFormat* format : system_formats()) {
    if (format->read) continue;
    const std::string name = "start" + std::string(format->extension);
    write(name, format->write(*plate_, random_stiffness()));
    EXPECT_PRED2(
        says,
        refusal("points = { file = \"nodes.csv\" }\nsprings = { file = \"springs.csv\", initial = { file = \"" + name +
                "\" } }\n[[problem.loads.cases]]\nname = \"pull\"\nsupports = [{ nodes = [0] }, { nodes = "
                "[1], fix = \"y\" }]\nforces = [{ nodes = [2], force = [1, 0] }]\n"),
        name + ": stiffnesses can't be read back from " + std::string(format->summary));
  }
}

TEST_F(Formats, ThatCantBeReadBackSayWhichCan) {
  static constexpr SystemFormat lines = {
      .name = "lines",
      .extension = ".obj",
      .summary = "OBJ",
      .write = [](const ElasticProblem&, const std::vector<double>&) { return std::string(); }};
  const std::array formats = {system_formats().front(), &lines};
  write("fitted.OBJ", "");
  InputFiles files(directory_.path());
  const std::string path = files.path("fitted.OBJ").string();
  EXPECT_EQ(toy::message_of([&] { (void)read_back(formats, files, path, plate_->net()); }),
            path + ": stiffnesses can't be read back from OBJ, only from JSON (.json)");
}

}  // namespace
}  // namespace nodal::elastic
