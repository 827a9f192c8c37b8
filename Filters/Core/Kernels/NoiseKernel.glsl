// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Noise of kernels in the picture (Benard et al. 2010; Tricard et al. 2019): one kernel at one
// pixel, what of it is seen there, and the way from sums of kernels to a uniform field.

// Exponent of the envelope at the rim, where it is 5 %: -log(.05).
const float noiseRimExponent = 2.99573227f;

// Share of the change along a kernel's plane, from its centre to its rim, by which a pixel at the rim
// may lie off it, so that what is curved counts: a curved surface leaves its tangent plane with the
// square of the distance. On a sphere of a radius of 4 kernel radii every pixel keeps 97 % of the
// energy of its kernels, also beside the silhouette.
const float noiseSlopeTolerance = 1.0f;

// Expected variance (of kernels of weight 1 to 2.7 for N' = 32) and squared amplitude of a phasor
// below which there is hardly any kernel: the field becomes flat instead of being amplified.
const float noiseVarianceFloor = 1.0e-3f;
const float phasorFloor = 1.0e-3f;

// Distance in pixels at which the envelope ends, and the bandwidth of this distance.
float kernelRadius(float bandwidth)
{
  return sqrt(noiseRimExponent / screenPi) / max(bandwidth, 1.0e-30f);
}

float kernelBandwidth(float radius)
{
  return sqrt(noiseRimExponent / screenPi) / max(radius, 1.0e-30f);
}

// Envelope at this squared distance from the centre, cut off at the rim.
float noiseEnvelope(float distanceSquared, float bandwidth)
{
  float exponent = screenPi * bandwidth * bandwidth * distanceSquared;
  return exponent <= noiseRimExponent ? exp(-exponent) : 0.0f;
}

// Kernel of weight 1 at an offset from its centre: envelope times cosine and sine of the wave. The
// first is the Gabor kernel. direction: of the wave vector, a unit vector.
vec2 phasorAlong(vec2 offset, vec2 direction, float frequency, float bandwidth, float phase)
{
  float cycles = frequency * (offset.x * direction.x + offset.y * direction.y);
  float angle = 2.0f * screenPi * (cycles - floor(cycles)) + phase;
  return noiseEnvelope(dot(offset, offset), bandwidth) * vec2(cos(angle), sin(angle));
}

vec2 phasorKernel(vec2 offset, float frequency, float bandwidth, float orientation, float phase)
{
  return phasorAlong(
    offset, vec2(cos(orientation), sin(orientation)), frequency, bandwidth, phase);
}

float gaborKernel(vec2 offset, float frequency, float bandwidth, float orientation, float phase)
{
  return phasorKernel(offset, frequency, bandwidth, orientation, phase).x;
}

// Depth by which a pixel at this squared distance from the centre may lie off the kernel's plane,
// which changes by `slope` per pixel, and still be on it. tolerance: of a surface that faces the
// viewer.
float noiseDepthTolerance(float distanceSquared, float slope, float radius, float tolerance)
{
  return tolerance + noiseSlopeTolerance * slope * distanceSquared / max(radius, 1.0e-30f);
}

// How much a pixel counts whose depth deviates from the kernel's plane: 1 up to the tolerance, 0
// from twice that on.
float noiseDepthWeight(float deviation, float tolerance)
{
  float x = clamp(2.0f - abs(deviation) / max(tolerance, 1.0e-30f), 0.0f, 1.0f);
  return x * x * (3.0f - 2.0f * x);
}

// The same for a pixel at an offset from the centre of a kernel's plane: its depth there, the change
// of that per pixel (yz), and the kernel's radius.
float noisePlaneWeight(vec2 offset, float depth, vec4 plane, float tolerance)
{
  vec2 slope = vec2(plane.y, plane.z);
  float deviation = depth - plane.x - dot(offset, slope);
  return noiseDepthWeight(deviation,
    noiseDepthTolerance(dot(offset, offset), length(slope), plane.w, tolerance));
}

// One kernel as shaders hold it.
struct PackedKernel
{
  vec4 place; // centre (xy), bandwidth, weight
  vec4 wave;  // direction of the wave vector (xy), frequency, phase
  vec4 plane; // depth at the centre, its change per pixel (yz), radius
};

bool insideKernel(vec4 place, vec2 offset)
{
  return screenPi * place.z * place.z * dot(offset, offset) <= noiseRimExponent;
}

// What a kernel adds to the sums of a pixel of which `share` counts. Gabor and spot: to the noise
// and to its expected variance; phasor: to real and imaginary part.
vec2 phasorTerm(PackedKernel kernel, vec2 offset, float share)
{
  return share * kernel.place.w *
    phasorAlong(
      offset, vec2(kernel.wave.x, kernel.wave.y), kernel.wave.z, kernel.place.z, kernel.wave.w);
}

vec2 gaborTerm(PackedKernel kernel, vec2 offset, float share)
{
  vec2 phasor = phasorTerm(kernel, offset, share);
  return vec2(phasor.x, 0.5f * dot(phasor, phasor));
}

// spot: the value of the spot there.
vec2 spotTerm(PackedKernel kernel, float spot, float share)
{
  float value = share * kernel.place.w * (cos(kernel.wave.w) < 0.0f ? -spot : spot);
  return vec2(value, value * value);
}

// Where in a spot of so many texels an offset is: whole numbers at their centres, from 1 on, since
// one more lies around them.
vec2 spotTexel(PackedKernel kernel, vec2 offset, vec2 texels)
{
  vec2 along = vec2(kernel.wave.x, kernel.wave.y);
  vec2 place = vec2(dot(offset, along), along.x * offset.y - along.y * offset.x);
  vec2 texel = 0.5f * texels * (place / max(kernel.plane.w, 1.0e-30f)) + 0.5f * texels + 0.5f;
  return clamp(texel, vec2(0.0f), texels + 0.999f);
}

// Weight of a pixel of a kernel's disc in the share of it that is seen. Close to the envelope, but
// 0 at the rim, so that no pixel enters or leaves with a jump.
float noiseSampleWeight(float distanceSquared, float radius)
{
  float x = max(1.0f - distanceSquared / max(radius * radius, 1.0e-30f), 0.0f);
  return x * x;
}

// Weight of a kernel of whose disc this share is seen. Faint kernels cost as much as others, and add
// next to nothing: with less than a tenth they are not drawn.
float noiseShownShare(float seen)
{
  return clamp((seen - 0.1f) / 0.9f, 0.0f, 1.0f);
}

// Pixels between the samples of a disc of this radius, in both directions: 13 to 28 samples from a
// radius of 5 on. Half a step around the disc there are never more than eight in a row.
float noiseSampleStep(float radius)
{
  return max(ceil(radius / 3.0f), 1.0f);
}

// A sum of kernels over its expected deviation. lowest: variance that is hardly any.
float normalisedNoise(float sum, float variance, float lowest)
{
  return sum * inversesqrt(max(variance, 0.0f) + lowest);
}

// Place of a normalised value in a table of equal steps from -range to range.
float noiseTablePosition(float value, float range, float steps)
{
  return clamp((0.5f + 0.5f * value / range) * steps, 0.0f, steps);
}

// Least width of a field that has a certain variance: 1 where there is none, so that ink equals the
// tone there.
float noiseFlatWidth(float variance, float lowest)
{
  return lowest / (max(variance, 0.0f) + lowest);
}

// Width of a field from its change along x and y, not below that of a flat one.
float noiseFieldWidth(vec2 change, float flatWidth, float least)
{
  return max(min(max(length(change), flatWidth + 1.0e-6f), 1.0f), least);
}

// Phase of a sum of phasors, 0 to 1 over half a turn to both sides: uniform. 0.5 where there is
// hardly any sum.
float phasorValue(vec2 sum)
{
  float square = dot(sum, sum);
  float turn = square > 0.0f ? abs(atan(sum.y, sum.x)) / screenPi : 0.5f;
  return mix(turn, 0.5f, noiseFlatWidth(square, phasorFloor));
}

// Change of that value by one pixel in a direction in which the sum changes by `change` (central
// differences). The sine of the phase's step is measured; around singularities it exceeds 1.
float phasorChange(vec2 sum, vec2 change)
{
  float sine = (sum.x * change.y - sum.y * change.x) / (dot(sum, sum) + phasorFloor);
  float x = clamp(sine, -2.0f, 2.0f);
  float square = x * x;
  return x * (1.0f + square * (1.0f / 6.0f + square * 0.075f)) / screenPi;
}
