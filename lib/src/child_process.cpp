// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/child_process.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <initializer_list>
#include <system_error>
#include <type_traits>

#include <nodal/file.h>

namespace nodal {

namespace {

static_assert(std::is_same_v<pid_t, int>);  // as the header has it, which knows no system

constexpr int kWorkThrew = 70;
// A killed process is gone at once, unless the kernel waits for a device or a server on its behalf.
constexpr int kMostMicrosecondsToDie = 2'000'000;
// Most have only to give their memory back: who comes again a millisecond later has lost it at every trial.
constexpr int kFirstMicroseconds = 30, kMostMicrosecondsAtOnce = 1000;

// What the child does; it never returns into the copy of the parent's stack.
[[noreturn]] void run_child(const std::function<std::string()>& work, int out, pid_t parent) {
  ::setpgid(0, 0);
  // Being of a group in the background, it would also be stopped by the terminal for reading and writing there.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGTTIN, SIGTTOU, SIGTSTP}) ::signal(signal, SIG_IGN);
  ::signal(SIGPIPE, SIG_DFL);  // a program may ignore it for its own output
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(kWorkThrew);  // the parent was gone before the line above
  int status = kWorkThrew;
  try {
    if (write_all(out, work() + "\n") == 0) status = 0;
  } catch (...) {
  }
  ::_exit(status);
}

}  // namespace

ChildProcess::ChildProcess(const std::function<std::string()>& work) {
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
  if (process_ == 0) {
    ::close(ends[0]);
    run_child(work, ends[1], parent);
  }
  ::setpgid(process_, process_);  // here too: whoever comes first
  group_ = process_;
  ::close(ends[1]);
  pipe_ = ends[0];
  ::fcntl(pipe_, F_SETFL, O_NONBLOCK);
}

ChildProcess::~ChildProcess() {
  kill();
  close_pipe();
}

bool ChildProcess::ended() {
  look_at_process();
  read_what_is_there();  // after the look: what a process has sent before it went is not lost
  return whole_ || process_ < 0;
}

void ChildProcess::read_what_is_there() {
  char buffer[65536];
  while (!whole_ && pipe_ >= 0) {
    const ssize_t got = ::read(pipe_, buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && errno == EAGAIN) return;
    if (got <= 0) return close_pipe();
    output_.append(buffer, static_cast<std::size_t>(got));
    const std::size_t newline = output_.find('\n', length_);
    whole_ = newline != std::string::npos;
    length_ = whole_ ? newline : output_.size();
  }
}

void ChildProcess::look_at_process() {
  int status = 0;
  while (process_ > 0) {
    const pid_t got = ::waitpid(process_, &status, WNOHANG | WUNTRACED | WCONTINUED);
    if (got == 0) return;
    if (got < 0) {  // somebody else has waited for it
      process_ = -1;
      return;
    }
    note(status);
  }
}

void ChildProcess::note(int status) {
  if (WIFSTOPPED(status) || WIFCONTINUED(status)) {
    is_stopped_ = WIFSTOPPED(status);
    was_stopped_ = true;
    return;
  }
  process_ = -1;
  died_of_signal_ = WIFSIGNALED(status);
  if (died_of_signal_)
    death_ = "signal " + std::to_string(WTERMSIG(status)) + " (" + ::strsignal(WTERMSIG(status)) + ")";
  else if (WEXITSTATUS(status) != 0)
    death_ = "exit status " + std::to_string(WEXITSTATUS(status));
}

void ChildProcess::kill() noexcept {
  if (group_ <= 0) return;
  ::kill(-group_, SIGKILL);
  if (process_ > 0) ::kill(process_, SIGKILL);
  int pause = kFirstMicroseconds;
  for (int waited = 0; process_ > 0 && waited < kMostMicrosecondsToDie; waited += pause) {
    if (::waitpid(process_, nullptr, WNOHANG) != 0) {
      process_ = -1;
    } else {
      pause = std::min(2 * pause, kMostMicrosecondsAtOnce);
      ::usleep(static_cast<useconds_t>(pause));
    }
  }
  group_ = -1;
}

void ChildProcess::close_pipe() noexcept {
  if (pipe_ >= 0) ::close(pipe_);
  pipe_ = -1;
}

}  // namespace nodal
