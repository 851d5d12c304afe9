// Finds where a ball fits, and where it then holds a seed (core/growth/Passage.h), as bits. One
// work-group per job; the bits of passageFree.comp exist for all bricks around it.

layout(local_size_x = 64) in;

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;

#include "kernels/passage/passageDistance.glsl"

// The voxels of two rows that are farther from the set than a ball's radius, or within it.
uint pairOf(uint pair, ivec3 origin, bool beyond)
{
    uint found = 0u;
    for (int i = 0; i < 32; ++i) {
        ivec3 voxel = voxelInBrick(int(pair) * 32 + i);
        if (inside(origin + voxel, volumeSize) && (squareAt(voxel) == nowhere) == beyond)
            found |= 1u << i;
    }
    return found;
}

void main()
{
    PassageJob job = jobs[gl_WorkGroupID.x];
    ivec3 origin = brickPosition(int(job.brick), volumeBricks) * brickSide;
    lookAlongXy(job, blockedSet, true);
    uint centres[2];
    for (uint i = 0u; i < 2u; ++i)
        centres[i] = pairOf(gl_LocalInvocationID.x + 64u * i, origin, true);
    barrier();
    lookAlongXy(job, seedSet, false);
    for (uint i = 0u; i < 2u; ++i) {
        uint pair = gl_LocalInvocationID.x + 64u * i;
        uint near = centres[i] != 0u ? pairOf(pair, origin, false) : 0u;
        bits[bitWord(job.page, centreSet, pair)] = centres[i];
        bits[bitWord(job.page, entrySet, pair)] = centres[i] & near;
    }
}
