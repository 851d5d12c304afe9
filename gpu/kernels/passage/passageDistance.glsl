// Squared distances from the voxels of a brick to the nearest voxel of a set, up to the radius of a
// ball: along x by bit operations, then along y, then along z. Include this file after `volumeSize`
// and `volumeBricks`; needs 64 invocations.

#include "kernels/passage/passageBits.glsl"

uniform uvec3 spacing;
uniform ivec3 reach; // voxels, to 15
uniform uint greatest; // squared

const uint nowhere = 0xFFFFu;

// The result after x and y: for the slices of the brick and those within a ball's radius, 16 rows
// of 16 voxels, two voxels per word.
shared uint slices[16 * 46 * 8];

// 16 voxels of a row of a set; the row may lie outside the brick and the volume.
// @param clamped outside the volume use the nearest voxel, else nothing
uint rowOf(uint set, uint slot, int brickX, ivec2 yz, bool clamped)
{
    ivec2 size = volumeSize.yz;
    if (clamped)
        yz = clamp(yz, ivec2(0), size - 1);
    else if (any(lessThan(yz, ivec2(0))) || any(greaterThanEqual(yz, size)))
        return 0u;
    int x = clamp(brickX, 0, volumeBricks.x - 1);
    if (!clamped && x != brickX)
        return 0u;
    ivec3 brick = ivec3(x, yz >> 4);
    uint page = bitPages[slot * uint(volumeBricks.x * volumeBricks.y * volumeBricks.z)
        + uint(brickIndex(brick, volumeBricks))];
    if (page == 0u)
        return 0u; // farther away than a ball reaches
    uint row = uint((yz.x & 15) | (yz.y & 15) << 4);
    uint found = bits[bitWord(page - 1u, set, row >> 1)] >> ((row & 1u) * 16u) & 0xFFFFu;
    if (brickX < 0)
        return (found & 1u) * 0xFFFFu;
    if (!clamped || x < volumeBricks.x - 1)
        return found;
    uint last = uint((volumeSize.x - 1) & 15);
    uint beyond = (found >> last & 1u) * 0xFFFFu;
    uint inVolume = (2u << last) - 1u;
    return brickX > x ? beyond : (found & inVolume) | (beyond & ~inVolume);
}

uint capped(uint square)
{
    return square > greatest ? nowhere : square;
}

// Fills `slices` for a job. All invocations must call it.
void lookAlongXy(PassageJob job, uint set, bool clamped)
{
    ivec3 brick = brickPosition(int(job.brick), volumeBricks);
    ivec3 origin = brick * brickSide;
    int rows = brickSide * (brickSide + 2 * reach.z);
    for (int row = int(gl_LocalInvocationID.x); row < rows; row += 64) {
        ivec2 yz = ivec2(origin.y + (row & 15), origin.z + (row >> 4) - reach.z);
        uint best[16];
        for (int x = 0; x < 16; ++x)
            best[x] = nowhere;
        for (int dy = -reach.y; dy <= reach.y; ++dy) {
            ivec2 there = yz + ivec2(dy, 0);
            uint own = rowOf(set, job.slot, brick.x, there, clamped);
            uint below = rowOf(set, job.slot, brick.x - 1, there, clamped);
            uint above = rowOf(set, job.slot, brick.x + 1, there, clamped);
            if ((own | below | above) == 0u)
                continue;
            uint squareY = spacing.y * spacing.y * uint(dy * dy);
            uint upwards = own | above << 16;
            uint downwards = below | own << 16;
            for (int x = 0; x < 16; ++x) {
                // For −1 (none) these become greater than any ball's radius.
                uint up = uint(findLSB(upwards >> uint(x)));
                uint down = uint(31 - findMSB(downwards << uint(15 - x)));
                uint steps = min(min(up, down), 32u);
                uint square = spacing.x * spacing.x * steps * steps + squareY;
                best[x] = min(best[x], capped(square));
            }
        }
        for (int pair = 0; pair < 8; ++pair)
            slices[row * 8 + pair] = best[2 * pair] | best[2 * pair + 1] << 16;
    }
    barrier();
}

// The squared distance at a voxel of the brick, from `slices`; `nowhere` if it is beyond a ball's
// radius.
uint squareAt(ivec3 voxel)
{
    uint best = nowhere;
    uint shift = uint(voxel.x & 1) * 16u;
    int row = voxel.y + brickSide * (voxel.z + reach.z);
    for (int dz = -reach.z; dz <= reach.z; ++dz) {
        uint along = slices[(row + brickSide * dz) * 8 + (voxel.x >> 1)] >> shift & 0xFFFFu;
        uint square = along + spacing.z * spacing.z * uint(dz * dz);
        best = min(best, along == nowhere ? nowhere : capped(square));
    }
    return best;
}
