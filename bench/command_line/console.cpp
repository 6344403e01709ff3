// SPDX-License-Identifier: GPL-3.0-or-later
#include "console.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>
#include <streambuf>
#include <string>

#include <nodal/file.h>
#include <nodal/shown.h>

#include "commands.h"

namespace nodal {

namespace {

constexpr std::size_t kFlushBytes = 65536;

void open_if_closed(int descriptor) {
  if (::fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) return;
  // The lowest free descriptor is the one that is closed, since those below it have been looked at.
  const int opened = ::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  if (opened >= 0 && opened != descriptor) ::close(opened);
}

}  // namespace

class ConsoleBuffer final : public std::streambuf {
 public:
  explicit ConsoleBuffer(int descriptor) : descriptor_(descriptor) {}

  // The first error of all writes; 0 when there was none.
  int error() const noexcept { return error_; }

  void send(std::string_view sequence) {
    (void)sync();
    put(sequence);
  }

  // At the end half a character won't become whole any more.
  void finish() {
    put(printable(waiting_, Breaks::keep));
    waiting_.clear();
  }

 protected:
  int_type overflow(int_type c) override {
    if (c == traits_type::eof()) return traits_type::not_eof(c);
    const char character = traits_type::to_char_type(c);
    return xsputn(&character, 1) == 1 ? c : traits_type::eof();
  }

  std::streamsize xsputn(const char* text, std::streamsize size) override {
    waiting_.append(text, static_cast<std::size_t>(size));
    if (waiting_.size() < kFlushBytes || sync() == 0) return size;
    return 0;
  }

  int sync() override {
    const std::size_t rest = unfinished_bytes(waiting_);
    put(printable(std::string_view(waiting_).substr(0, waiting_.size() - rest), Breaks::keep));
    waiting_.erase(0, waiting_.size() - rest);
    return error_ == 0 ? 0 : -1;
  }

 private:
  // After an error nothing more is tried: what follows a gap would look like the whole.
  void put(std::string_view text) {
    if (error_ == 0) error_ = write_all(descriptor_, text);
  }

  int descriptor_;
  int error_ = 0;
  std::string waiting_;
};

Console::Console()
    : out_(std::make_unique<ConsoleBuffer>(STDOUT_FILENO)), err_(std::make_unique<ConsoleBuffer>(STDERR_FILENO)) {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) open_if_closed(descriptor);
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &ignore, &former_);
  std::cout.flush();
  former_out_ = std::cout.rdbuf(out_.get());
  former_err_ = std::cerr.rdbuf(err_.get());
}

Console::~Console() {
  out_->finish();
  err_->finish();
  std::cout.rdbuf(former_out_);
  std::cerr.rdbuf(former_err_);
  sigaction(SIGPIPE, &former_, nullptr);
}

int Console::finish(int exit) {
  std::cout.flush();
  out_->finish();
  if (out_->error() == 0) return exit;
  if (out_->error() == EPIPE) return exit == 0 ? kExitReaderGone : exit;
  say("nodal", std::string("cannot write to standard output: ") + std::strerror(out_->error()));
  return kExitBadInput;
}

void say(std::string_view kind, std::string_view text) { std::cerr << kind << ": " << printable(text) << '\n'; }

void send_control(std::ostream& out, std::string_view sequence) {
  if (auto* buffer = dynamic_cast<ConsoleBuffer*>(out.rdbuf()))
    buffer->send(sequence);
  else
    out << sequence;
}

}  // namespace nodal
