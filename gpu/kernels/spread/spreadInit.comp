// Sets the initial word of every voxel of the box for growing from seeds
// (core/growth/SeedSpread.h): wall, seed or unreached. FIND instead computes the box around all
// seeds, and their labels.
//
// With `update` the words hold the result of an earlier run: only voxels whose kind has changed are
// written, and the bricks around them are notified.

layout(local_size_x = 64) in;

#include "fields/bricks/seedWord.glsl"
#include "kernels/spread/spread.glsl"

layout(binding = 0) uniform usampler3D labels;
layout(binding = 1) uniform usampler3D pageTable; // of the seed words
layout(binding = 2) uniform usampler3D seedWords; // atlas
layout(binding = 3) uniform usampler3D codes;
layout(binding = 0, std430) readonly buffer Bricks { uint bricks[]; }; // FIND: bricks of the volume
layout(binding = 3, std430) buffer Found {
    int low[3];
    int high[3]; // inclusive
    uint labels[8];
} found;

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform uint brickCount;
uniform uint firstSlot; // index of the first brick
uniform ivec3 boxLow;
uniform ivec3 boxHigh; // one beyond
uniform uint seeds[8]; // one bit per label
uniform uint overwritable[8];
// core::GrowthRange
uniform uint closedLabels[8];
uniform uint rangeLow;
uniform uint rangeHigh;
uniform ivec3 withinLow;
uniform ivec3 withinHigh; // one beyond
uniform bool update;

bool isSeedLabel(uint label)
{
    return (seeds[label >> 5] >> (label & 31u) & 1u) != 0u;
}

uint atFirst(ivec3 voxel, uint entry)
{
    uint held = texelFetch(labels, voxel, 0).r;
    if (isSeedLabel(held))
        return held;
    if (held != 0u && (overwritable[held >> 5] >> (held & 31u) & 1u) == 0u)
        return wall;
    if (any(lessThan(voxel, withinLow)) || any(greaterThanEqual(voxel, withinHigh)))
        return wall;
    if ((closedLabels[held >> 5] >> (held & 31u) & 1u) != 0u)
        return wall;
    uint code = texelFetch(codes, voxel, 0).r;
    if (code < rangeLow || code > rangeHigh)
        return wall;
    if (entry != 0u) {
        uint word = texelFetch(seedWords, atlasTexel(entry, voxel), 0).r;
        if (word == barrierWord)
            return wall;
        if (isPendingSeed(word) && isSeedLabel(labelOf(word)))
            return labelOf(word);
    }
    return unreached;
}

// @param around bricks, one bit each
void wake(ivec3 brick, uint around, bool doubt)
{
    for (uint bit = 0u; bit < 27u; ++bit) {
        if ((around >> bit & 1u) == 0u)
            continue;
        int other = brickBeside(brick, bit);
        if (other < 0)
            continue;
        if (doubt)
            doubtful[other] = 0u;
        else
            pending[other] = 0u;
    }
}

#ifdef FIND

void main()
{
    for (uint slot = gl_WorkGroupID.x; slot < brickCount; slot += gl_NumWorkGroups.x) {
        ivec3 brick = brickPosition(int(bricks[slot]), volumeBricks);
        uint entry = texelFetch(pageTable, brick, 0).r;
        ivec3 low = volumeSize;
        ivec3 high = ivec3(-1);
        for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
            ivec3 voxel = brick * brickSide + voxelInBrick(offset);
            if (!inside(voxel, volumeSize))
                continue;
            uint word = atFirst(voxel, entry);
            if (word == wall || word == unreached)
                continue;
            low = min(low, voxel);
            high = max(high, voxel);
            uint bit = 1u << (word & 31u);
            if ((found.labels[word >> 5] & bit) == 0u)
                atomicOr(found.labels[word >> 5], bit);
        }
        if (high.x < 0)
            continue;
        for (int axis = 0; axis < 3; ++axis) {
            atomicMin(found.low[axis], low[axis]);
            atomicMax(found.high[axis], high[axis]);
        }
    }
}

#else

void main()
{
    for (uint i = gl_WorkGroupID.x; i < brickCount; i += gl_NumWorkGroups.x) {
        ivec3 place = brickPosition(int(firstSlot + i), boxBricks);
        ivec3 brick = place + firstBrick;
        uint entry = texelFetch(pageTable, brick, 0).r;
        for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
            ivec3 local = voxelInBrick(offset);
            ivec3 voxel = brick * brickSide + local;
            ivec3 texel = place * brickSide + local;
            bool within = all(greaterThanEqual(voxel, boxLow)) && all(lessThan(voxel, boxHigh));
            uint now = wall;
            if (within)
                now = atFirst(voxel, entry);
            bool isSeedNow = now != wall && now != unreached;
            if (!update) {
                imageStore(words, texel, uvec4(now));
                if (isSeedNow)
                    wake(place, bricksBeside(local), false);
                continue;
            }
            uint before = imageLoad(words, texel).r;
            uint wasAtFirst = before < leastPathWord ? before : unreached;
            if (wasAtFirst == now)
                continue;
            imageStore(words, texel, uvec4(now));
            uint around = bricksBeside(local);
            // What was reached from here may have to be removed; what is here now may offer, or be
            // offered, something.
            bool offersLess = now == wall ? before != unreached : before != wall && now > before;
            if (offersLess)
                wake(place, around, true);
            if (isSeedNow)
                wake(place, around, false);
            else if (now == unreached)
                wake(place, itself, false);
        }
    }
}

#endif
