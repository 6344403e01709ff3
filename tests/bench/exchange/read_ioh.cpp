// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <sstream>

#include <nodal/file.h>
#include <nodal/value.h>

#include "read_back.h"

namespace nodal::exchange::read_back {

namespace fs = std::filesystem;

namespace {

// IOHinspector keeps these as UInt16.
constexpr std::int64_t kLargest = std::numeric_limits<std::uint16_t>::max();

// compareVersion(version, "0.3.3") >= 0 makes IOHanalyzer take the columns by their names.
bool is_new(const std::string& version) {
  std::istringstream in(version);
  int a = 0, b = 0, c = 0;
  char dot = 0;
  in >> a >> dot >> b >> dot >> c;
  return !in.fail() && std::tuple(a, b, c) >= std::tuple(0, 3, 3);
}

class JsonReader {
 public:
  JsonReader(const fs::path& file, Read& read) : file_(file), read_(read) {}

  void all() {
    const Value data = parse_json(read_file(file_, "json file"), file_.string());
    for (const char* key :
         {"version", "suite", "function_id", "function_name", "maximization", "algorithm", "attributes", "scenarios"})
      if (!data.find(key)) return fault(std::string("no ") + key);
    if (!is_new(data.at("version").text())) fault("an older version's columns have other names");
    if (data.at("maximization").boolean()) fault("qualities are minimized");
    for (const char* key : {"name", "info"})
      if (data.at("algorithm").text_or(key, "").empty()) fault(std::string("the algorithm has no ") + key);
    for (const Value& name : data.at("attributes").list()) columns_.push_back(name.text());
    if (columns_.size() < 2 || columns_[0] != "evaluations" || columns_[1] != "raw_y")
      return fault("the columns begin with evaluations and raw_y");
    check_experiment(data);
    for (const Value& scenario : data.at("scenarios").list()) read_scenario(data, scenario);
  }

 private:
  void fault(const std::string& what) { read_.faults.push_back(file_.string() + ": " + what); }

  // IOHinspector evaluates these texts as Python: nothing but numbers may stand there.
  void check_experiment(const Value& data) {
    const Value* attributes = data.find("experiment_attributes");
    if (!attributes) return;
    for (const Value& one : attributes->list())
      for (const auto& [name, value] : one.table()) {
        (void)numbers_of(value.text(), file_.string(), read_);
        if (value.text().find_first_of(".e") == std::string::npos) fault("a whole number would be another type");
      }
  }

  void read_scenario(const Value& data, const Value& scenario) {
    DataSet set;
    set.algorithm = data.at("algorithm").at("name").text();
    set.function_name = data.at("function_name").text();
    set.function = data.at("function_id").integer();
    set.dimension = scenario.at("dimension").integer();
    if (set.function < 1 || set.function > kLargest || set.dimension < 1 || set.dimension > kLargest)
      fault("an id or a dimension out of range");
    const fs::path path = file_.parent_path() / scenario.at("path").text();
    if (!fs::is_regular_file(path)) return fault(path.string() + " is not there");
    for (const Value& run : scenario.at("runs").list())
      set.runs.push_back(
          {run.at("instance").integer(), run.at("evals").integer(), run.at("best").at("y").number(), {}});
    read_rows(path, set);
    const Value::List& runs = scenario.at("runs").list();
    for (std::size_t i = 0; i < set.runs.size(); ++i) check_run(path, set.runs[i], runs[i].at("best"), set.dimension);
    read_.sets.push_back(set);
  }

  // A run begins with the header, or by IOHinspector's count with a line of evaluation 1: it must be both.
  void read_rows(const fs::path& path, DataSet& set) {
    std::string header;
    for (const std::string& name : columns_) header += (header.empty() ? "" : " ") + name;
    std::size_t runs = 0;
    for (const std::string& line : lines_of(path)) {
      if (line == header) {
        ++runs;
        continue;
      }
      const std::vector<double> numbers = numbers_of(line, path.string(), read_);
      if (runs == 0 || runs > set.runs.size() || numbers.size() != columns_.size())
        return fault(path.string() + ": '" + line + "' is no line of a run");
      set.runs[runs - 1].rows.push_back(
          {static_cast<std::int64_t>(numbers[0]), numbers[1], {numbers.begin() + 2, numbers.end()}});
    }
    if (runs != set.runs.size()) fault(path.string() + ": another number of runs than the .json file has");
  }

  void check_run(const fs::path& path, const Run& run, const Value& best, std::int64_t dimension) {
    if (run.rows.empty() || run.rows.front().evaluation != 1) return fault(path.string() + ": a run begins at 1");
    for (std::size_t i = 1; i < run.rows.size(); ++i)
      if (run.rows[i].evaluation <= run.rows[i - 1].evaluation) fault(path.string() + ": evaluations must rise");
    if (run.rows.back().evaluation != run.evaluations) fault(path.string() + ": 'evals' is not the last evaluation");
    const auto least = std::ranges::min_element(run.rows, {}, &Row::precision);
    if (least->precision != best.at("y").number() || least->evaluation != best.at("evals").integer())
      fault(path.string() + ": 'best' is no line of the run");
    const std::size_t size = best.at("x").list().size();
    if (size != 0 && size != static_cast<std::size_t>(dimension)) fault(path.string() + ": 'x' of another dimension");
    if (best.table().size() != 3) fault("IOHinspector makes a Solution of evals, y and x, and of nothing else");
  }

  const fs::path& file_;
  Read& read_;
  std::vector<std::string> columns_;
};

}  // namespace

Read read_ioh(const fs::path& folder) {
  Read read;
  for (const fs::path& file : files_below(folder, ".json")) JsonReader(file, read).all();
  if (read.sets.empty()) read.faults.push_back("no .json file");
  return read;
}

}  // namespace nodal::exchange::read_back
