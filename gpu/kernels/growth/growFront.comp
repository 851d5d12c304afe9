// Finds the front of a growth: every member with a neighbour (CONNECTIVITY) that it could claim.
// With BACK, while narrowing: every member with a neighbour that it could prove to qualify. One
// work-group per listed brick. The order in the queue depends on scheduling and decides nothing.

#include "kernels/criterion/growth.glsl"

#ifdef LONG_CRITERION
layout(local_size_x = 256) in;
#else
layout(local_size_x = 64) in;
#endif

layout(binding = 4, std430) readonly buffer Bricks { uint bricks[]; };

bool canGoOn(ivec3 voxel, uint own)
{
    uint label = labelOf(own);
    Parent parent = parentAt(voxel);
    for (int direction = 0; direction < CONNECTIVITY; ++direction) {
        ivec3 neighbour = voxel + neighbourOffsets[direction];
        if (!inside(neighbour, volumeSize))
            continue;
        uint entry = pageEntry(neighbour);
        uint word = entry != 0u ? imageLoad(words, atlasTexel(entry, neighbour)).r : unvisited;
#ifdef BACK
        if (canProve(own, word) && acceptsMember(word, neighbour) && follows(parent, neighbour))
            return true;
#else
        bool held;
        if (!isMember(word) && word != barrierWord && accepts(label, neighbour, held)
            && follows(parent, neighbour))
            return true;
#endif
    }
    return false;
}

void main()
{
    ivec3 origin = brickPosition(int(bricks[gl_WorkGroupID.x]), volumeBricks) * brickSide;
    uint entry = pageEntry(origin);
    uint greatestLabel = 0u;
    uint leastLabelDown = 0u;
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += int(gl_WorkGroupSize.x)) {
        ivec3 voxel = origin + voxelInBrick(offset);
        if (!inside(voxel, volumeSize))
            continue;
        uint word = imageLoad(words, atlasTexel(entry, voxel)).r;
        if (!isMember(word))
            continue;
#ifndef BACK
        if (generationOf(word) > openGeneration)
            showLabel(word, voxel);
#endif
        if (!mayGrow(labelOf(word)) || !canGoOn(voxel, word))
            continue;
        enqueue(0u, voxel, entry - 1u);
        greatestLabel = max(greatestLabel, labelOf(word));
        leastLabelDown = max(leastLabelDown, 255u - labelOf(word));
#ifndef BACK
        reached[entry - 1u] = holdsFront;
#endif
    }
    if (greatestLabel != 0u) {
        atomicMax(state.greatestLabel, greatestLabel);
        atomicMax(state.leastLabelDown, leastLabelDown);
    }
}
