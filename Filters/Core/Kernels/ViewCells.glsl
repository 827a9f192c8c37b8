// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// View-dependent textures (Grimm and Kowalski 2002): colours on the cells of a surface, one for
// every direction in which a cell is seen.
//
// The surface is divided into charts of three corners, a chart of 2^m segments a side into 4^m
// cells. A place on a chart is given by the weights of its second (x) and third corner (y); those of
// the first corner are what is missing to 1. Colours are stored at nodes: the centres of cells, the
// corners of cells, and the middles of those edges of cells that lie on the chart's rim. In a list of a
// level's nodes they follow each other in this order.

// Directions in the frame of a node: y along the normal.

// A direction of the upper half space in the unit square, the octahedron's upper half turned by 45
// degrees: no part of the square is wasted, and the horizon is its rim. Directions below the horizon go
// to the rim.
vec2 hemisphereSquare(vec3 direction)
{
  float sum = abs(direction.x) + abs(direction.z) + max(direction.y, 0.0f);
  vec2 diamond = vec2(direction.x, direction.z) / max(sum, 1.0e-30f);
  return vec2(0.5f) + 0.5f * vec2(diamond.x + diamond.y, diamond.x - diamond.y);
}

// The other way; of unit length.
vec3 hemisphereDirection(vec2 square)
{
  vec2 turned = 2.0f * square - 1.0f;
  vec2 diamond = 0.5f * vec2(turned.x + turned.y, turned.x - turned.y);
  return normalize(
    vec3(diamond.x, max(1.0f - abs(diamond.x) - abs(diamond.y), 0.0f), diamond.y));
}

// The paper's map (appendix B, with the vector to the eye): the upper half space is the disk in the
// square, its corners are wasted. Directions below the horizon go to the closest of the disk's rim.
vec2 hemisphereDisk(vec3 direction)
{
  vec2 along = vec2(direction.x, direction.z);
  vec2 place = direction.y > 0.0f ? along / (1.0f + direction.y)
                                  : along / max(length(along), 1.0e-30f);
  return vec2(0.5f) + 0.5f * place;
}

// The other way; of unit length. Places outside the disk go to the closest of its rim.
vec3 hemisphereDiskDirection(vec2 square)
{
  vec2 place = 2.0f * square - 1.0f;
  place /= max(length(place), 1.0f);
  float squared = dot(place, place);
  float height = (1.0f - squared) / (1.0f + squared);
  return vec3(place.x * (1.0f + height), height, place.y * (1.0f + height));
}

// A vector turned by the inverse of a unit quaternion (xyz: axis, w).
vec3 turnedBack(vec4 quaternion, vec3 vector)
{
  vec3 axis = vec3(quaternion.x, quaternion.y, quaternion.z);
  vec3 side = cross(axis, vector);
  return vector - 2.0f * quaternion.w * side + 2.0f * cross(axis, side);
}

// Area in the picture, in square pixels, of a unit of surface around a point: rows of the matrix to
// pixels times w (x, y) and to w.
float pictureArea(vec3 point, vec3 normal, vec4 rowX, vec4 rowY, vec4 rowW)
{
  vec4 place = vec4(point, 1.0f);
  float w = dot(rowW, place);
  float inverse = 1.0f / (abs(w) > 1.0e-30f ? w : 1.0e-30f);
  float x = dot(rowX, place) * inverse;
  float y = dot(rowY, place) * inverse;
  vec3 along = vec3(rowW.x, rowW.y, rowW.z);
  vec3 slopeX = inverse * (vec3(rowX.x, rowX.y, rowX.z) - x * along);
  vec3 slopeY = inverse * (vec3(rowY.x, rowY.y, rowY.z) - y * along);
  return abs(dot(normal, cross(slopeX, slopeY)));
}

// The level whose cells are one pixel large (section 4.2), where cells of level 0 are of this area in
// pixels: they shrink to a quarter from level to level. A level is a number between two.
float levelOfArea(float pixels)
{
  return 0.5f * log2(max(pixels, 1.0e-12f));
}

// Weights of a place beyond an edge of its chart, opposite to the corner `edge`, in the chart next to
// it; `other` is that one's corner opposite to the edge. alike: the edge has the same direction in both
// charts, as it has where one of them is turned over.
vec3 weightsAcross(vec3 weights, int edge, int other, bool alike)
{
  float beyond = weights[edge];
  float second = weights[(edge + 1) % 3] + beyond;
  float third = weights[(edge + 2) % 3] + beyond;
  vec3 found = vec3(0.0f);
  found[other] = -beyond;
  found[(other + 1) % 3] = alike ? second : third;
  found[(other + 2) % 3] = alike ? third : second;
  return found;
}

// Number of nodes of a chart of 2^subdivisions segments, and of all with less.
int chartNodes(int subdivisions)
{
  int segments = 1 << subdivisions;
  return segments * segments + (segments + 1) * (segments + 2) / 2 + 3 * segments;
}
int chartNodesBelow(int subdivisions)
{
  int segments = 1 << subdivisions;
  return (segments * segments - 1 + 9 * (segments - 1)) / 2 + subdivisions;
}

// Numbers among the nodes of a chart with this number of segments: of a cell, the upright ones (odd: 0)
// and the others (odd: 1) between column, row and the next ones; of a corner of cells; of the middle of
// the rim's edge opposite to a corner of the chart.
int cellNode(int column, int row, int odd, int segments)
{
  return row * (2 * segments - row) + 2 * column + odd;
}
int cornerNode(int column, int row, int segments)
{
  return segments * segments + row * (segments + 1) - row * (row - 1) / 2 + column;
}
int rimNode(int edge, int along, int segments)
{
  return segments * segments + (segments + 1) * (segments + 2) / 2 + edge * segments + along;
}

// Three nodes and their weights, whose sum is 1.
struct NodeMix
{
  int cell;   // in which the place is
  int corner; // of the cell, the nearest one
  int next;   // the cell across the nearest edge; on the rim the middle of that edge
  vec3 weights;
};

// The hat functions of section 7 for triangular cells: linear between the centres of cells and their
// corners, whose value is the mean of the cells around, and continuous across edges and around corners
// of any number of cells.
NodeMix nodesAt(vec2 place, int segments)
{
  float size = float(segments);
  vec2 inside = size * clamp(place, vec2(0.0f), vec2(1.0f));
  int row = int(min(floor(inside.y), size - 1.0f));
  int column = int(min(floor(inside.x), size - 1.0f - float(row)));
  float x = inside.x - float(column);
  float y = inside.y - float(row);
  bool odd = x + y > 1.0f && column + row < segments - 1;
  vec3 weights = odd ? vec3(x + y - 1.0f, 1.0f - x, 1.0f - y) : vec3(1.0f - x - y, x, y);
  weights = max(weights, vec3(0.0f));
  weights /= weights.x + weights.y + weights.z;
  float least = min(min(weights.x, weights.y), weights.z);
  float most = max(max(weights.x, weights.y), weights.z);
  int edge = weights.x == least ? 0 : (weights.y == least ? 1 : 2);
  int nearest = weights.z == most ? 2 : (weights.y == most ? 1 : 0);
  NodeMix nodes;
  nodes.cell = cellNode(column, row, odd ? 1 : 0, segments);
  // Corners of upright cells are here, in the next column, in the next row; of the others opposite.
  int right = odd ? (nearest == 1 ? 0 : 1) : (nearest == 1 ? 1 : 0);
  int up = odd ? (nearest == 2 ? 0 : 1) : (nearest == 2 ? 1 : 0);
  nodes.corner = cornerNode(column + right, row + up, segments);
  int sign = odd ? 1 : -1;
  int nextColumn = column + (edge == 1 ? sign : 0);
  int nextRow = row + (edge == 2 ? sign : 0);
  bool isRim = !odd &&
    (edge == 0 ? column + row == segments - 1 : (edge == 1 ? column == 0 : row == 0));
  nodes.next = isRim ? rimNode(edge, edge == 2 ? column : row, segments)
                     : cellNode(nextColumn, nextRow, odd ? 0 : 1, segments);
  float middle = 2.0f * (1.0f - least - most - least); // of the edge
  // Between cells the edge's middle is the mean of both.
  nodes.weights = isRim ? vec3(3.0f * least, most - 0.5f * middle - least, middle)
                        : vec3(3.0f * least + 0.5f * middle, most - 0.5f * middle - least, 0.5f * middle);
  return nodes;
}

// As placeInTriangle(), of a triangle's corners. Without area it fits nowhere.
vec3 placeInCorners(vec3 point, vec3 first, vec3 second, vec3 third)
{
  vec3 along = second - first;
  vec3 other = third - first;
  float aa = dot(along, along);
  float ab = dot(along, other);
  float bb = dot(other, other);
  float area = max(aa * bb - ab * ab, 1.0e-37f);
  return placeInTriangle(
    point, first, (bb * along - ab * other) / area, (aa * other - ab * along) / area);
}

// The turn inside a triangle from those of its corners, by their weights.
vec4 mixedTurn(vec4 first, vec4 second, vec4 third, vec3 weights)
{
  vec4 sum = weights.x * first + (dot(first, second) < 0.0f ? -weights.y : weights.y) * second +
    (dot(first, third) < 0.0f ? -weights.z : weights.z) * third;
  return sum / max(length(sum), 1.0e-20f);
}

// Two numbers between -1 and 2 in one, each of 4096 steps, and the other way: 0 and 1 are exact.
const float placeSteps = 4095.0f;
float packedPlace(vec2 place)
{
  vec2 steps =
    floor(clamp((place + vec2(1.0f)) / 3.0f, vec2(0.0f), vec2(1.0f)) * placeSteps + vec2(0.5f));
  return steps.x * (placeSteps + 1.0f) + steps.y;
}
vec2 unpackedPlace(float packedNumber)
{
  float x = floor(packedNumber / (placeSteps + 1.0f));
  return vec2(x, packedNumber - x * (placeSteps + 1.0f)) * 3.0f / placeSteps - vec2(1.0f);
}

// A linear colour as sRGB has it, and the other way.
vec3 encodedSrgb(vec3 color)
{
  vec3 inside = clamp(color, vec3(0.0f), vec3(1.0f));
  vec3 dark = 12.92f * inside;
  vec3 bright = 1.055f * pow(max(inside, vec3(0.0031308f)), vec3(1.0f / 2.4f)) - vec3(0.055f);
  return mix(dark, bright, step(vec3(0.0031308f), inside));
}
vec3 decodedSrgb(vec3 color)
{
  vec3 dark = color / 12.92f;
  vec3 bright = pow((max(color, vec3(0.04045f)) + vec3(0.055f)) / 1.055f, vec3(2.4f));
  return mix(dark, bright, step(vec3(0.04045f), color));
}
