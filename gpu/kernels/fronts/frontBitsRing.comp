// Computes one generation of a growth of one label whose criterion does not depend on the parent
// (FrontBits): the voxels that are open and have a neighbour in the front. Every voxel is written
// by a single invocation, so there is no competition. Its word is the one that would win in
// growRing.comp: that of the lowest direction that leads from the front.
//
// One work-group per listed brick (frontBitsReach.comp), or several bricks one after the other; one
// invocation per word.

layout(local_size_x = 128) in;

#include "kernels/criterion/growth.glsl"
#include "kernels/fronts/frontBits.glsl"

layout(binding = 2, std430) restrict readonly buffer Front { uint front[]; };
layout(binding = 6, std430) restrict writeonly buffer Next { uint next[]; };
layout(binding = 7, std430) restrict buffer Open { uint open[]; };

uniform uint growing; // the label
uniform uint baseGeneration; // generation before the batch
uniform uint ring;

// Two rows of the front, in the brick or in a brick beside it.
uint frontAt(ListedBrick brick, int aside, int pair, int slice)
{
    ivec3 at = positionOf(brick) + ivec3(aside, pair >> 3, slice >> 4);
    if (any(lessThan(at, ivec3(0))) || any(greaterThanEqual(at, volumeBricks)))
        return 0u;
    return front[uint(brickIndex(at, volumeBricks)) * wordsOfFront
        + uint((slice & 15) << 3 | (pair & 7))];
}

// The two rows at an offset of dy.
uint rowsAt(ListedBrick brick, int aside, int pair, int slice, int dy)
{
    uint rows = frontAt(brick, aside, pair, slice);
    if (dy > 0)
        rows = rows >> 16 | frontAt(brick, aside, pair + 1, slice) << 16;
    else if (dy < 0)
        rows = rows << 16 | frontAt(brick, aside, pair - 1, slice) >> 16;
    return rows;
}

// The bits of voxels from which the front lies one step back.
uint cameBy(const ivec3 step, ListedBrick brick, int pair, int slice)
{
    uint rows = rowsAt(brick, 0, pair, slice - step.z, -step.y);
    if (step.x > 0)
        rows = (rows << 1 & 0xFFFEFFFEu)
            | (rowsAt(brick, -1, pair, slice - step.z, -step.y) >> 15 & 0x00010001u);
    else if (step.x < 0)
        rows = (rows >> 1 & 0x7FFF7FFFu)
            | (rowsAt(brick, 1, pair, slice - step.z, -step.y) & 0x00010001u) << 15;
    return rows;
}

uint claimed = 0u; // in the brick that is looked at
// binary digits of the direction of each claimed bit
uint directions[5] = uint[5](0u, 0u, 0u, 0u, 0u);

void claim(const uint direction, uint left, ListedBrick brick, int pair, int slice)
{
    uint fresh = cameBy(neighbourOffsets[direction], brick, pair, slice) & left & ~claimed;
    claimed |= fresh;
    for (int digit = 0; digit < 5; ++digit) {
        if ((direction >> digit & 1u) != 0u)
            directions[digit] |= fresh;
    }
}

void advance(ListedBrick brick)
{
    claimed = 0u;
    directions = uint[5](0u, 0u, 0u, 0u, 0u);
    uint at = brick.index * wordsOfFront + gl_LocalInvocationID.x;
    uint ours = brick.index * wordsOfOpen;
    uint left = open[ours + gl_LocalInvocationID.x];
    if (left == 0u) {
        next[at] = 0u;
        return;
    }
    int pair = int(gl_LocalInvocationID.x) & 7;
    int slice = int(gl_LocalInvocationID.x) >> 3;
    // Unrolled, so that the compiler knows each offset.
#define CLAIM(direction) claim(direction, left, brick, pair, slice)
    CLAIM(0u); CLAIM(1u); CLAIM(2u); CLAIM(3u); CLAIM(4u); CLAIM(5u);
#if CONNECTIVITY > 6
    CLAIM(6u); CLAIM(7u); CLAIM(8u); CLAIM(9u); CLAIM(10u); CLAIM(11u);
    CLAIM(12u); CLAIM(13u); CLAIM(14u); CLAIM(15u); CLAIM(16u); CLAIM(17u);
#endif
#if CONNECTIVITY > 18
    CLAIM(18u); CLAIM(19u); CLAIM(20u); CLAIM(21u);
    CLAIM(22u); CLAIM(23u); CLAIM(24u); CLAIM(25u);
#endif
    next[at] = claimed;
    if (claimed == 0u)
        return;
    open[ours + gl_LocalInvocationID.x] = left & ~claimed;
    atomicAdd(state.counts[ring + 1u], uint(bitCount(claimed)));
    reached[brick.page] = heldFront;
    ivec3 origin = positionOf(brick) * brickSide;
    uint generation = baseGeneration + ring + 1u;
    open[ours + lastFront] = generation;
    if ((claimed & 0x00010001u) != 0u)
        open[ours + lastFrontAtEnd] = generation;
    if ((claimed & 0x80008000u) != 0u)
        open[ours + lastFrontAtEnd + 1u] = generation;
    if (pair == 0 && (claimed & 0xFFFFu) != 0u)
        open[ours + lastFrontAtEnd + 2u] = generation;
    if (pair == 7 && claimed >> 16 != 0u)
        open[ours + lastFrontAtEnd + 3u] = generation;
    if (slice == 0)
        open[ours + lastFrontAtEnd + 4u] = generation;
    if (slice == 15)
        open[ours + lastFrontAtEnd + 5u] = generation;
    uint bits = claimed;
    do {
        int bit = findLSB(bits);
        bits &= bits - 1u;
        int offset = int(gl_LocalInvocationID.x) * 32 + bit;
        ivec3 voxel = origin + voxelInBrick(offset);
        uint direction = 0u;
        for (int digit = 0; digit < 5; ++digit)
            direction |= (directions[digit] >> bit & 1u) << digit;
        if (tellsHeld && imageLoad(labels, voxel).r == growing)
            direction = heldDirection;
        uint word = memberWord(generation, growing, direction);
        imageStore(words, pageTexel(brick.page, offset), uvec4(word));
        showLabel(word, voxel);
    } while (bits != 0u);
}

void main()
{
    for (uint slot = gl_WorkGroupID.x; slot < groups.x; slot += gl_NumWorkGroups.x)
        advance(bricks[slot]);
}
