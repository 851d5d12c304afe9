// Sets the initial value of every voxel: wall, seed or open (core/growth/Tolerance.h). One
// work-group per brick.
//
// It also sums a digest of the kind and place of each voxel. If only the digest is requested
// (`write` is false) the field stays: if the digest is the same, the field is still the correct
// result.

layout(local_size_x = 64) in;

#include "kernels/spread/tolerance.glsl"
#include "fields/bricks/seedWord.glsl"

layout(binding = 2, r16ui) uniform readonly uimage3D codes;
layout(binding = 3) uniform usampler3D labels;
layout(binding = 1) uniform usampler3D pageTable; // of the seed words
layout(binding = 2) uniform usampler3D words; // atlas
#ifdef OVERWRITTEN
layout(binding = 5) uniform usampler3D overwrittenPages;
layout(binding = 6) uniform usampler3D overwritten; // atlas
#endif
layout(binding = 2, std430) buffer Digest { uint digest[2]; };

uniform uint firstBrick; // index of the first brick in the volume
uniform uint label;
uniform uint overwritable[8]; // one bit per label
// core::GrowthRange
uniform uint closedLabels[8];
uniform uint rangeLow;
uniform uint rangeHigh;
uniform uint lowCode; // no limit: all codes
uniform uint highCode;
uniform bool write;

#include "kernels/criterion/growCriterion.glsl"

const uint isOpen = 0u;
const uint isWall = 1u;
const uint isSeeded = 2u;
const uint isHeld = 3u; // painted

// What the label plane would hold if growth had not added its label there.
uint beforeGrowth(ivec3 voxel, uint word, uint held)
{
    uint direction = word & 31u;
    if (!isMember(word) || generationOf(word) == 0u || direction == heldDirection
        || direction == heldSeedDirection || held != labelOf(word))
        return held;
#ifdef OVERWRITTEN
    uint entry = texelFetch(overwrittenPages, voxel >> 4, 0).r;
    if (entry != 0u)
        return texelFetch(overwritten, atlasTexel(entry, voxel), 0).r;
#endif
    return 0u;
}

uint kindOf(ivec3 voxel, uint word, uint code)
{
    if (isPainted(word) && labelOf(word) == label)
        return isHeld;
    if (word == barrierWord || (isMember(word) && labelOf(word) != label))
        return isWall;
    uint held = texelFetch(labels, voxel, 0).r;
    bool mayEnter = held == 0u || held == label || (overwritable[held >> 5] >> (held & 31u) & 1u) != 0u;
    uint before = beforeGrowth(voxel, word, held);
    bool isClosed = (closedLabels[before >> 5] >> (before & 31u) & 1u) != 0u;
    if (isClosed || code < rangeLow || code > rangeHigh)
        return isWall;
    if (!mayEnter || !allows(label, voxel, code))
        return isWall;
    return isSeedOf(word, label) ? isSeeded : isOpen;
}

uint scattered(uint number)
{
    number ^= number >> 16;
    number *= 0x7FEB352Du;
    number ^= number >> 15;
    number *= 0x846CA68Bu;
    return number ^ number >> 16;
}

shared uint least; // of the brick's seeds
shared uint sum[2];

void main()
{
    if (gl_LocalInvocationIndex == 0u) {
        least = resting;
        sum[0] = 0u;
        sum[1] = 0u;
    }
    barrier();
    uint slot = firstBrick + gl_WorkGroupID.x;
    ivec3 brick = brickPosition(int(slot), volumeBricks);
    uint entry = texelFetch(pageTable, brick, 0).r;
    uint first = resting;
    uvec2 told = uvec2(0u);
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
        ivec3 voxel = brick * brickSide + voxelInBrick(offset);
        if (!inside(voxel, volumeSize)) {
            if (write)
                imageStore(tolerances, voxel, uvec4(wall));
            continue;
        }
        uint word = unvisited;
        if (entry != 0u)
            word = texelFetch(words, atlasTexel(entry, voxel), 0).r;
        uint code = imageLoad(codes, voxel).r;
        uint kind = kindOf(voxel, word, code);
        if (kind != isOpen) {
            uint number = slot * 4096u + uint(offset);
            told.x += scattered(number * 4u + kind);
            told.y += scattered(number ^ kind * 0x9E3779B1u);
        }
        uint begins = kind == isHeld ? 0u : kind == isSeeded ? costOf(code) : kind == isWall ? wall : nowhere;
        if (begins < nowhere)
            first = min(first, begins);
        if (write)
            imageStore(tolerances, voxel, uvec4(begins));
    }
    if (first != resting)
        atomicMin(least, first);
    atomicAdd(sum[0], told.x);
    atomicAdd(sum[1], told.y);
    barrier();
    if (gl_LocalInvocationIndex < 2u)
        atomicAdd(digest[gl_LocalInvocationIndex], sum[gl_LocalInvocationIndex]);
    // The bricks around it find out what seeds at its border lead to.
    if (write && gl_LocalInvocationIndex < 27u && least != resting) {
        int beside = int(gl_LocalInvocationIndex);
        ivec3 other = brick + ivec3(beside % 3, beside / 3 % 3, beside / 9) - 1;
        if (inside(other, volumeBricks))
            atomicMin(pending[brickIndex(other, volumeBricks)], least);
    }
}
