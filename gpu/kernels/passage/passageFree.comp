// Finds which voxels are not free for a label, and which are its seeds (core/growth/Passage.h), as
// bits. One work-group per job.

layout(local_size_x = 64) in;

#include "kernels/criterion/growth.glsl"
#include "kernels/passage/passageBits.glsl"

// Whether growth may take the voxel at all. What it has grown over does not change that.
bool isInRange(ivec3 voxel, uint word, uint there)
{
#ifdef RANGE
    uint before = there;
    if (isMember(word) && generationOf(word) > 0u && hasAdded(word, voxel))
        before = labelBelow(voxel);
    uint code = imageLoad(codes, voxel).r;
    return code >= rangeLow && code <= rangeHigh
        && (closedLabels[before >> 5] >> (before & 31u) & 1u) == 0u;
#else
    return true;
#endif
}

// Grown voxels count as unowned, so it does not matter when in a burst this is computed.
bool isOpen(uint label, uint word, uint there)
{
    if (word == barrierWord)
        return false;
    if (there == 0u || there == label
        || (overwritable[there >> 5] >> (there & 31u) & 1u) != 0u)
        return true;
    uint direction = word & 31u;
    return isMember(word) && generationOf(word) > 0u && direction != heldDirection
        && direction != heldSeedDirection && mayGrow(labelOf(word));
}

uint wordAt(ivec3 voxel)
{
    uint entry = pageEntry(voxel);
    return entry != 0u ? imageLoad(words, atlasTexel(entry, voxel)).r : unvisited;
}

void main()
{
    PassageJob job = jobs[gl_WorkGroupID.x];
    ivec3 origin = brickPosition(int(job.brick), volumeBricks) * brickSide;
    for (uint pair = gl_LocalInvocationID.x; pair < wordsPerSet; pair += 64u) {
        uint blocked = 0u;
        uint seeds = 0u;
        for (int i = 0; i < 32; ++i) {
            ivec3 voxel = origin + voxelInBrick(int(pair) * 32 + i);
            if (!inside(voxel, volumeSize))
                continue; // never looked at
            uint word = wordAt(voxel);
            uint there = imageLoad(labels, voxel).r;
            if (!isOpen(job.label, word, there) || !isInRange(voxel, word, there)
                || !allows(job.label, voxel, imageLoad(codes, voxel).r))
                blocked |= 1u << i;
            if (isSeedOf(word, job.label))
                seeds |= 1u << i;
        }
        bits[bitWord(job.page, blockedSet, pair)] = blocked;
        bits[bitWord(job.page, seedSet, pair)] = seeds;
    }
}
