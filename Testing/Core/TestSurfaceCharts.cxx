// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/SurfaceCharts.h"

#include <gtest/gtest.h>

using namespace hachure;

TEST(SurfaceCharts, Empty)
{
  EXPECT_TRUE(surfaceCells({ {}, {}, {} }).charts.empty());
}
