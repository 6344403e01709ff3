// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_report.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

#include <fmt/format.h>

#include <nodal/file.h>

#include "console.h"
#include "page_pictures.h"
#include "report/figure_files.h"
#include "report/report.h"

namespace nodal {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kPlainWidth = 160;  // where stdout is no terminal

std::size_t table_width() {
  winsize size{};
  if (::isatty(STDOUT_FILENO) == 1 && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    return size.ws_col;
  return kPlainWidth;
}

// The terminal says why. The page doesn't: it may be given away, and a message can quote what a file holds.
template <class Add>
void add_or_say(const Store& store, report::ReportData& data, Add add) {
  const std::string place = fmt::format("no pictures for '{}'", store.directory().string());
  try {
    add();
  } catch (const std::exception& error) {
    data.warnings.push_back(place + ": its study can't be drawn again here; nodal report says why");
    say("warning", fmt::format("{}: {}", place, error.what()));
  }
}

// Charts of an earlier report that this one doesn't have would stand beside its own as if they were new.
void remove_former(const fs::path& folder, const std::vector<report::FigureFile>& figures) {
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".svg" ||
        std::ranges::find(figures, name, &report::FigureFile::name) != figures.end())
      continue;
    std::string start(128, '\0');
    std::ifstream file(entry.path(), std::ios::binary);
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (report::is_figure_file(start)) fs::remove(entry.path(), none);
  }
}

}  // namespace

void write_report(std::span<const Store> stores, const Registry& registry, Store& target, const ReportWishes& wishes) {
  report::ReportData data = report::collect(stores, registry);
  if (!wishes.study)  // a comparison has said what it found in its store
    for (const std::string& warning : data.warnings) say("warning", warning);
  if (wishes.study)
    add_or_say(target, data, [&] { add_pictures(*wishes.study, data); });
  else
    for (const Store& store : stores) add_or_say(store, data, [&] { add_stored_pictures(store, registry, data); });
  // Files first: whoever reads the table may go away, or have no room for it. It stands there even if they can't.
  const auto print = [&data] {
    std::cout << report::console_table(data, table_width()) << '\n' << report::answer_lines(data) << std::flush;
  };
  try {
    target.write_file("summary.csv", report::summary_csv(data));
    target.write_file("optimizers.csv", report::optimizers_csv(data));
    target.write_file("budgets.csv", report::budgets_csv(data));
    target.write_file("report.html", report::report_html(data));
    const std::vector<report::FigureFile> figures = report::figure_files(data);
    for (const report::FigureFile& figure : figures) target.write_file("figures/" + figure.name, figure.svg);
    remove_former(target.directory() / "figures", figures);
    if (!wishes.latex.empty()) replace_file(wishes.latex, report::latex_tables(data));
  } catch (const StoreError&) {
    print();
    throw;
  }
  print();
  if (!wishes.latex.empty()) std::cerr << fmt::format("written: {}\n", wishes.latex);
  std::cerr << fmt::format("report: {}\n", (target.directory() / "report.html").string());
}

}  // namespace nodal
