// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The charts of a report as files beside it: pictures for a text, on white, whatever the page looks like.

#include <string>
#include <string_view>
#include <vector>

#include "report_data.h"

namespace nodal::report {

struct FigureFile {
  std::string name;  ///< "plate-error-seconds.svg"
  std::string svg;
};

/// Of every problem its race over every axis, as errors and as gaps, and of what is held out, and what its trials
/// attained; of all problems the profiles. Characters of a label
/// that have no place in a file's name become "-"; where that makes two labels one, a number tells them apart.
[[nodiscard]] std::vector<FigureFile> figure_files(const ReportData& data);

/// Whether a file's text is such a figure, of this report or an earlier one.
[[nodiscard]] bool is_figure_file(std::string_view text);

}  // namespace nodal::report
