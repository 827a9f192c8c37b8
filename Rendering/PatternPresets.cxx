// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternPresets.h"

#include "preset_brush.h"
#include "preset_cmyk.h"
#include "preset_cross_hatch.h"
#include "preset_engraving.h"
#include "preset_felt_tip.h"
#include "preset_gabor.h"
#include "preset_graphite.h"
#include "preset_halftone.h"
#include "preset_hatch.h"
#include "preset_ink.h"
#include "preset_noise_cross_hatch.h"
#include "preset_noise_hatch.h"
#include "preset_noise_stipple.h"
#include "preset_painterly.h"
#include "preset_paper.h"
#include "preset_phasor.h"
#include "preset_spot.h"
#include "preset_stipple.h"
#include "preset_stipple_two_inks.h"
#include "preset_stipple_white.h"
#include "preset_view.h"
#include "preset_watercolour.h"

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
    { "stipple", preset_stipple },
    { "stipple-white", preset_stipple_white },
    { "stipple-two-inks", preset_stipple_two_inks },
    { "gabor", preset_gabor },
    { "phasor", preset_phasor },
    { "spot", preset_spot },
    { "noise-stipple", preset_noise_stipple },
    { "noise-hatch", preset_noise_hatch },
    { "noise-cross-hatch", preset_noise_cross_hatch },
    { "graphite", preset_graphite },
    { "ink", preset_ink },
    { "watercolour", preset_watercolour },
    { "felt-tip", preset_felt_tip },
    { "brush", preset_brush },
    { "engraving", preset_engraving },
    { "view", preset_view },
  };
  return list;
}

} // namespace hachure
