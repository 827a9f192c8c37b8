// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Separation of colours for printing. Pure cyan ink takes all red light away, magenta green,
// yellow blue, black all three; screens at different angles overlap by chance, so that light
// passes two inks of tones a and b with the share (1 - a) (1 - b).

// Tones of cyan, magenta, yellow and black that print a linear colour in [0, 1] on white paper.
// blackGeneration: share of its darkness that black prints, 0 to 1.
vec4 processInks(vec3 color, float blackGeneration)
{
  float lightest = max(color.x, max(color.y, color.z));
  float black = blackGeneration * (1.0f - lightest);
  float rest = max(1.0f - black, 1.0e-6f);
  // Where black alone is full, the other inks make no difference.
  bool covered = black >= 1.0f;
  vec3 inks = clamp(vec3(1.0f) - color / rest, vec3(0.0f), vec3(1.0f));
  return covered ? vec4(0.0f, 0.0f, 0.0f, 1.0f)
                 : vec4(inks.x, inks.y, inks.z, clamp(black, 0.0f, 1.0f));
}
