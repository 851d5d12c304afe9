// Declarations that all kernels of a growth burst share: textures, criterion, queue.

#include "fields/bricks/bricks.glsl"
#include "fields/bricks/seedWord.glsl"

layout(binding = 0, r32ui) uniform coherent uimage3D words; // atlas of the seed words
layout(binding = 1, r8ui) uniform uimage3D labels;           // the label plane, dense
layout(binding = 2, r16ui) uniform readonly uimage3D codes;  // intensity codes, dense
// page table of the words, one texel per brick
layout(binding = 3, r32ui) uniform readonly uimage3D pageTable;

// Counters of the running batch; they match GrowthKernel::State in C++.
layout(binding = 0, std430) coherent buffer State {
    // number of voxels in the front from which each ring starts; ring r fills the next
    uint counts[17];
    uint admitted;
    uint nextRing; // where a dispatch of several rings stopped
    uint greatest; // generation of a member (growSweep.comp)
    uint greatestLabel; // greatest label in the front (growFront.comp)
    uint leastLabelDown; // 255 - the least label
} state;
// Two queues, one behind the other: a ring reads one and fills the other. An entry is
// page << 12 | offset in the brick.
layout(binding = 1, std430) coherent buffer Queues { uint queues[]; };
// One word per page of the seed words: what the batch did there.
layout(binding = 3, std430) buffer Reached { uint reached[]; };
const uint heldFront = 1u; // a front passed
const uint holdsFront = 2u; // the front stands there now
// Brick position of every page: x | y << 10 | z << 20.
layout(binding = 5, std430) readonly buffer PageOwners { uint pageOwners[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform uint lowCode;
uniform uint highCode;
uniform uint overwritable[8]; // one bit per label
uniform uint lockedLabels[8]; // one bit per label; labels that do not grow
uniform bool tellsHeld;
uniform uint openGeneration; // members of later generations belong to this burst
uniform uint queueCapacity; // capacity of each queue
uniform uint firstQueue; // 0 or 1: where the front of the batch's first ring lies

// Labels that growth took from other segments are kept (core::Field::Overwritten)
// (core/growth/GrowthCommands.h). Compiled only with its define, so that a growth that takes
// nothing pays nothing for it.
#ifdef OVERWRITTEN
layout(binding = 3) uniform usampler3D overwrittenPages;
layout(binding = 4, r8ui) uniform uimage3D overwritten; // atlas
#endif

// The voxels that the growth may take at all (core::GrowthRange). Compiled only with its define.
#ifdef RANGE
uniform uint closedLabels[8]; // one bit per label
uniform uint rangeLow;
uniform uint rangeHigh;
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

// Whether a label may enter a voxel that holds another one, or none: the limits allow it, and no
// segment keeps the voxel.
bool enters(uint label, uint there, ivec3 voxel)
{
    uint code = imageLoad(codes, voxel).r;
    bool mayEnter = there == 0u || there == label;
    if (!mayEnter)
        mayEnter = (overwritable[there >> 5] >> (there & 31u) & 1u) != 0u;
#ifdef RANGE
    mayEnter = mayEnter && code >= rangeLow && code <= rangeHigh
        && (closedLabels[there >> 5] >> (there & 31u) & 1u) == 0u;
#endif
    return mayEnter && allows(label, voxel, code);
}

// The same for the label that the plane holds there.
// @param held whether the label already holds it; false if that is not known
bool accepts(uint label, ivec3 voxel, out bool held)
{
    uint there = imageLoad(labels, voxel).r;
    held = there == label && tellsHeld;
    return enters(label, there, voxel);
}

// For a member or a doubtful voxel: whether growth wrote its label into the plane.
bool hasAdded(uint word, ivec3 voxel)
{
    uint direction = word & 31u;
    return direction != heldDirection && direction != heldSeedDirection
        && imageLoad(labels, voxel).r == labelOf(word);
}

// The label below a member that growth has added: what the plane held before.
uint labelBelow(ivec3 voxel)
{
#ifdef OVERWRITTEN
    uint entry = texelFetch(overwrittenPages, voxel >> 4, 0).r;
    if (entry != 0u)
        return imageLoad(overwritten, atlasTexel(entry, voxel)).r;
#endif
    return 0u;
}

// As accepts(), for a voxel that may leave, as if its former label had been restored.
bool acceptsMember(uint word, ivec3 voxel)
{
    uint there = imageLoad(labels, voxel).r;
    if (hasAdded(word, voxel))
        there = labelBelow(voxel);
    return enters(labelOf(word), there, voxel);
}

// Restores the former label of a voxel; call it before the voxel leaves.
void giveBack(uint word, ivec3 voxel)
{
    if (!hasAdded(word, voxel))
        return;
    uint below = 0u;
#ifdef OVERWRITTEN
    uint entry = texelFetch(overwrittenPages, voxel >> 4, 0).r;
    if (entry != 0u) {
        below = imageLoad(overwritten, atlasTexel(entry, voxel)).r;
        imageStore(overwritten, atlasTexel(entry, voxel), uvec4(0u));
    }
#endif
    imageStore(labels, voxel, uvec4(below));
}

// Writes the label of a member into the plane. May be called repeatedly, and also for older
// members.
void showLabel(uint word, ivec3 voxel)
{
    uint label = labelOf(word);
#ifdef OVERWRITTEN
    uint there = imageLoad(labels, voxel).r;
    uint entry = texelFetch(overwrittenPages, voxel >> 4, 0).r;
    if (entry != 0u && generationOf(word) > openGeneration && (there != label || !tellsHeld))
        imageStore(overwritten, atlasTexel(entry, voxel), uvec4(tellsHeld ? there : 0u));
#endif
    imageStore(labels, voxel, uvec4(label));
}

// Whether a voxel is marked as doubtful while narrowing: it leaves unless it is proved to qualify.
// Seeds are never marked.
bool isDoubtful(uint word)
{
    return (word & notMember) != 0u && (word & 31u) <= heldDirection;
}

// Whether a member proves that a doubtful neighbour qualifies, provided that the criterion accepts
// it.
bool canProve(uint member, uint word)
{
    return isDoubtful(word) && labelOf(word) == labelOf(member)
        && generationOf(word) > generationOf(member);
}

// Tested where a front begins; voxels that a front claims have its label.
bool mayGrow(uint label)
{
    return (lockedLabels[label >> 5] >> (label & 31u) & 1u) == 0u;
}

// The queue slot of entry i of the front from which a ring of the batch (counted from 0) starts.
uint frontSlot(uint ring, uint i)
{
    return ((firstQueue + ring) & 1u) * queueCapacity + i;
}

// Puts a voxel into the front of the next ring. If a queue is too small the count shows it: the
// next ring then does nothing, and the front is searched again.
void enqueue(uint ring, ivec3 voxel, uint page)
{
    uint i = atomicAdd(state.counts[ring + 1u], 1u);
    if (i < queueCapacity)
        queues[frontSlot(ring + 1u, i)] = page << 12 | uint(offsetInBrick(voxel));
}

// Writes the labels of the front of a ring.
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
