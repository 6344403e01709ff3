// SPDX-License-Identifier: GPL-3.0-or-later
#include "program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace nodal::program {

namespace {

int pipe_without_reader() {
  int ends[2];
  if (::pipe(ends) != 0) ::_exit(125);
  ::close(ends[0]);
  return ends[1];
}

void redirect(Stdout out) {
  if (out == Stdout::full) ::dup2(::open("/dev/full", O_WRONLY), STDOUT_FILENO);
  if (out == Stdout::closed) ::close(STDOUT_FILENO);
  if (out == Stdout::gone || out == Stdout::both_gone) ::dup2(pipe_without_reader(), STDOUT_FILENO);
  if (out == Stdout::both_gone) ::dup2(STDOUT_FILENO, STDERR_FILENO);
}

[[noreturn]] void become_program(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                                 Stdout where) {
  if (::chdir(folder.c_str()) != 0) ::_exit(126);
  const int out = ::open("stdout", O_CREAT | O_TRUNC | O_WRONLY, 0666),
            err = ::open("stderr", O_CREAT | O_TRUNC | O_WRONLY, 0666);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  redirect(where);
  std::vector<char*> words = {const_cast<char*>(NODAL_PROGRAM)};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  ::execv(NODAL_PROGRAM, words.data());
  ::_exit(127);
}

}  // namespace

Folder::Folder() {
  std::string name = (std::filesystem::temp_directory_path() / "nodal_test_XXXXXX").string();
  if (!::mkdtemp(name.data())) throw std::runtime_error("mkdtemp failed");
  path_ = name;
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path Folder::write(const std::string& name, const std::string& text) const {
  std::ofstream(path_ / name, std::ios::binary) << text;
  return path_ / name;
}

Started::Started(const Folder& folder, const std::vector<std::string>& arguments, Stdout out)
    : folder_(folder), process_(::fork()) {
  if (process_ == 0) become_program(folder.path(), arguments, out);
}

Output Started::wait() {
  int status = 0;
  ::waitpid(process_, &status, 0);
  return {WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status), read_file(folder_.path() / "stdout"),
          read_file(folder_.path() / "stderr")};
}

Output run(const Folder& folder, const std::vector<std::string>& arguments, Stdout out) {
  return Started(folder, arguments, out).wait();
}

std::string read_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::size_t count_lines(const std::filesystem::path& directory) {
  std::size_t lines = 0;
  if (!std::filesystem::is_directory(directory)) return 0;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    const std::string text = read_file(entry.path());
    lines += static_cast<std::size_t>(std::ranges::count(text, '\n'));
  }
  return lines;
}

bool wait_for_lines(const std::filesystem::path& directory, std::size_t wanted) {
  for (int i = 0; i < 600; ++i) {
    if (count_lines(directory) >= wanted) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return false;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace nodal::program
