// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/account.h>

#include <algorithm>

namespace nodal::elastic {

Stage* Account::find(std::string_view stage) {
  const auto found = std::ranges::find(stages_, stage, &Stage::name);
  return found == stages_.end() ? nullptr : &*found;
}

void Account::used(std::string_view stage, std::string detail) {
  Stage said{std::string(stage), true, std::move(detail)};
  if (Stage* before = find(stage))
    *before = std::move(said);
  else
    stages_.push_back(std::move(said));
}

void Account::left_out(std::string_view stage, std::string why) {
  if (!find(stage)) stages_.push_back({std::string(stage), false, std::move(why)});
}

void Account::remark(std::string line) { remarks_.push_back(std::move(line)); }

void Account::finding(std::string line) {
  remarks_.push_back(line);
  findings_.push_back(std::move(line));
}

std::string Account::detail_of(std::string_view stage) const {
  const auto found = std::ranges::find(stages_, stage, &Stage::name);
  return found != stages_.end() && found->used ? found->detail : std::string();
}

}  // namespace nodal::elastic
