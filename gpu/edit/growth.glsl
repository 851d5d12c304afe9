// What the kernels of a growth burst share: the textures, the criterion, the queue.

#include "edit/bricks.glsl"
#include "edit/seedWord.glsl"

layout(binding = 0) uniform usampler3D codes;         // intensity codes, dense
layout(binding = 1) uniform usampler3D pageTable;     // of the seed words, one texel a brick
layout(binding = 0, r32ui) uniform coherent uimage3D words; // atlas of the seed words
layout(binding = 1, r8ui) uniform uimage3D labels;    // the label plane, dense

// Counters of the running batch; GrowthKernel::State in C++.
layout(binding = 0, std430) coherent buffer State {
    uint dispatchX, dispatchY, dispatchZ; // indirect arguments of the next ring
    uint frontCount;
    uint nextCount;
    uint generation;
    uint overflow; // the queue was too small: the batch stops and the front is found again
    uint ringsDone;
    uint ringSizes[16];
} state;
layout(binding = 1, std430) buffer Front { uint front[]; };
layout(binding = 2, std430) buffer Next { uint next[]; };
// One bit a brick: something was claimed in it during this batch.
layout(binding = 3, std430) coherent buffer Touched { uint touched[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform uint lowCode;
uniform uint highCode;
uniform uint overwritable[8]; // one bit a label
uniform uint queueCapacity;

uint pageEntry(ivec3 voxel)
{
    return texelFetch(pageTable, voxel >> 4, 0).r;
}

uint linearIndex(ivec3 voxel)
{
    return uint(voxel.x) + uint(volumeSize.x) * (uint(voxel.y) + uint(volumeSize.y) * uint(voxel.z));
}

ivec3 voxelAt(uint index)
{
    uint row = index / uint(volumeSize.x);
    return ivec3(index % uint(volumeSize.x), row % uint(volumeSize.y), row / uint(volumeSize.y));
}

// Whether a label may enter a voxel: its code is in the interval and no other segment holds it.
bool accepts(uint label, ivec3 voxel)
{
    uint code = texelFetch(codes, voxel, 0).r;
    if (code < lowCode || code > highCode)
        return false;
    uint there = imageLoad(labels, voxel).r;
    return there == 0u || there == label || (overwritable[there >> 5] >> (there & 31u) & 1u) != 0u;
}

void markTouched(ivec3 voxel)
{
    uint brick = uint(brickIndex(voxel >> 4, volumeBricks));
    uint bit = 1u << (brick & 31u);
    if ((touched[brick >> 5] & bit) == 0u)
        atomicOr(touched[brick >> 5], bit);
}

void enqueue(ivec3 voxel)
{
    uint slot = atomicAdd(state.nextCount, 1u);
    if (slot < queueCapacity)
        next[slot] = linearIndex(voxel);
    else
        state.overflow = 1u;
}
