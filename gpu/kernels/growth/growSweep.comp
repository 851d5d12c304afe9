// Last part of narrowing a growth: voxels that are still doubtful are removed; grown voxels that
// stay get their parent direction again. Reports the greatest generation of a member. One
// work-group per listed brick.

layout(local_size_x = 64) in;

#include "kernels/criterion/growth.glsl"

layout(binding = 4, std430) readonly buffer Bricks { uint bricks[]; };

// The lowest direction that leads from an earlier member; there always is one. Concurrent writes of
// other invocations neither make a member nor change a generation.
uint directionOf(uint word, ivec3 voxel)
{
    uint label = labelOf(word);
    for (uint direction = 0u; direction < uint(CONNECTIVITY); ++direction) {
        ivec3 parent = voxel - neighbourOffsets[direction];
        if (!inside(parent, volumeSize))
            continue;
        uint entry = pageEntry(parent);
        if (entry == 0u)
            continue;
        uint there = imageLoad(words, atlasTexel(entry, parent)).r;
        if (isMember(there) && labelOf(there) == label && generationOf(there) < generationOf(word)
            && acceptsMember(word, voxel) && follows(parentAt(parent), voxel))
            return direction;
    }
    return word & 31u;
}

void main()
{
    ivec3 origin = brickPosition(int(bricks[gl_WorkGroupID.x]), volumeBricks) * brickSide;
    uint entry = pageEntry(origin);
    uint greatest = 0u;
    bool changed = false;
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
        ivec3 voxel = origin + voxelInBrick(offset);
        if (!inside(voxel, volumeSize))
            continue;
        ivec3 texel = atlasTexel(entry, voxel);
        uint word = imageLoad(words, texel).r;
        uint label = labelOf(word);
        if (isDoubtful(word)) {
            imageStore(words, texel, uvec4(unvisited));
            giveBack(word, voxel);
            changed = true;
            continue;
        }
        if (!isMember(word))
            continue;
        greatest = max(greatest, generationOf(word));
        if (generationOf(word) == 0u || (word & 31u) >= heldDirection || !mayGrow(label))
            continue;
        uint direction = directionOf(word, voxel);
        if (direction == (word & 31u))
            continue;
        imageStore(words, texel, uvec4(memberWord(generationOf(word), label, direction)));
        changed = true;
    }
    if (changed)
        reached[entry - 1u] = heldFront;
    if (greatest != 0u)
        atomicMax(state.greatest, greatest);
}
