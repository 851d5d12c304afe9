// Reads the visible surface as it was when the edit began (core/sculpt/CutFrame.h, rule 3).

#include "fields/bricks/bricks.glsl"

layout(binding = 0) uniform usampler3D codes;
layout(binding = 1) uniform usampler3D radiation;
// Initial radiation of the bricks that this edit has changed: slot + 1 for each brick, 0 for none.
layout(binding = 2, std430) readonly buffer SnapshotSlots { uint snapshotSlots[]; };
layout(binding = 3, std430) readonly buffer Snapshots { uint snapshots[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform int thresholdCode;
uniform bool restore;
uniform bool asWhole;

uint codeAt(ivec3 voxel)
{
    return texelFetch(codes, voxel, 0).r;
}

uint radiationAt(ivec3 voxel)
{
    uint slot = snapshotSlots[brickIndex(voxel >> 4, volumeBricks)];
    if (slot == 0u)
        return texelFetch(radiation, voxel, 0).r;
    ivec3 local = voxel & 15;
    uint offset = (slot - 1u) * 4096u + uint(local.x + 16 * (local.y + 16 * local.z));
    return snapshots[offset >> 2] >> ((offset & 3u) * 8u) & 0xFFu;
}

#include "kernels/cut/interpolate.glsl"

ivec3 nearestTo(ivec3 p)
{
    return (p + (1 << 15)) >> 16;
}

bool denseHere(ivec3 p)
{
    if (!restore)
        return dense(p, thresholdCode);
    return insideVolume(p) && int(codeAt(nearestTo(p))) >= thresholdCode;
}

// Only valid inside the volume.
bool carvedHere(ivec3 p)
{
    if (asWhole)
        return false;
    return restore ? radiationAt(nearestTo(p)) >= 128u : carved(p);
}

bool materialHere(ivec3 p)
{
    return denseHere(p) && !carvedHere(p);
}
