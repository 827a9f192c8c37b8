// What a pixel of an object looks like, and how much of what is behind it it hides.

//Section Paper
  vec4 picture = vec4(hachurePicture(pixel, depth, surface, tones, hasData), 1.0);
//Section NoPaper
  // On black and on white tells what shows through. Colours are multiplied by the alpha.
  hachurePaperHere = vec3(0.0);
  vec3 onBlack = hachurePicture(pixel, depth, surface, tones, hasData);
  hachurePaperHere = vec3(1.0);
  vec3 onWhite = hachurePicture(pixel, depth, surface, tones, hasData);
  vec4 picture = vec4(onBlack, 1.0 - clamp(dot(onWhite - onBlack, vec3(1.0 / 3.0)), 0.0, 1.0));
