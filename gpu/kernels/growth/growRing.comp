// Computes one generation: every voxel of the front offers itself as parent to its neighbours,
// across its faces or as many as CONNECTIVITY says.
//
// The least word wins a voxel (earlier generation, then lower label, then lower direction), so the
// result is the same on every device. Of all claims on a voxel exactly one finds a word that is not
// a member's; that claim puts the voxel into the next front.
//
// A voxel is requested by several neighbours but claimed once, so reading comes first: first all
// words of the neighbours, then the criterion for those that are open, then the claims.
//
// Loops test their condition at the end: a device without branches (a software renderer) executes a
// loop once more for lanes that are all done if the test is at the start.
//
// BACK: the flood by which narrowing finds out which voxels stay. Members prove doubtful neighbours
// of later generations, which continue the flood. It only clears a bit, so the order does not
// matter.
//
// SEVERAL_RINGS: one work-group runs generation after generation while the front is small, since a
// dispatch costs more than such a generation.

layout(local_size_x = 64) in;

#include "kernels/criterion/growth.glsl"
#ifdef PASSAGE
#include "kernels/passage/passage.glsl"
#endif

uniform uint baseGeneration; // generation before the batch
#ifdef SEVERAL_RINGS
uniform uint ringCount;
#ifdef LONG_CRITERION
const uint largestFront = 128u;
#else
const uint largestFront = 1024u;
#endif
#else
uniform uint ring;
#endif

// The page table entry of a neighbour: the voxel's own, unless the neighbour lies in another brick.
uint neighbourEntry(uint ownEntry, ivec3 neighbour, ivec3 origin)
{
    uint entry = ownEntry;
    if ((neighbour >> 4) != (origin >> 4))
        entry = inside(neighbour, volumeSize) ? pageEntry(neighbour) : 0u;
    return entry;
}

#ifdef BACK
uint wordAt(uint ownEntry, ivec3 neighbour, ivec3 origin)
{
    return imageLoad(words, atlasTexel(neighbourEntry(ownEntry, neighbour, origin), neighbour)).r;
}
#endif

void growFrom(uint entry, uint ring)
{
    uint generation = baseGeneration + ring + 1u;
    uint page = entry >> 12;
    int offset = int(entry & 4095u);
    ivec3 origin = ownerOrigin(page);
    ivec3 voxel = origin + voxelInBrick(offset);
    uint own = imageLoad(words, pageTexel(page, offset)).r;
    uint label = labelOf(own);
#ifndef BACK
    // A word is final one generation after its claim, so the label plane may be written now.
    showLabel(own, voxel);
    reached[page] = heldFront;
#endif

    uint open = 0u; // one bit per direction
    for (uint direction = 0u; direction < uint(CONNECTIVITY); ++direction) {
        ivec3 neighbour = voxel + neighbourOffsets[direction];
        uint there = neighbourEntry(page + 1u, neighbour, origin);
        uint word = imageLoad(words, atlasTexel(there, neighbour)).r;
#ifdef BACK
        bool wanted = canProve(own, word);
#else
        bool wanted = word > memberWord(generation, label, direction);
#endif
        if (there != 0u && wanted)
            open |= 1u << direction;
    }
    Parent parent = Parent(0u, 0u);
    if (open != 0u)
        parent = parentAt(voxel);
#ifdef PASSAGE
    uint room = noRoom;
    if (open != 0u)
        room = roomAt(label, voxel);
    if (room == noRoom)
        open = 0u; // nothing passes
#endif
    if (open != 0u) do {
        uint direction = uint(findLSB(open));
        open &= open - 1u;
#if CONNECTIVITY == 6
        ivec3 step = ivec3(0);
        step[direction >> 1] = 1 - 2 * int(direction & 1u);
#else
        ivec3 step = neighbourOffsets[direction];
#endif
        ivec3 neighbour = voxel + step;
        bool held = false;
        // A brick at the rim reaches beyond the volume.
        if (inside(neighbour, volumeSize)
#if defined(BACK) && (defined(OVERWRITTEN) || defined(RANGE))
            && acceptsMember(wordAt(page + 1u, neighbour, origin), neighbour)
#else
            && accepts(label, neighbour, held)
#endif
            && follows(parent, neighbour)
#ifdef PASSAGE
            && passes(room, roomAt(label, neighbour))
#endif
        ) {
            uint there = neighbourEntry(page + 1u, neighbour, origin);
#ifdef BACK
            uint before = imageAtomicAnd(words, atlasTexel(there, neighbour), ~notMember);
#else
            uint claim = memberWord(generation, label, held ? heldDirection : direction);
            uint before = imageAtomicMin(words, atlasTexel(there, neighbour), claim);
#endif
            if (!isMember(before))
                enqueue(ring, neighbour, there - 1u);
        }
    } while (open != 0u);
}

#ifdef SEVERAL_RINGS

void main()
{
    uint ring = 0u;
    for (; ring < ringCount; ++ring) {
        uint count = state.counts[ring];
        if (count == 0u || count > min(largestFront, queueCapacity))
            break;
        uint i = gl_LocalInvocationID.x;
        if (i < count) do {
            growFrom(queues[frontSlot(ring, i)], ring);
            i += gl_WorkGroupSize.x;
        } while (i < count);
        memoryBarrier();
        barrier();
    }
    if (state.counts[ring] == 0u)
        ring = ringCount; // at closure: nothing is left to do
#ifndef BACK
    if (ring == ringCount)
        showFront(ring, gl_LocalInvocationID.x, gl_WorkGroupSize.x);
#endif
    if (gl_LocalInvocationID.x == 0u)
        state.nextRing = ring;
}

#else

void main()
{
    uint count = state.counts[ring];
    if (count > queueCapacity)
        return;
    uint stride = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    uint i = gl_GlobalInvocationID.x;
    if (i < count) do {
        growFrom(queues[frontSlot(ring, i)], ring);
        i += stride;
    } while (i < count);
}

#endif
