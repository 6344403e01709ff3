// SPDX-License-Identifier: GPL-3.0-or-later
// Says whether two stores have the same set of trials, to the last bit but for what the clock says. Exit code 1 where
// they don't, have none, or hold a trial twice: a store shows each once, whoever ran it again.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <string>

#include <nodal/store.h>
#include <nodal/verify.h>

namespace {

std::map<std::string, std::string> outcomes(const char* directory) {
  std::map<std::string, std::string> found;
  const nodal::Store store = nodal::Store::open_existing(directory);
  for (const nodal::TrialRecord& record : store.records()) found[record.key] = to_json_line(nodal::untimed(record));
  return found;
}

bool each_once(const std::filesystem::path& directory, std::size_t trials) {
  std::size_t lines = 0;
  for (const auto& file : std::filesystem::directory_iterator(directory / "trials")) {
    std::ifstream in(file.path());
    for (std::string line; std::getline(in, line);) ++lines;
  }
  if (lines == trials) return true;
  std::cerr << directory << " holds " << lines << " records of " << trials << " trials\n";
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: same_trials STORE STORE\n";
    return 2;
  }
  const auto one = outcomes(argv[1]), other = outcomes(argv[2]);
  for (const auto& [key, line] : one)
    if (const auto found = other.find(key); found == other.end())
      std::cerr << "only in '" << argv[1] << "': " << line << '\n';
    else if (found->second != line)
      std::cerr << "differ: " << line << "\n   and: " << found->second << '\n';
  for (const auto& [key, line] : other)
    if (!one.contains(key)) std::cerr << "only in '" << argv[2] << "': " << line << '\n';
  std::cout << one.size() << " and " << other.size() << " trials\n";
  const bool once = each_once(argv[1], one.size()) && each_once(argv[2], other.size());
  return one.empty() || one != other || !once ? 1 : 0;
}
