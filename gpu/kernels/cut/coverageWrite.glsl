// Writes a cut into the coverage of a layer (core/sculpt/CutFrame.h, end of rule 6). Requires
// fields/bricks/bricks.glsl.

#include "kernels/cut/protected.glsl"

layout(binding = 1) uniform usampler3D pageTable;
layout(binding = 0, r8ui) uniform uimage3D coverage; // atlas

uniform bool refill;

// Returns whether the voxel has changed. `entry` is the page table entry of its brick.
bool writeCut(uint entry, ivec3 voxel, uint cut)
{
    ivec3 texel = atlasTexel(entry, voxel);
    uint held = imageLoad(coverage, texel).r;
    uint left = min(held, 255u - cut);
    uint value = refill ? (left > cut ? left : 0u) : max(held, cut);
    if (value == held || (!refill && isProtected(voxel)))
        return false;
    imageStore(coverage, texel, uvec4(value));
    return true;
}
