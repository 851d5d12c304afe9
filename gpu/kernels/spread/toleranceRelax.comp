// Relaxes the tolerances in listed bricks until they are stable (core/growth/Tolerance.h). One
// work-group per brick: what neighbours bring in across the border is read once, then rows are
// swept in both directions along each axis until nothing changes.
//
// Other groups may write while their border is read here. Tolerances only decrease, and a group
// that changes its border notifies the adjacent bricks whose tolerances could decrease by that, so
// whatever was missed is read in the next round.

layout(local_size_x = 256) in;

#include "kernels/spread/tolerance.glsl"
#include "fields/bricks/seedWord.glsl"

layout(binding = 0) uniform usampler3D codes;
layout(binding = 0, std430) readonly buffer Bricks { uint bricks[]; };

// A brick that is not stable by then waits for its next turn, because llvmpipe ends all loops of an
// invocation after 65535 iterations.
const uint mostRounds = 64u;

shared uint pair[4096]; // cost << 16 | tolerance; of a wall both are `wall`
shared uint changed;
shared uint around; // adjacent bricks that this one may change, one bit each
shared uint least; // least tolerance that it may bring

uint costAt(ivec3 voxel)
{
    return costOf(texelFetch(codes, min(voxel, volumeSize - 1), 0).r);
}

// The tolerance through a neighbour of that tolerance. A wall, or nothing at all, never gives a
// lower one.
uint through(uint tolerance, uint own)
{
    return max(tolerance & 0xFFFFu, own >> 16);
}

uint withTolerance(uint own, uint tolerance)
{
    return (own & 0xFFFF0000u) | tolerance;
}

void load(ivec3 origin, uint lane)
{
    for (uint offset = lane; offset < 4096u; offset += 256u) {
        ivec3 voxel = origin + voxelInBrick(int(offset));
        uint tolerance = imageLoad(tolerances, voxel).r;
        pair[offset] = (tolerance == wall ? wall : costAt(voxel)) << 16 | tolerance;
    }
}

// Sweeps a row in one direction.
bool sweep(uint first, uint stride)
{
    bool any = false;
    uint offset = first;
    uint before = pair[offset];
    for (int i = 1; i < brickSide; ++i) {
        offset += stride;
        uint own = pair[offset];
        uint offer = through(before, own);
        if (offer < (own & 0xFFFFu)) {
            own = withTolerance(own, offer);
            pair[offset] = own;
            any = true;
        }
        before = own;
    }
    return any;
}

bool sweepBothWays(uint first, uint stride)
{
    bool forth = sweep(first, stride);
    bool back = sweep(first + 15u * stride, 0u - stride);
    return forth || back;
}

bool work(uint lane)
{
    bool any = sweepBothWays(16u * lane, 1u);
    barrier();
    any = sweepBothWays((lane & 15u) | (lane >> 4) << 8, 16u) || any;
    barrier();
    any = sweepBothWays(lane, 256u) || any;
#if CONNECTIVITY > 6
    barrier();
    for (uint offset = lane; offset < 4096u; offset += 256u) {
        uint own = pair[offset];
        if (own >> 16 >= (own & 0xFFFFu))
            continue; // a wall, or as low as it can be
        ivec3 local = voxelInBrick(int(offset));
        uint best = own & 0xFFFFu;
        for (int direction = 6; direction < CONNECTIVITY; ++direction) {
            ivec3 neighbour = local + neighbourOffsets[direction];
            if (inside(neighbour, ivec3(brickSide)))
                best = min(best, through(pair[offsetInBrick(neighbour)], own));
        }
        if (best < (own & 0xFFFFu)) {
            pair[offset] = withTolerance(own, best);
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
    ivec3 field = volumeBricks * brickSide;
    for (int face = 0; face < 6; ++face) {
        ivec3 local;
        int axis = face >> 1;
        local[axis] = 15 * (face & 1);
        local[(axis + 1) % 3] = int(lane & 15u);
        local[(axis + 2) % 3] = int(lane >> 4);
        int offset = offsetInBrick(local);
        uint own = pair[offset];
        uint best = own & 0xFFFFu;
        if (own >> 16 < best) {
            for (int direction = 0; direction < CONNECTIVITY; ++direction) {
                ivec3 neighbour = local + neighbourOffsets[direction];
                if (inside(neighbour, ivec3(brickSide)) || !inside(origin + neighbour, field))
                    continue;
                best = min(best, through(imageLoad(tolerances, origin + neighbour).r, own));
            }
            pair[offset] = withTolerance(own, best);
        }
        barrier();
    }
}

// Finds which bricks a voxel at the border may change, and with how low a tolerance.
void wakeBeyond(ivec3 origin, ivec3 local, uint now)
{
    ivec3 field = volumeBricks * brickSide;
    uint bits = 0u;
    uint lowest = resting;
    for (int direction = 0; direction < CONNECTIVITY; ++direction) {
        ivec3 neighbour = local + neighbourOffsets[direction];
        ivec3 voxel = origin + neighbour;
        if (inside(neighbour, ivec3(brickSide)) || !inside(voxel, field))
            continue;
        uint there = imageLoad(tolerances, voxel).r;
        if (there == wall || there <= now)
            continue;
        uint brought = max(now, costAt(voxel));
        if (brought >= there)
            continue;
        ivec3 other = (neighbour + brickSide) / brickSide; // 0 … 2 along each axis
        bits |= 1u << (other.x + 3 * other.y + 9 * other.z);
        lowest = min(lowest, brought);
    }
    if (bits != 0u) {
        atomicOr(around, bits);
        atomicMin(least, lowest);
    }
}

void main()
{
    uint lane = gl_LocalInvocationIndex;
    ivec3 brick = brickPosition(int(bricks[gl_WorkGroupID.x]), volumeBricks);
    ivec3 origin = brick * brickSide;
    load(origin, lane);
    if (lane == 0u) {
        around = 0u;
        least = resting;
    }
    barrier();
    takeFromBeyond(origin, lane);
    bool again = true;
    for (uint round = 0u; again && round < mostRounds; ++round) {
        if (lane == 0u)
            changed = 0u;
        barrier();
        if (work(lane))
            changed = 1u;
        barrier();
        again = changed != 0u;
        barrier();
    }

    for (uint offset = lane; offset < 4096u; offset += 256u) {
        ivec3 local = voxelInBrick(int(offset));
        uint now = pair[offset] & 0xFFFFu;
        if (imageLoad(tolerances, origin + local).r == now)
            continue;
        imageStore(tolerances, origin + local, uvec4(now));
        if (any(equal(local, ivec3(0))) || any(equal(local, ivec3(15))))
            wakeBeyond(origin, local, now);
    }
    barrier();
    if (lane == 0u && again)
        pending[bricks[gl_WorkGroupID.x]] = 0u;
    if (lane < 27u && (around >> lane & 1u) != 0u) {
        ivec3 other = brick + ivec3(int(lane % 3u), int(lane / 3u % 3u), int(lane / 9u)) - 1;
        atomicMin(pending[brickIndex(other, volumeBricks)], least);
    }
}
