// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PatternPresets_h
#define PatternPresets_h

#include <vector>

namespace hachure
{

/** A built-in style: the text of Presets/<name>.json. */
struct Preset
{
  const char* name;
  const char* json;
};

/** All built-in styles in the order in which programs list them. */
const std::vector<Preset>& presets();

} // namespace hachure

#endif
