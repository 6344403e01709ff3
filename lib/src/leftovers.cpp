// SPDX-License-Identifier: GPL-3.0-or-later
#include "leftovers.h"

#include <signal.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <string>
#include <vector>

namespace nodal {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::minutes kSurelyAbandoned{1};

// The process in "NAME.PROCESS.part"; 0 for other names.
pid_t writer_of(const fs::path& file) {
  if (file.extension() != ".part") return 0;
  const std::string number = file.stem().extension().string();  // ".PROCESS"
  pid_t process = 0;
  const char* end = number.data() + number.size();
  if (number.size() < 2 || std::from_chars(number.data() + 1, end, process).ptr != end) return 0;
  return process;
}

bool is_abandoned(const fs::directory_entry& entry) {
  const pid_t writer = writer_of(entry.path());
  if (writer <= 0 || !entry.is_regular_file()) return false;
  const bool is_dead = ::kill(writer, 0) != 0 && errno == ESRCH;
  return is_dead && fs::file_time_type::clock::now() - entry.last_write_time() > kSurelyAbandoned;
}

}  // namespace

void remove_leftovers(const fs::path& directory) noexcept {
  try {
    std::vector<fs::path> abandoned;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory))
      if (is_abandoned(entry)) abandoned.push_back(entry.path());
    std::error_code ignored;
    for (const fs::path& file : abandoned) fs::remove(file, ignored);
  } catch (const std::exception&) {  // scraps are no reason not to run
  }
}

}  // namespace nodal
