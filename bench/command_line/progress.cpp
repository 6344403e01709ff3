// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>

#include <fmt/format.h>

#include <nodal/shown.h>

#include "console.h"

namespace nodal {

namespace {

constexpr std::size_t kBarWidth = 30;
constexpr std::size_t kUsualWidth = 80, kUsualHeight = 24;  // where the terminal doesn't say

winsize terminal_size() {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0)
    size = {kUsualHeight, kUsualWidth, 0, 0};
  return size;
}

}  // namespace

Progress::~Progress() { close(); }

void Progress::stored(std::span<const TrialRecord> records) {
  for (const TrialRecord& record : records) table_.add(record);
}

void Progress::began(std::size_t total, std::size_t stored) {
  stored_ = stored;
  began_ = std::chrono::steady_clock::now();
  if (stored > 0) std::cerr << fmt::format("{} of {} trials are stored already\n", stored, total);
  if (stored == total) return;
  if (on_terminal_)
    draw("", stored, total);
  else
    std::cerr << fmt::format("running {} trial{}\n", total - stored, total - stored == 1 ? "" : "s");
}

void Progress::finished(const TrialRecord& record, std::size_t done, std::size_t total) {
  if (on_terminal_) {
    table_.add(record);
    draw_table();
    draw(record.optimizer, done, total);
    return;
  }
  const auto digits = std::to_string(total).size();
  std::cerr << fmt::format("[{:>{}}/{}] {}\n", done, digits, total, trial_line(record));
}

void Progress::timing(std::size_t trials) {
  close();
  std::cerr << fmt::format("{} trial{} once more, alone, for {} times\n", trials, trials == 1 ? " runs" : "s run",
                           trials == 1 ? "its" : "their");
}

void Progress::warned(const std::string& warning) {
  close();
  say("warning", warning);
}

void Progress::close() {
  remove_table();
  if (open_) std::cerr << '\n';
  open_ = false;
}

void Progress::draw(const std::string& what, std::size_t done, std::size_t total) {
  const std::size_t filled = total > 0 ? kBarWidth * done / total : kBarWidth;
  std::string bar;
  for (std::size_t i = 0; i < kBarWidth; ++i) bar += i < filled ? "█" : "░";
  send_control(std::cerr, "\r");
  std::cerr << fmt::format("{} {}/{} {}  {}", bar, done, total, time_left(done, total), printable(what));
  send_control(std::cerr, "\x1b[K");  // clears what a longer line before has left
  std::cerr << std::flush;
  open_ = true;
}

// The cursor stands in the bar's line, below the table.
void Progress::draw_table() {
  const winsize size = terminal_size();
  const std::vector<std::string> lines = table_.lines(size.ws_col - 1u, size.ws_row - 2u);
  if (lines.size() != lines_) remove_table();
  send_control(std::cerr, lines_ > 0 ? fmt::format("\r\x1b[{}A", lines_) : "\r");
  for (const std::string& line : lines) {
    std::cerr << line;
    send_control(std::cerr, "\x1b[K");
    std::cerr << '\n';
  }
  lines_ = lines.size();
}

// The bar's line goes, too: it is drawn again by whoever wants it.
void Progress::remove_table() {
  if (lines_ == 0) return;
  send_control(std::cerr, fmt::format("\r\x1b[{}A\x1b[J", lines_));
  lines_ = 0;
  open_ = false;
}

std::string Progress::time_left(std::size_t done, std::size_t total) const {
  if (done == total) return "done";
  if (done == stored_) return "";
  const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  const double left = spent / static_cast<double>(done - stored_) * static_cast<double>(total - done);
  const auto seconds = static_cast<long>(left + 0.5);
  return seconds < 60 ? fmt::format("{} s left", seconds)
                      : fmt::format("{} min {:02} s left", seconds / 60, seconds % 60);
}

std::string trial_line(const TrialRecord& record, bool times_count) {
  std::string line = fmt::format("{}, repeat {}: ", record.optimizer, record.repeat);
  if (record.best && record.best->summary.relative_error)
    line += fmt::format("relative error {:.4g}, ", *record.best->summary.relative_error);
  else if (record.best && record.best->summary.quality)
    line += fmt::format("quality {:.4g}, ", *record.best->summary.quality);
  const std::string why = times_count ? contamination(record) : std::string();
  line += fmt::format("{} evaluations, {:.3g} s ({}{}{}){}", record.counts.evaluations, record.seconds.total,
                      to_string(record.end), record.reason.empty() ? "" : ": ", record.reason,
                      why.empty() ? "" : "; contaminated: " + why);
  return printable(line);
}

}  // namespace nodal
