// Takes a label out of listed bricks (EraseLabel in core/engine/LabelCommands.h): of a label
// plane, with SEED_WORDS of a seed map, with OVERWRITTEN of what members have overwritten. Tells
// which of them hold it; writes only where it is told to.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "fields/bricks/seedWord.glsl"

#if defined(SEED_WORDS) || defined(OVERWRITTEN)
#define PAGED
layout(binding = 1) uniform usampler3D pageTable;
#endif
#ifdef SEED_WORDS
layout(binding = 0, r32ui) uniform uimage3D voxels; // atlas
#else
layout(binding = 0, r8ui) uniform uimage3D voxels; // with OVERWRITTEN an atlas
#endif
layout(binding = 0, std430) readonly buffer Bricks { uint bricks[]; };
layout(binding = 1, std430) writeonly buffer Found { uint found[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform uint brickCount;
uniform uint label;
uniform bool erase;

#ifdef SEED_WORDS
const uint empty = unvisited;

bool bears(uint word)
{
    return (isMember(word) || isPendingSeed(word)) && labelOf(word) == label;
}
#else
const uint empty = 0u;

bool bears(uint value)
{
    return value == label;
}
#endif

void main()
{
    for (uint slot = gl_WorkGroupID.x; slot < brickCount; slot += gl_NumWorkGroups.x) {
        ivec3 brick = brickPosition(int(bricks[slot]), volumeBricks);
#ifdef PAGED
        uint entry = texelFetch(pageTable, brick, 0).r;
#endif
        for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
            ivec3 voxel = brick * brickSide + voxelInBrick(offset);
            if (!inside(voxel, volumeSize))
                continue;
#ifdef PAGED
            ivec3 texel = atlasTexel(entry, voxel);
#else
            ivec3 texel = voxel;
#endif
            if (!bears(imageLoad(voxels, texel).r))
                continue;
            found[slot] = 1u;
            if (erase)
                imageStore(voxels, texel, uvec4(empty));
        }
    }
}
