// Makes pending seeds that meet the criterion members of the next generation. One work-group per
// listed brick.

layout(local_size_x = 64) in;

#include "kernels/criterion/growth.glsl"

layout(binding = 4, std430) readonly buffer Bricks { uint bricks[]; };

uniform uint admittedGeneration;

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
        bool held;
        if (!isPendingSeed(word) || !mayGrow(labelOf(word)) || !accepts(labelOf(word), voxel, held))
            continue;
        uint direction = held ? heldSeedDirection : seedDirection;
        word = memberWord(admittedGeneration, labelOf(word), direction);
        imageStore(words, texel, uvec4(word));
        showLabel(word, voxel);
        reached[entry - 1u] = holdsFront;
        atomicAdd(state.admitted, 1u);
    }
}
