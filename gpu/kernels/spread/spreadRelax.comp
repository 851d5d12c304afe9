// Relaxes listed bricks for growing from seeds until nothing changes in them
// (core/growth/SeedSpread.h). One work-group per brick: what neighbours offer across the border is
// read once, then rows are swept in both directions along each axis.
//
// Other groups may write while their border is read here. Words only decrease, and a group that
// changes its border notifies the adjacent bricks, so whatever was missed is read in the next
// round.
//
// DOUBT: the inverse, after seeds were removed or walls were added: a word that no neighbour offers
// any more, nor less than it, becomes unreached. Since every step costs something, every remaining
// word either came from a seed or will be replaced by a lower one.

layout(local_size_x = 256) in;

#include "fields/bricks/seedWord.glsl"
#include "kernels/spread/spread.glsl"

layout(binding = 0) uniform usampler3D codes;
layout(binding = 0, std430) readonly buffer Bricks { uint bricks[]; }; // places in the box

uniform ivec3 volumeSize;
uniform uint differenceWeight;
uniform uint lengths[13]; // lengths of directions 2n and 2n + 1

// A brick that is not stable by then waits for its next turn, because llvmpipe ends all loops of an
// invocation after 65535 iterations.
const uint mostRounds = 64u;

shared uint word[4096];
shared uint codePair[2048]; // codes of a voxel and of the voxel 8 slices further
shared uint changed;
shared uint around;
shared uint least;

uint codeAt(uint offset)
{
    return codePair[offset & 2047u] >> (offset >> 11 << 4) & 0xFFFFu;
}

uint globalCode(ivec3 texel)
{
    ivec3 voxel = min(texel + firstBrick * brickSide, volumeSize - 1);
    return texelFetch(codes, voxel, 0).r;
}

uint stepCost(uint a, uint b, uint direction)
{
    return (max(a, b) - min(a, b)) * differenceWeight + lengths[direction >> 1];
}

// The least word that neighbours outside of its brick offer a voxel, for the given directions.
uint offeredBeyond(ivec3 origin, uint offset, uint ownCode, uint first, uint last)
{
    ivec3 local = voxelInBrick(int(offset));
    uint best = unreached;
    for (uint direction = first; direction < last; ++direction) {
        ivec3 neighbour = local + neighbourOffsets[direction];
        ivec3 texel = origin + neighbour;
        if (inside(neighbour, ivec3(brickSide)) || !inside(texel, boxBricks * brickSide))
            continue;
        uint there = imageLoad(words, texel).r;
        if (there != wall && there != unreached)
            best = min(best, offered(there, stepCost(globalCode(texel), ownCode, direction)));
    }
    return best;
}

// The same for neighbours inside its brick.
uint offeredWithin(uint offset, uint ownCode, uint first, uint last)
{
    ivec3 local = voxelInBrick(int(offset));
    uint best = unreached;
    for (uint direction = first; direction < last; ++direction) {
        ivec3 neighbour = local + neighbourOffsets[direction];
        if (!inside(neighbour, ivec3(brickSide)))
            continue;
        uint other = uint(offsetInBrick(neighbour));
        best = min(best, offered(word[other], stepCost(codeAt(other), ownCode, direction)));
    }
    return best;
}

// Sweeps a row in one direction.
bool sweep(uint first, uint stride, uint direction)
{
    bool any = false;
    uint offset = first;
    uint before = word[offset];
    uint beforeCode = codeAt(offset);
    for (int i = 1; i < brickSide; ++i) {
        offset += stride;
        uint own = word[offset];
        uint code = codeAt(offset);
        uint offer = offered(before, stepCost(code, beforeCode, direction));
        if (offer < own) {
            word[offset] = offer;
            own = offer;
            any = true;
        }
        before = own;
        beforeCode = code;
    }
    return any;
}

bool sweepBothWays(uint first, uint stride, uint direction)
{
    bool forth = sweep(first, stride, direction);
    bool back = sweep(first + 15u * stride, 0u - stride, direction);
    return forth || back;
}

void load(ivec3 origin, uint lane)
{
    for (uint pair = lane; pair < 2048u; pair += 256u) {
        ivec3 texel = origin + voxelInBrick(int(pair));
        ivec3 later = texel + ivec3(0, 0, 8);
        word[pair] = imageLoad(words, texel).r;
        word[pair + 2048u] = imageLoad(words, later).r;
        codePair[pair] = globalCode(texel) | globalCode(later) << 16;
    }
}

#ifdef DOUBT

bool work(ivec3 origin, uint lane)
{
    bool any = false;
    for (uint offset = lane; offset < 4096u; offset += 256u) {
        uint own = word[offset];
        if (own < leastPathWord || own == unreached)
            continue;
        uint code = codeAt(offset);
        uint best = offeredWithin(offset, code, 0u, uint(CONNECTIVITY));
        if (best > own)
            best = min(best, offeredBeyond(origin, offset, code, 0u, uint(CONNECTIVITY)));
        if (best > own) {
            word[offset] = unreached;
            any = true;
        }
    }
    return any;
}

#else

bool work(ivec3 origin, uint lane)
{
    bool any = sweepBothWays(16u * lane, 1u, 0u);
    barrier();
    any = sweepBothWays((lane & 15u) | (lane >> 4) << 8, 16u, 2u) || any;
    barrier();
    any = sweepBothWays(lane, 256u, 4u) || any;
#if CONNECTIVITY > 6
    barrier();
    for (uint offset = lane; offset < 4096u; offset += 256u) {
        uint own = word[offset];
        if (own < leastPathWord)
            continue;
        uint offer = offeredWithin(offset, codeAt(offset), 6u, uint(CONNECTIVITY));
        if (offer < own) {
            word[offset] = offer;
            any = true;
        }
    }
#endif
    return any;
}

// Reads across the border, once. Faces are processed one after the other; each voxel is written by
// one invocation.
void takeFromBeyond(ivec3 origin, uint lane)
{
    for (int face = 0; face < 6; ++face) {
        ivec3 local;
        int axis = face >> 1;
        local[axis] = 15 * (face & 1);
        local[(axis + 1) % 3] = int(lane & 15u);
        local[(axis + 2) % 3] = int(lane >> 4);
        uint offset = uint(offsetInBrick(local));
        uint own = word[offset];
        if (own >= leastPathWord) {
            uint offer = offeredBeyond(origin, offset, codeAt(offset), 0u, uint(CONNECTIVITY));
            if (offer < own)
                word[offset] = offer;
        }
        barrier();
    }
}

#endif

void main()
{
    uint lane = gl_LocalInvocationIndex;
    int slot = int(bricks[gl_WorkGroupID.x]);
    ivec3 brick = brickPosition(slot, boxBricks);
    ivec3 origin = brick * brickSide;
    load(origin, lane);
    if (lane == 0u) {
        around = 0u;
        least = resting;
    }
    barrier();
#ifndef DOUBT
    takeFromBeyond(origin, lane);
#endif
    bool again = true;
    for (uint round = 0u; again && round < mostRounds; ++round) {
        if (lane == 0u)
            changed = 0u;
        barrier();
        if (work(origin, lane))
            changed = 1u;
        barrier();
        again = changed != 0u;
        barrier();
    }

    uint beside = 0u;
    uint cost = resting;
    for (uint offset = lane; offset < 4096u; offset += 256u) {
        ivec3 local = voxelInBrick(int(offset));
        uint now = word[offset];
        if (imageLoad(words, origin + local).r == now)
            continue;
        imageStore(words, origin + local, uvec4(now));
        uint sides = bricksBeside(local);
        beside |= sides;
        if (sides != itself)
            cost = min(cost, now >> 8);
    }
    if (beside != 0u) {
        atomicOr(around, beside);
        atomicMin(least, cost);
    }
    barrier();
    if (lane == 0u && again) {
#ifdef DOUBT
        doubtful[slot] = 0u;
#else
        pending[slot] = 0u;
#endif
    }
    // The first 27 invocations notify one brick each.
    if (lane < 27u && (around >> lane & 1u) != 0u) {
        int other = brickBeside(brick, lane);
#ifdef DOUBT
        if (lane == 13u)
            pending[slot] = 0u;
        else if (other >= 0)
            doubtful[other] = 0u;
#else
        if (lane != 13u && other >= 0)
            atomicMin(pending[other], least);
#endif
    }
}
