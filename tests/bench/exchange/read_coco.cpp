// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <regex>
#include <set>

#include "read_back.h"

namespace nodal::exchange::read_back {

namespace fs = std::filesystem;

namespace {

using Header = std::map<std::string, std::string>;

// "The 1st line should be a valid Python code when surrounded like dict(…)": as cocopp's parseinfo takes it apart.
Header parse_header(const std::string& line) {
  static const std::regex pair(R"( *([^,=]+?) *= *(".*?"|'.*?'|[^,]+) *(?=,|$))");
  Header header;
  for (std::sregex_iterator it(line.begin(), line.end(), pair), end; it != end; ++it) header[(*it)[1]] = (*it)[2];
  return header;
}

std::string unquoted(const std::string& text) {
  return text.size() >= 2 && text.front() == '\'' && text.back() == '\'' ? text.substr(1, text.size() - 2) : "";
}

// Suites that cocopp has a test bed for, of one objective; formats that it can read.
const std::set<std::string> kSuites = {"bbob", "bbob-noisy", "bbob-constrained", "bbob-largescale", "bbob-mixint"};
const std::set<std::string> kFormats = {"bbob", "bbob-old", "bbob-new", "bbob-new2"};

class InfoReader {
 public:
  InfoReader(const fs::path& info, Read& read) : info_(info), read_(read) {}

  void all() {
    const std::vector<std::string> lines = lines_of(info_);
    if (lines.empty() || lines.size() % 3 != 0) return fault("entries have three lines each");
    for (std::size_t i = 0; i < lines.size(); i += 3) entry(lines[i], lines[i + 1], lines[i + 2]);
  }

 private:
  void fault(const std::string& what) { read_.faults.push_back(info_.string() + ": " + what); }

  void entry(const std::string& first, const std::string& comment, const std::string& data) {
    const Header header = parse_header(first);
    for (const char* key : {"suite", "funcId", "DIM", "Precision", "algId", "logger", "data_format"})
      if (!header.contains(key)) return fault(std::string("no ") + key);
    check_header(first, header);
    if (!comment.starts_with('%')) fault("the second line is a comment, which begins with %");
    if (data.find('=') != std::string::npos) fault("'=' in the third line would be a key of another format");
    DataSet set;
    set.algorithm = unquoted(header.at("algId"));
    set.function = std::stoll(header.at("funcId"));
    set.dimension = std::stoll(header.at("DIM"));
    third_line(data, set);
    read_.sets.push_back(set);
  }

  void check_header(const std::string& first, const Header& header) {
    if (!kSuites.contains(unquoted(header.at("suite")))) fault("a suite that cocopp doesn't know");
    if (!kFormats.contains(unquoted(header.at("data_format")))) fault("a data format that cocopp doesn't know");
    if (std::stod(header.at("Precision")) != 1e-8) fault("COCO's final target is 1e-8");
    // IOHinspector takes the keys in this order only.
    static const std::regex order(
        R"(^suite\s*=\s*'[^']+',\s*funcId\s*=\s*\d+,\s*DIM\s*=\s*\d+,\s*Precision\s*=\s*[0-9.eE+-]+,\s*algId\s*=\s*'[^']+'(,\s*coco_version\s*=\s*'[^']*')?(,\s*logger\s*=\s*'[^']*')?(,\s*data_format\s*=\s*'[^']*')?$)");
    if (!std::regex_match(first, order)) fault("keys in an order that IOHinspector doesn't read");
    // IOHanalyzer parts values at every comma.
    for (const auto& [key, value] : header)
      if (value.find(',') != std::string::npos) fault("a comma in the value of " + key);
  }

  void third_line(const std::string& line, DataSet& set) {
    static const std::regex run_text(R"((\d+):(\d+)\|([-+eE0-9.]+))");
    std::size_t end = line.find(", ");
    const std::string file = line.substr(0, end);
    if (!file.ends_with(".dat") || file.find(' ') != std::string::npos) fault("the third line begins with a .dat file");
    while (end != std::string::npos) {
      const std::size_t next = line.find(", ", end + 2);
      const std::string word = line.substr(end + 2, next == std::string::npos ? next : next - end - 2);
      std::smatch parts;
      if (!std::regex_match(word, parts, run_text)) return fault("'" + word + "' is no instance:evaluations|precision");
      set.runs.push_back({std::stoll(parts[1]), std::stoll(parts[2]), std::stod(parts[3]), {}});
      end = next;
    }
    const fs::path data = info_.parent_path() / file;
    fs::path times = data;
    read_data(data, set, true);
    read_data(times.replace_extension(".tdat"), set, false);
  }

  // .dat files are kept, .tdat files only checked.
  void read_data(const fs::path& file, DataSet& set, bool keep) {
    if (!fs::is_regular_file(file)) return fault(file.string() + " is not there");
    std::vector<std::vector<Row>> runs;
    for (const std::string& line : lines_of(file)) {
      if (line.starts_with('%')) {
        if (!line.starts_with("% f evaluations | g evaluations | best noise-free fitness - F"))
          fault("a header that IOHanalyzer doesn't take for COCO's");
        runs.emplace_back();
        continue;
      }
      const std::vector<double> numbers = numbers_of(line, file.string(), read_);
      if (runs.empty() || numbers.size() != 5) return fault(file.string() + ": five columns after a header");
      if (numbers[1] != 0.0) fault(file.string() + ": evaluations of constraints that are none");
      runs.back().push_back({static_cast<std::int64_t>(numbers[0]), numbers[2], {numbers[3], numbers[4]}});
    }
    if (runs.size() != set.runs.size())
      return fault(file.string() + ": another number of runs than the .info file has");
    for (std::size_t i = 0; i < runs.size(); ++i) {
      check_run(file, runs[i], set.runs[i]);
      if (keep) set.runs[i].rows = runs[i];
    }
  }

  void check_run(const fs::path& file, const std::vector<Row>& rows, const Run& run) {
    // cocopp asserts it of all its data.
    if (rows.empty() || rows.front().evaluation != 1) return fault(file.string() + ": a run begins at evaluation 1");
    for (std::size_t i = 1; i < rows.size(); ++i) {
      if (rows[i].evaluation <= rows[i - 1].evaluation) fault(file.string() + ": evaluations must rise");
      if (rows[i].precision > rows[i - 1].precision) fault(file.string() + ": the best precision can't rise");
    }
    if (rows.back().evaluation != run.evaluations)
      fault(file.string() + ": 'difference between the maxevals in the *.info file and in the data files'");
    if (std::abs(rows.back().precision - run.final_precision) > 0.051 * std::abs(run.final_precision))
      fault(file.string() + ": the last precision is not the .info file's, to its two digits");
  }

  const fs::path& info_;
  Read& read_;
};

}  // namespace

Read read_coco(const fs::path& folder) {
  Read read;
  for (const fs::path& info : files_below(folder, ".info")) InfoReader(info, read).all();
  if (read.sets.empty()) read.faults.push_back("no .info file");
  return read;
}

}  // namespace nodal::exchange::read_back
