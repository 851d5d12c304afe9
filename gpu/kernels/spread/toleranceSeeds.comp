// Sums the codes of a label's seeds (core/growth/Tolerance.h). One work-group per listed brick;
// each reports the number of its seeds, and their sum.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "fields/bricks/seedWord.glsl"

layout(binding = 0) uniform usampler3D codes;
layout(binding = 1) uniform usampler3D pageTable; // of the seed words
layout(binding = 2) uniform usampler3D words; // atlas
layout(binding = 0, std430) readonly buffer Bricks { uint bricks[]; };
layout(binding = 1, std430) writeonly buffer Sums { uvec2 sums[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform uint label;

shared uint count;
shared uint sum; // sum of at most 4096 codes

void main()
{
    if (gl_LocalInvocationIndex == 0u) {
        count = 0u;
        sum = 0u;
    }
    barrier();
    ivec3 brick = brickPosition(int(bricks[gl_WorkGroupID.x]), volumeBricks);
    uint entry = texelFetch(pageTable, brick, 0).r;
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
        ivec3 voxel = brick * brickSide + voxelInBrick(offset);
        if (!inside(voxel, volumeSize))
            continue;
        uint word = texelFetch(words, atlasTexel(entry, voxel), 0).r;
        if (isSeedOf(word, label)) {
            atomicAdd(count, 1u);
            atomicAdd(sum, texelFetch(codes, voxel, 0).r);
        }
    }
    barrier();
    if (gl_LocalInvocationIndex == 0u)
        sums[gl_WorkGroupID.x] = uvec2(count, sum);
}
