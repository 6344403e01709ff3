// SPDX-License-Identifier: GPL-3.0-or-later
#include "child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace nodal {

namespace {

constexpr int kWorkThrew = 70;

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

// What the child does; it never returns into the copy of the parent's stack.
[[noreturn]] void run_child(const std::function<std::string()>& work, int out, pid_t parent) {
  ::signal(SIGINT, SIG_IGN);
  ::signal(SIGTERM, SIG_DFL);
  ::signal(SIGPIPE, SIG_DFL);  // a program may ignore it for its own output
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(kWorkThrew);  // the parent was gone before the line above
  int status = kWorkThrew;
  try {
    if (write_all(out, work())) status = 0;
  } catch (...) {
  }
  ::_exit(status);
}

}  // namespace

ChildProcess::ChildProcess(const std::function<std::string()>& work, Clock::time_point deadline) : deadline_(deadline) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t parent = ::getpid();
  process_ = ::fork();
  if (process_ < 0) {
    const int error = errno;
    ::close(ends[0]);
    ::close(ends[1]);
    throw std::system_error(error, std::generic_category(), "fork");
  }
  if (process_ == 0) run_child(work, ends[1], parent);
  ::close(ends[1]);
  pipe_ = ends[0];
}

ChildProcess::~ChildProcess() {
  if (process_ > 0) {
    kill();
    (void)finish();
  }
  if (pipe_ >= 0) ::close(pipe_);
}

bool ChildProcess::read_more() {
  char buffer[65536];
  const ssize_t got = ::read(pipe_, buffer, sizeof buffer);
  if (got < 0) return errno != EINTR;
  output_.append(buffer, static_cast<std::size_t>(got));
  return got == 0;
}

std::optional<std::string> ChildProcess::finish() {
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  if (WIFSIGNALED(status))
    return "signal " + std::to_string(WTERMSIG(status)) + " (" + ::strsignal(WTERMSIG(status)) + ")";
  if (WEXITSTATUS(status) != 0) return "exit status " + std::to_string(WEXITSTATUS(status));
  return std::nullopt;
}

void ChildProcess::kill() noexcept {
  if (process_ > 0) ::kill(process_, SIGKILL);
}

}  // namespace nodal
