// SPDX-License-Identifier: GPL-3.0-or-later
// Tables, by their own names and by a study's; the first byte says which. All fields are asked for in all ways.
#include "fuzz_target.h"
#include "import/csv.h"

namespace {

using namespace nodal::elastic;

const std::vector<Column> kColumns = {{"node"}, {"x", true}, {"y", true}, {"load"}};
const ColumnNames kNames = {{{"x", "u"}, {"y", "v"}, {"load", "name"}}, {"s.toml", 1}};

template <class Ask>
void ask(Ask&& question) {
  try {
    (void)question();
  } catch (const nodal::InputError&) {
  }
}

void ask_all(const CsvRow& row, const std::string& column) {
  ask([&] { return row.number(column); });
  ask([&] { return row.measured(column); });
  ask([&] { return row.required_number(column); });
  ask([&] { return row.integer(column); });
  ask([&] { return row.required_integer(column); });
  ask([&] { return row.text(column); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const bool named = data[0] == '?';
  return nodal::fuzz::read(data + 1, size - 1, [named](std::string_view text) {
    const CsvTable table(text, "t.csv", kColumns, named ? kNames : ColumnNames{});
    (void)table.left_out();
    for (std::size_t i = 0; i < table.size(); ++i)
      for (const Column& column : kColumns) ask_all(table.row(i), column.name);
  });
}
