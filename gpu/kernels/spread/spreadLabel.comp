// Gives the voxels of listed bricks to the segments that their words name
// (core/growth/SeedSpread.h). Reports what changes in each brick, and writes only if requested. One
// work-group per brick.

layout(local_size_x = 64) in;

#include "fields/bricks/seedWord.glsl"
#include "kernels/spread/spread.glsl"

layout(binding = 1) uniform usampler3D pageTable; // of the seed words
layout(binding = 1, r32ui) uniform uimage3D seedWords; // atlas
layout(binding = 2, r8ui) uniform uimage3D labels;
layout(binding = 0, std430) readonly buffer Bricks { uint bricks[]; }; // of the volume
layout(binding = 3, std430) buffer Changed { uint changed[]; };

uniform ivec3 volumeBricks;
uniform bool write;

const uint changedLabel = 1u;
const uint changedWord = 2u;

void main()
{
    ivec3 brick = brickPosition(int(bricks[gl_WorkGroupID.x]), volumeBricks);
    uint entry = texelFetch(pageTable, brick, 0).r;
    uint found = 0u;
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
        ivec3 local = voxelInBrick(offset);
        uint won = imageLoad(words, (brick - firstBrick) * brickSide + local).r;
        if (won == wall || won == unreached)
            continue;
        uint label = won & 0xFFu;
        ivec3 voxel = brick * brickSide + local;
        if (imageLoad(labels, voxel).r == label)
            continue;
        found |= changedLabel;
        if (write)
            imageStore(labels, voxel, uvec4(label));
        if (entry == 0u)
            continue;
        ivec3 texel = atlasTexel(entry, voxel);
        uint word = imageLoad(seedWords, texel).r;
        if ((isMember(word) || isPendingSeed(word)) && labelOf(word) != label) {
            found |= changedWord;
            if (write)
                imageStore(seedWords, texel, uvec4(unvisited));
        }
    }
    if (found != 0u)
        atomicOr(changed[gl_WorkGroupID.x], found);
}
