// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VectorPage.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace
{

std::string errorOf(const hachure::VectorPage& page)
{
  try
  {
    hachure::checkVectorPage(page);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

hachure::VectorPage goodPage()
{
  hachure::VectorPage page;
  page.size = { 30.0, 20.0 };
  page.discs.resize(2);
  page.strokes.resize(2);
  page.strokes[1].points = { { 1.0, 2.0 }, { 3.0, 4.0 } };
  return page;
}

TEST(VectorPage, ErrorsNameWhatIsWrong)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(errorOf(goodPage()), "");
  hachure::VectorPage page;
  EXPECT_NE(errorOf(page).find("page size: 0"), std::string::npos);
  page = goodPage();
  page.size.x = none;
  EXPECT_NE(errorOf(page).find("page size: nan"), std::string::npos);
  page = goodPage();
  page.millimetresPerPixel = 0.0;
  EXPECT_NE(errorOf(page).find("millimetres per pixel: 0"), std::string::npos);
  page = goodPage();
  page.discs[1].center.y = none;
  EXPECT_EQ(errorOf(page), "discs[1]: the centre is not finite");
  page = goodPage();
  page.discs[0].radius = -1.0;
  EXPECT_NE(errorOf(page).find("discs[0]: the radius"), std::string::npos);
  page = goodPage();
  page.discs[1].opacity = std::numeric_limits<float>::infinity();
  EXPECT_NE(errorOf(page).find("discs[1]: the colour or opacity"), std::string::npos);
  page = goodPage();
  page.strokes[1].points[0].x = none;
  EXPECT_EQ(errorOf(page), "strokes[1]: a point is not finite");
  page = goodPage();
  page.strokes[0].width = none;
  EXPECT_NE(errorOf(page).find("strokes[0]: the width"), std::string::npos);
  page = goodPage();
  page.background.g = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(errorOf(page).find("page background"), std::string::npos);
}

} // namespace
