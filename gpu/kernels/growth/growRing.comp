// One generation: every voxel of the front offers itself as parent to its neighbours: those across
// its faces, or as many as CONNECTIVITY says.
//
// The least word wins a voxel (earlier generation, lower label, lower direction), so the result is
// the same on every device. Of all claims on a voxel exactly one finds a word that is no member's;
// that one puts the voxel into the next front.
//
// A voxel is asked for by several neighbours and claimed once, so looking comes first: all their
// words, then the criterion of those that are open, then the claims.
//
// Loops ask at their end: a device without branches (a software renderer) walks a loop once more
// for lanes that are all done when it asks at the start.
//
// BACK: the flood by which a growth that is narrowed finds out who stays. Members prove doubtful
// neighbours of later generations; those go on. It only clears a bit, so the order does not matter.
//
// SEVERAL_RINGS: one work group runs ring after ring while the front is small, since a dispatch
// costs more than such a ring.

layout(local_size_x = 64) in;

#include "kernels/growth/growth.glsl"
#ifdef PASSAGE
#include "kernels/passage/passage.glsl"
#endif

uniform uint baseGeneration; // before the batch
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

// Page entry of a neighbour: the own one, but across a brick's border.
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
    // A word is final one generation after its claim: now the label plane may show it.
    showLabel(own, voxel);
    reached[page] = heldFront;
#endif

    uint open = 0u; // one bit a direction
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
#if defined(BACK) && defined(BENEATH)
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
