// A layer of view-dependent texture: the colour of the surface's cells as seen from here. '@' is the
// layer's number, HEMISPHERE the number of directions a side, HEMISPHEREMAP how they are stored;
// HASDEPENDENT and HASINDEPENDENT: which colours there are.

uniform samplerBuffer hachureCellTriangles@; // of every record: frames at the corners, 1 where another one follows; packed places of the corners, chart
uniform samplerBuffer hachureCellFrames@;    // of every frame: position about hachurePatchOrigin; turn; turn in charts of the other kind
uniform samplerBuffer hachureCellCharts@;    // of every chart: neighbours, first level; first node of level 0 and, less those below, of the levels above the first; its kind
uniform sampler2D hachureDependent@;   // squares of directions, see ViewTextureColors.h
uniform sampler2D hachureIndependent@; // colours of nodes
uniform vec4 hachureCellX@; // rows of the matrix from hachureRunPoint to logical pixels times w (X, Y), and w
uniform vec4 hachureCellY@;
uniform vec4 hachureCellW@;
uniform vec4 hachureViewer@;    // where the eye is, as hachureRunPoint, w: 1; or the direction to it, w: 0
uniform vec4 hachureCellShape@; // area of a cell of level 0, finest level, share of what is independent, 1 + the level of all pixels or 0
uniform vec3 hachureNodeImages@; // squares side by side, nodes side by side, and 1 over the rows of squares

vec3 hachureViewColor@ = vec3(0.0); // linear

// What is stored for a place and a direction.
struct HachureStored@
{
  vec4 dependent; // times its share, which is w
  vec4 independent;
};

vec4 hachureDependentAt@(int node, vec2 square)
{
#if HASDEPENDENT
  int columns = int(hachureNodeImages@.x);
  vec2 corner = vec2(float(node % columns), float(node / columns));
  // Not over the rim into the next square.
  vec2 inside = clamp(square, vec2(0.5 / HEMISPHERE), vec2(1.0 - 0.5 / HEMISPHERE));
  return textureLod(
    hachureDependent@, (corner + inside) * vec2(1.0 / hachureNodeImages@.x, hachureNodeImages@.z), 0.0);
#else
  return vec4(0.0);
#endif
}

vec4 hachureIndependentAt@(int node)
{
#if HASINDEPENDENT
  int columns = int(hachureNodeImages@.y);
  // What nobody knows is grey.
  return vec4(texelFetch(hachureIndependent@, ivec2(node % columns, node / columns), 0).rgb, 1.0);
#else
  return vec4(0.0);
#endif
}

// Of one level. chart: see hachureCellCharts@; first: its nodes.
HachureStored@ hachureStoredAt@(int level, vec4 chart, vec4 first, vec2 place, vec2 square)
{
  int subdivisions = max(level - int(chart.w), 0);
  int node = subdivisions > 0 ? int(first.y) + chartNodesBelow(subdivisions)
                              : int(first.x) + level * chartNodes(0);
  NodeMix nodes = nodesAt(place, 1 << subdivisions);
  HachureStored@ stored;
  stored.dependent = nodes.weights.x * hachureDependentAt@(node + nodes.cell, square) +
    nodes.weights.y * hachureDependentAt@(node + nodes.corner, square) +
    nodes.weights.z * hachureDependentAt@(node + nodes.next, square);
  stored.independent = nodes.weights.x * hachureIndependentAt@(node + nodes.cell) +
    nodes.weights.y * hachureIndependentAt@(node + nodes.corner) +
    nodes.weights.z * hachureIndependentAt@(node + nodes.next);
  return stored;
}

// Where the pixel is, among the triangles that it may be on.
void hachureFindTriangle@(out vec4 corners, out vec4 places, out vec3 weights)
{
  int record = int(hachureRun);
  int best = record;
  vec3 found = vec3(0.0, 0.0, -1.0e30);
  bool more = false;
  do
  {
    vec4 tried = texelFetch(hachureCellTriangles@, 2 * record);
    vec3 place = placeInCorners(hachureRunPoint,
      texelFetch(hachureCellFrames@, 3 * int(tried.x)).xyz,
      texelFetch(hachureCellFrames@, 3 * int(tried.y)).xyz,
      texelFetch(hachureCellFrames@, 3 * int(tried.z)).xyz);
    bool better = place.z > found.z;
    best = better ? record : best;
    found = better ? place : found;
    more = tried.w > 0.0;
    ++record;
  } while (more);
  corners = texelFetch(hachureCellTriangles@, 2 * best);
  places = texelFetch(hachureCellTriangles@, 2 * best + 1);
  float second = clamp(found.x, 0.0, 1.0);
  float third = clamp(found.y, 0.0, 1.0 - second);
  weights = vec3(1.0 - second - third, second, third);
}

// From the chart of a triangle that reaches over its rim to the one in which the place is.
int hachureFindChart@(int start, inout vec2 place)
{
  const float slack = -1.0e-4; // rounding
  int chart = start;
  vec3 weights = vec3(1.0 - place.x - place.y, place);
  int steps = 0;
  bool more = false;
  do
  {
    float least = min(min(weights.x, weights.y), weights.z);
    vec4 links = texelFetch(hachureCellCharts@, 2 * chart);
    int edge = weights.x == least ? 0 : (weights.y == least ? 1 : 2);
    int code = int(edge == 0 ? links.x : (edge == 1 ? links.y : links.z));
    more = least < slack && code >= 0 && steps < 4;
    if (more)
    {
      weights = weightsAcross(weights, edge, (code % 6) / 2, code % 2 == 1);
      chart = code / 6;
    }
    ++steps;
  } while (more);
  place = weights.yz;
  return chart;
}

float hachureCoverage@(vec2 position, float tone)
{
  if (hachureCellShape@.x < 0.0)
  {
    return 0.0; // nothing could be made
  }
  vec4 corners;
  vec4 places;
  vec3 weights;
  hachureFindTriangle@(corners, places, weights);
  if (places.w < 0.0)
  {
    return 0.0; // without area
  }
  vec2 place = weights.x * unpackedPlace(places.x) + weights.y * unpackedPlace(places.y) +
    weights.z * unpackedPlace(places.z);
  int number = hachureFindChart@(int(places.w), place);
  vec4 chart = texelFetch(hachureCellCharts@, 2 * number);
  vec4 first = texelFetch(hachureCellCharts@, 2 * number + 1);
  int kind = texelFetch(hachureCellCharts@, 2 * int(places.w) + 1).z == first.z ? 1 : 2;
  vec4 turn = mixedTurn(texelFetch(hachureCellFrames@, 3 * int(corners.x) + kind),
    texelFetch(hachureCellFrames@, 3 * int(corners.y) + kind),
    texelFetch(hachureCellFrames@, 3 * int(corners.z) + kind), weights);

  vec3 toViewer = hachureViewer@.xyz - hachureViewer@.w * hachureRunPoint;
  vec2 square = HEMISPHEREMAP(normalize(turnedBack(turn, toViewer)));
  vec3 normal = turnedBack(vec4(-turn.xyz, turn.w), vec3(0.0, 1.0, 0.0));
  float level = levelOfArea(hachureCellShape@.x *
    pictureArea(hachureRunPoint, normal, hachureCellX@, hachureCellY@, hachureCellW@));
  level = clamp(hachureCellShape@.w > 0.0 ? hachureCellShape@.w - 1.0 : level, 0.0, hachureCellShape@.y);
  int coarse = int(level);
  int fine = min(coarse + 1, int(hachureCellShape@.y));
  HachureStored@ below = hachureStoredAt@(coarse, chart, first, place, square);
  HachureStored@ above = hachureStoredAt@(fine, chart, first, place, square);
  float part = level - float(coarse);
  vec4 dependent = (1.0 - hachureCellShape@.z) * mix(below.dependent, above.dependent, part);
  vec4 independent = mix(below.independent, above.independent, part);
  vec4 color = vec4(dependent.rgb + (1.0 - dependent.a) * independent.a * independent.rgb,
    dependent.a + (1.0 - dependent.a) * independent.a);
  // Bytes of pictures come out as they were: ink is linear by another curve than sRGB.
  hachureViewColor@ = toLinear(encodedSrgb(color.rgb / max(color.a, 1.0e-4)));
  return color.a * clamp(tone, 0.0, 1.0);
}
