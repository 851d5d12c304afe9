// Declarations that the kernels of the tolerance field share (core/growth/Tolerance.h). The field
// holds one tolerance per voxel, in whole bricks of the volume.

#include "fields/bricks/bricks.glsl"

layout(binding = 0, r16ui) uniform coherent uimage3D tolerances;
// One word per brick: the least tolerance that something near it may bring in, or `resting`.
layout(binding = 1, std430) buffer Pending { uint pending[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform uint centre; // code

const uint wall = 0xFFFFu; // also in place of a cost
const uint nowhere = 0xFFFEu; // open, but no path leads there
const uint resting = 0xFFFFFFFFu;

uint costOf(uint code)
{
    return min(max(code, centre) - min(code, centre), nowhere);
}
