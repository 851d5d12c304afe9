// Sums the codes around seeds (GrowLimits in core/growth/GrowthCommands.h): for every label, with
// one work-group per listed brick of the seed words; or, with LISTED, for every group of seeds,
// with one invocation per listed voxel. The sums have 64 bits, in two words, low word first.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "fields/bricks/seedWord.glsl"

layout(binding = 0) uniform usampler3D words; // atlas
layout(binding = 1) uniform usampler3D pageTable;
layout(binding = 2) uniform usampler3D codes;
#ifdef LISTED
layout(binding = 0, std430) readonly buffer Entries { uvec4 entries[]; }; // voxel, label | group << 8
uniform uint entryCount;
#else
layout(binding = 0, std430) readonly buffer Bricks { uint bricks[]; };
#endif
// For each label or group: number of voxels, sum of codes, sum of squared codes.
layout(binding = 1, std430) buffer Sums { uint sums[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform uint lowCode;
uniform uint highCode;
const int seedReach = 3;

void add(uint place, uint low, uint high)
{
    uint before = atomicAdd(sums[place], low);
    uint carry = before + low < before ? 1u : 0u;
    if (high + carry != 0u)
        atomicAdd(sums[place + 1u], high + carry);
}

bool isSeedWord(uint word)
{
    return isPendingSeed(word) || (isMember(word) && isSeed(word));
}

void addAround(ivec3 seed, uint group)
{
    ivec3 from = max(seed - seedReach, ivec3(0));
    ivec3 to = min(seed + seedReach, volumeSize - 1);
    uint count = 0u;
    uint sum = 0u;
    uint squaresLow = 0u;
    uint squaresHigh = 0u;
    for (int z = from.z; z <= to.z; ++z) {
        for (int y = from.y; y <= to.y; ++y) {
            for (int x = from.x; x <= to.x; ++x) {
                uint code = texelFetch(codes, ivec3(x, y, z), 0).r;
                if (code < lowCode || code > highCode)
                    continue;
                ++count;
                sum += code;
                uint carry;
                squaresLow = uaddCarry(squaresLow, code * code, carry);
                squaresHigh += carry;
            }
        }
    }
    add(6u * group, count, 0u);
    add(6u * group + 2u, sum, 0u);
    add(6u * group + 4u, squaresLow, squaresHigh);
}

#ifdef LISTED
void main()
{
    if (gl_GlobalInvocationID.x >= entryCount)
        return;
    uvec4 listed = entries[gl_GlobalInvocationID.x];
    ivec3 voxel = ivec3(listed.xyz);
    uint entry = texelFetch(pageTable, voxel / brickSide, 0).r;
    if (entry == 0u)
        return;
    uint word = texelFetch(words, atlasTexel(entry, voxel), 0).r;
    if (isSeedWord(word) && labelOf(word) == (listed.w & 255u))
        addAround(voxel, listed.w >> 8);
}
#else
void main()
{
    ivec3 brick = brickPosition(int(bricks[gl_WorkGroupID.x]), volumeBricks);
    uint entry = texelFetch(pageTable, brick, 0).r;
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
        ivec3 voxel = brick * brickSide + voxelInBrick(offset);
        if (!inside(voxel, volumeSize))
            continue;
        uint word = texelFetch(words, atlasTexel(entry, voxel), 0).r;
        if (isSeedWord(word))
            addAround(voxel, labelOf(word));
    }
}
#endif
