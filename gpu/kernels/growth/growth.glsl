// What the kernels of a growth burst share: the textures, the criterion, the queue.

#include "fields/bricks/bricks.glsl"
#include "fields/bricks/seedWord.glsl"

layout(binding = 0, r32ui) uniform coherent uimage3D words; // atlas of the seed words
layout(binding = 1, r8ui) uniform uimage3D labels;           // the label plane, dense
layout(binding = 2, r16ui) uniform readonly uimage3D codes;  // intensity codes, dense
layout(binding = 3, r32ui) uniform readonly uimage3D pageTable; // of the words, one texel a brick

// Counters of the running batch; GrowthKernel::State in C++.
layout(binding = 0, std430) coherent buffer State {
    uint counts[17]; // voxels in the front that each ring starts from; ring r fills the next
    uint admitted;
    uint nextRing; // where a dispatch of several rings stopped
    uint greatest; // generation of a member (growSweep.comp)
    uint greatestLabel; // in the front (growFront.comp)
    uint leastLabelDown; // 255 - the least
} state;
// Two queues, one behind the other: a ring reads one and fills the other. An entry is
// page << 12 | offset in the brick.
layout(binding = 1, std430) coherent buffer Queues { uint queues[]; };
// One word a page of the seed words: what the batch did there.
layout(binding = 3, std430) buffer Reached { uint reached[]; };
const uint heldFront = 1u; // a front passed
const uint holdsFront = 2u; // the front stands there now
// Brick position of every page: x | y << 10 | z << 20.
layout(binding = 5, std430) readonly buffer PageOwners { uint pageOwners[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform uint lowCode;
uniform uint highCode;
uniform uint overwritable[8]; // one bit a label
uniform uint frozen[8]; // likewise: labels that do not grow
uniform bool tellsHeld;
uniform uint openGeneration; // members of later generations are this burst's
uniform uint queueCapacity; // of each
uniform uint firstQueue; // 0 or 1: where the front of the batch's first ring lies

// What lies beneath members (core/growth/GrowthCommands.h). Only there where its define is: a growth
// that takes nothing from other labels pays nothing for it.
#ifdef BENEATH
layout(binding = 3) uniform usampler3D beneathPages;
layout(binding = 4, r8ui) uniform uimage3D beneath; // atlas
#endif

#include "kernels/criterion/growCriterion.glsl"

uint pageEntry(ivec3 voxel)
{
    return imageLoad(pageTable, voxel >> 4).r;
}

ivec3 ownerOrigin(uint page)
{
    uint owner = pageOwners[page];
    return ivec3(owner & 1023u, owner >> 10 & 1023u, owner >> 20) * brickSide;
}

// Whether a label may enter a voxel: the limits allow it and no other segment holds it.
// @param held whether the label holds it already; false where that is not told
bool accepts(uint label, ivec3 voxel, out bool held)
{
    uint code = imageLoad(codes, voxel).r;
    uint there = imageLoad(labels, voxel).r;
    bool own = there == label;
    held = own && tellsHeld;
    bool mayEnter = there == 0u || own;
    if (!mayEnter)
        mayEnter = (overwritable[there >> 5] >> (there & 31u) & 1u) != 0u;
    return mayEnter && allows(label, voxel, code);
}

// Of a member, or of one that is doubtful: whether it added its label to the plane.
bool hasAdded(uint word, ivec3 voxel)
{
    uint direction = word & 31u;
    return direction != heldDirection && direction != heldSeedDirection
        && imageLoad(labels, voxel).r == labelOf(word);
}

// The same as accepts(), of one that may leave, as if it had been given back.
bool acceptsMember(uint word, ivec3 voxel)
{
    bool held;
#ifdef BENEATH
    uint entry = texelFetch(beneathPages, voxel >> 4, 0).r;
    if (entry != 0u && hasAdded(word, voxel)) {
        uint below = imageLoad(beneath, atlasTexel(entry, voxel)).r;
        if (below != 0u && below != labelOf(word)
            && (overwritable[below >> 5] >> (below & 31u) & 1u) == 0u)
            return false;
    }
#endif
    return accepts(labelOf(word), voxel, held);
}

// Before it leaves.
void giveBack(uint word, ivec3 voxel)
{
    if (!hasAdded(word, voxel))
        return;
    uint below = 0u;
#ifdef BENEATH
    uint entry = texelFetch(beneathPages, voxel >> 4, 0).r;
    if (entry != 0u) {
        below = imageLoad(beneath, atlasTexel(entry, voxel)).r;
        imageStore(beneath, atlasTexel(entry, voxel), uvec4(0u));
    }
#endif
    imageStore(labels, voxel, uvec4(below));
}

// A member shows in the plane. To be said of it as often as one likes, and of those of before too.
void showLabel(uint word, ivec3 voxel)
{
    uint label = labelOf(word);
#ifdef BENEATH
    uint there = imageLoad(labels, voxel).r;
    uint entry = texelFetch(beneathPages, voxel >> 4, 0).r;
    if (entry != 0u && generationOf(word) > openGeneration && (there != label || !tellsHeld))
        imageStore(beneath, atlasTexel(entry, voxel), uvec4(tellsHeld ? there : 0u));
#endif
    imageStore(labels, voxel, uvec4(label));
}

// Marked while a growth is narrowed: leaves unless it proves to qualify. No seed is.
bool isDoubtful(uint word)
{
    return (word & notMember) != 0u && (word & 31u) <= heldDirection;
}

// Whether a member proves that a doubtful neighbour qualifies, if that one is accepted.
bool canProve(uint member, uint word)
{
    return isDoubtful(word) && labelOf(word) == labelOf(member)
        && generationOf(word) > generationOf(member);
}

// Asked where a front begins; those whom a front claims have its label.
bool mayGrow(uint label)
{
    return (frozen[label >> 5] >> (label & 31u) & 1u) == 0u;
}

// Entry i of the front that a ring of the batch (from 0) starts from.
uint frontSlot(uint ring, uint i)
{
    return ((firstQueue + ring) & 1u) * queueCapacity + i;
}

// Puts a voxel into the front of the next ring. A queue that is too small shows in the count: the
// ring after this one does nothing then, and the front is found again.
void enqueue(uint ring, ivec3 voxel, uint page)
{
    uint i = atomicAdd(state.counts[ring + 1u], 1u);
    if (i < queueCapacity)
        queues[frontSlot(ring + 1u, i)] = page << 12 | uint(offsetInBrick(voxel));
}

// The front of a ring shows its labels.
void showFront(uint ring, uint first, uint stride)
{
    uint count = min(state.counts[ring], queueCapacity);
    uint i = first;
    if (i < count) do {
        uint entry = queues[frontSlot(ring, i)];
        uint page = entry >> 12;
        int offset = int(entry & 4095u);
        uint word = imageLoad(words, pageTexel(page, offset)).r;
        showLabel(word, ownerOrigin(page) + voxelInBrick(offset));
        reached[page] = holdsFront;
        i += stride;
    } while (i < count);
}
