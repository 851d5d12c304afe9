// Finds which voxels of listed bricks a growth may still claim (FrontBits): voxels that are no
// member and no barrier and meet the criterion. One work-group per brick, or several bricks one
// after the other; one invocation per word.

layout(local_size_x = 128) in;

#include "kernels/criterion/growth.glsl"
#include "kernels/fronts/frontBits.glsl"

layout(binding = 7, std430) restrict writeonly buffer Open { uint open[]; };

uniform uint growing; // the label

void main()
{
    for (uint slot = gl_WorkGroupID.x; slot < groups.x; slot += gl_NumWorkGroups.x) {
        ListedBrick brick = bricks[slot];
        ivec3 origin = positionOf(brick) * brickSide;
        uint word = gl_LocalInvocationID.x;
        uint bits = 0u;
        for (int bit = 0; bit < 32; ++bit) {
            int offset = int(word) * 32 + bit;
            ivec3 voxel = origin + voxelInBrick(offset);
            bool held;
            if (inside(voxel, volumeSize)
                && (imageLoad(words, pageTexel(brick.page, offset)).r & notMember) != 0u
                && accepts(growing, voxel, held))
                bits |= 1u << bit;
        }
        open[brick.index * wordsOfOpen + word] = bits;
    }
}
