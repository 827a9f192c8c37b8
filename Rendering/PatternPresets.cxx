// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternPresets.h"

#include "preset_cmyk.h"
#include "preset_cross_hatch.h"
#include "preset_gabor.h"
#include "preset_halftone.h"
#include "preset_hatch.h"
#include "preset_painterly.h"
#include "preset_paper.h"
#include "preset_phasor.h"
#include "preset_spot.h"

namespace hachure
{

//------------------------------------------------------------------------------
const std::vector<Preset>& presets()
{
  static const std::vector<Preset> list = {
    { "hatch", preset_hatch },
    { "cross-hatch", preset_cross_hatch },
    { "halftone", preset_halftone },
    { "cmyk", preset_cmyk },
    { "painterly", preset_painterly },
    { "paper", preset_paper },
    { "gabor", preset_gabor },
    { "phasor", preset_phasor },
    { "spot", preset_spot },
  };
  return list;
}

} // namespace hachure
