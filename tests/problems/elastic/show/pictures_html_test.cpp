// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/pictures_html.h"

#include <gtest/gtest.h>

#include <regex>

#include "../../../support/count.h"
#include "pictures.h"
#include "show/style.h"

namespace nodal::elastic::show {
namespace {

constexpr const char* kHostile = "</script><img src=x onerror=alert(1)>&\"'";

using toy::count;

TEST(PicturesHtml, ShowTheSystemBeforeItsLoads) {
  const std::string html =
      pictures_html(std::vector{fixture::make_square("start", 0.5), fixture::make_square("best: annealing", 0.25)});
  EXPECT_EQ(count(html.substr(0, html.find("<h3>Spring by spring")), "<svg class=\"plate system\""), 2u);
  EXPECT_EQ(count(html, "<svg class=\"plate load\""), 2u);
  EXPECT_EQ(count(html, "<svg class=\"plate scale\""), 1u);  // one for all pictures of the problem
  EXPECT_LT(html.find("<svg class=\"plate system\""), html.find("<svg class=\"plate load\""));
}

// Before and after in full, of all others the system; each spring is told by its nodes and every stiffness.
TEST(PicturesHtml, ShowEveryFurtherSystemSpringBySpring) {
  std::vector<Picture> all = {fixture::make_square("start", 0.5), fixture::make_square("best: annealing", 0.25),
                              fixture::make_square("<other>", 0.3)};
  all[1].springs = all[2].springs = all[0].springs;
  all[1].springs[0].stiffness *= 2.5;
  all[2].springs[0].stiffness *= 0.4;
  const std::string html = pictures_html(all);
  EXPECT_EQ(count(html, "<svg class=\"plate load\""), 2u);
  EXPECT_EQ(count(html, "<figure data-system="), 2u);
  EXPECT_EQ(count(html, "<svg class=\"plate difference\""), 2u);
  // One stiffer and one softer than at the start, all others alike.
  EXPECT_EQ(count(html, "<path stroke=\"#b2182b\""), 1u);
  EXPECT_EQ(count(html, "<path stroke=\"#2166ac\""), 1u);
  EXPECT_EQ(count(html, "<path stroke=\"#b0b0b0\""), 2u);
  EXPECT_NE(html.find("<th scope=\"col\">&lt;other&gt;</th>"), std::string::npos);
  EXPECT_EQ(count(html, "<other>"), 0u);
  const PicturedSpring& s = all[0].springs[0];
  EXPECT_NE(html.find("<th scope=\"row\">" + std::to_string(s.first) + "–" + std::to_string(s.second) + "</th>"),
            std::string::npos);
}

TEST(PicturesHtml, ShowWhatWasNeverFittedApart) {
  Picture picture = fixture::make_square("start", 0.5);
  picture.loads.push_back(picture.loads[0]);
  picture.loads[1].name = "bend-x";
  picture.loads[1].unseen = picture.unseen_error = 0.25;
  const std::string html = pictures_html(std::vector{picture});
  EXPECT_EQ(count(html, "<svg class=\"plate load\""), 2u);
  EXPECT_EQ(count(html, "<div class=\"plates"), 2u);
  const std::size_t heading = html.find("<h4>Never fitted: unseen error 0.2500 over these loads</h4>");
  ASSERT_NE(heading, std::string::npos);
  EXPECT_LT(heading, html.find("bend-x, never fitted<br><small>relative error 0.2500</small>"));
}

TEST(PicturesHtml, LabelsCannotBreakOut) {
  Picture picture = fixture::make_square(kHostile, 0.5);
  picture.problem = picture.loads[0].name = kHostile;
  const std::string html = pictures_html(std::vector{picture});
  EXPECT_EQ(count(html, "<img"), 0u);
  EXPECT_EQ(count(html, "</script>"), 0u);
  EXPECT_GE(count(html, "&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt;&amp;&quot;&#39;"), 3u);
}

TEST(PicturesHtml, LoadNothingFromOutside) {
  const std::string own = pictures_html(std::vector{fixture::make_square("start", 0.5)}) + std::string(picture_css()) +
                          std::string(pictures_css()) + std::string(details_css()) + std::string(voronoi_js());
  const std::regex loads(
      R"((src|href|srcset|action)\s*=\s*["']?\s*(https?:)?//|url\(\s*["']?\s*(https?:)?//|@import|<link|<iframe)");
  EXPECT_FALSE(std::regex_search(own, loads));
}

}  // namespace
}  // namespace nodal::elastic::show
