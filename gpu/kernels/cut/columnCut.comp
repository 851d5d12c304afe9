// Cuts the columns of a mask plane into candidate bricks (core/sculpt/CutFrame.h, rule 6). One
// work-group per brick, or several bricks one after the other; each voxel is written by one
// invocation.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "kernels/cut/coverageWrite.glsl"
#include "kernels/cut/hidden.glsl"

struct Candidate {
    ivec4 planeBase; // x, y, z of the brick's first voxel, mm16; w: the brick
};
layout(binding = 0, std430) readonly buffer Candidates { Candidate candidates[]; };
layout(binding = 1, std430) readonly buffer TileSlots { uint tileSlots[]; }; // slot + 1, 0: none
struct Column {
    int from; // mm16
    int to;   // mm16
    int weight;
};
layout(binding = 2, std430) readonly buffer Columns { Column columns[]; };
layout(binding = 3, std430) writeonly buffer Changed { uint changed[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform uint candidateCount;
uniform ivec3 planePerI; // mm16
uniform ivec3 planePerJ;
uniform ivec3 planePerK;
uniform int pitch;
uniform int rampHalfWidth;
uniform ivec2 firstTile; // in tiles of 16 × 16 elements
uniform ivec2 tileCount;

uint ramp(int t)
{
    return uint((clamp(t, -rampHalfWidth, rampHalfWidth) + rampHalfWidth) * 255)
        / uint(2 * rampHalfWidth);
}

uint cutAt(ivec3 plane)
{
    ivec2 fromCorner = plane.xy - firstTile * 16 * pitch;
    if (any(lessThan(fromCorner, ivec2(0))))
        return 0u;
    ivec2 element = fromCorner / pitch;
    ivec2 tile = element >> 4;
    if (any(greaterThanEqual(tile, tileCount)))
        return 0u;
    uint slot = tileSlots[tile.x + tileCount.x * tile.y];
    if (slot == 0u)
        return 0u;
    Column c = columns[(slot - 1u) * 256u + uint(element.x & 15) + 16u * uint(element.y & 15)];
    if (c.weight == 0)
        return 0u;
    return min(uint(c.weight), min(ramp(c.to - plane.z), ramp(plane.z - c.from)));
}

void cutInto(uint slot)
{
    Candidate candidate = candidates[slot];
    ivec3 origin = brickPosition(candidate.planeBase.w, volumeBricks) * brickSide;
    uint entry = texelFetch(pageTable, origin >> 4, 0).r;
    bool any = false;
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
        ivec3 local = voxelInBrick(offset);
        if (!inside(origin + local, volumeSize))
            continue;
        uint cut = cutAt(candidate.planeBase.xyz + local.x * planePerI + local.y * planePerJ
            + local.z * planePerK);
        if (cut == 0u || isHidden(slot, local))
            continue;
        any = writeCut(entry, origin + local, cut) || any;
    }
    if (any)
        changed[slot] = 1u;
}

void main()
{
    for (uint slot = gl_WorkGroupID.x; slot < candidateCount; slot += gl_NumWorkGroups.x)
        cutInto(slot);
}
