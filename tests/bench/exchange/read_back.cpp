// SPDX-License-Identifier: GPL-3.0-or-later
#include "read_back.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace nodal::exchange::read_back {

namespace fs = std::filesystem;

std::vector<fs::path> files_below(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == extension) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::vector<std::string> lines;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<double> numbers_of(const std::string& line, const std::string& place, Read& read) {
  std::vector<double> numbers;
  std::size_t begin = 0;
  while (begin <= line.size()) {
    const std::size_t end = std::min(line.find(' ', begin), line.size());
    const std::string word = line.substr(begin, end - begin);
    char* rest = nullptr;
    numbers.push_back(std::strtod(word.c_str(), &rest));
    if (word.empty() || *rest != '\0') read.faults.push_back(place + ": '" + word + "' is no number");
    begin = end + 1;
  }
  return numbers;
}

}  // namespace nodal::exchange::read_back
