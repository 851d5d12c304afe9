// First part of narrowing a growth (GrowOpening::Narrow in core/growth/GrowthCommands.h): seeds
// that do not meet the criterion become pending again; all other grown voxels become doubtful.
// Voxels that may stay are then found from the others (growFront.comp and growRing.comp with BACK).
// One work-group per listed brick.

layout(local_size_x = 64) in;

#include "kernels/criterion/growth.glsl"

layout(binding = 4, std430) readonly buffer Bricks { uint bricks[]; };

void main()
{
    ivec3 origin = brickPosition(int(bricks[gl_WorkGroupID.x]), volumeBricks) * brickSide;
    uint entry = pageEntry(origin);
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
        ivec3 voxel = origin + voxelInBrick(offset);
        if (!inside(voxel, volumeSize))
            continue;
        ivec3 texel = atlasTexel(entry, voxel);
        uint word = imageLoad(words, texel).r;
        uint label = labelOf(word);
        if (!isMember(word) || generationOf(word) == 0u || !mayGrow(label))
            continue;
        if (!isSeed(word)) {
            imageStore(words, texel, uvec4(word | notMember));
            continue;
        }
        if (acceptsMember(word, voxel))
            continue;
        imageStore(words, texel, uvec4(pendingSeedWord(label)));
        giveBack(word, voxel);
        reached[entry - 1u] = heldFront;
    }
}
