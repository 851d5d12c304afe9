// Tests whether growth may pass from a voxel to its neighbour (core/growth/Passage.h). Include this
// file after growth.glsl.

#include "kernels/passage/passageSlots.glsl"

layout(binding = 1) uniform usampler3D rooms; // atlas: room | entry << 16
uniform uint slotOfLabel[64]; // four labels a word

const uint nowhere = 0xFFFFu;
const uint noRoom = 0xFFFFFFFFu;

uint roomAt(uint label, ivec3 voxel)
{
    uint slot = slotOfLabel[label >> 2] >> ((label & 3u) * 8u) & 0xFFu;
    uint entry = texelFetch(roomPages, slotBrick(voxel >> 4, slot), 0).r;
    return entry != 0u ? texelFetch(rooms, atlasTexel(entry, voxel), 0).r : noRoom;
}

// @param from, to rooms of parent and child
bool passes(uint from, uint to)
{
    uint room = to & 0xFFFFu;
    if (room == nowhere)
        return false;
    uint before = from & 0xFFFFu;
    uint entryBefore = from >> 16;
    uint entry = to >> 16;
    return before < room || (before | room) == 0u
        || (entryBefore != nowhere && entry < entryBefore && (room != 0u || entry == 0u));
}
