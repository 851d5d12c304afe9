// Takes back what a growth added after a generation, in listed bricks (ShrinkGrowth in
// core/growth/GrowthCommands.h), or restores it.
//
// LOOK: only reports for each brick which generations it holds that may be removed. OVERWRITTEN:
// labels that members overwrote return to the plane. Otherwise the new content of a brick is
// computed from its saved content, so it can be repeated for other generations.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "fields/bricks/seedWord.glsl"

layout(binding = 0, std430) readonly buffer Bricks { uint bricks[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform uint brickCount;
uniform uint lockedLabels[8]; // one bit per label

bool mayGo(uint label)
{
    return (lockedLabels[label >> 5] >> (label & 31u) & 1u) == 0u;
}

#ifdef LOOK

layout(binding = 0) uniform usampler3D words; // atlas
layout(binding = 1) uniform usampler3D pageTable;
layout(binding = 1, std430) buffer Found {
    uint greatestLocked; // greatest generation of a member that may not be removed
    uint seeds; // 1: there are seeds that may be removed, apart from painted ones
    uint ranges[]; // two per brick, for what may be removed: ~least generation above 0, greatest
} found;

void main()
{
    for (uint slot = gl_WorkGroupID.x; slot < brickCount; slot += gl_NumWorkGroups.x) {
        ivec3 brick = brickPosition(int(bricks[slot]), volumeBricks);
        uint entry = texelFetch(pageTable, brick, 0).r;
        uint least = unvisited;
        uint greatest = 0u;
        uint greatestLocked = 0u;
        bool seeds = false;
        for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
            ivec3 voxel = brick * brickSide + voxelInBrick(offset);
            uint word = texelFetch(words, atlasTexel(entry, voxel), 0).r;
            uint generation = isMember(word) ? generationOf(word) : 0u;
            if (generation == 0u || !inside(voxel, volumeSize))
                continue;
            bool goes = mayGo(labelOf(word));
            least = goes ? min(least, generation) : least;
            greatest = goes ? max(greatest, generation) : greatest;
            greatestLocked = goes ? greatestLocked : max(greatestLocked, generation);
            seeds = seeds || (goes && isSeed(word));
        }
        if (greatest != 0u) {
            atomicMax(found.ranges[2u * slot], ~least);
            atomicMax(found.ranges[2u * slot + 1u], greatest);
        }
        if (greatestLocked != 0u)
            atomicMax(found.greatestLocked, greatestLocked);
        if (seeds)
            atomicOr(found.seeds, 1u);
    }
}

#else

layout(binding = 1) uniform usampler3D pageTable;
layout(binding = 0, r32ui) uniform writeonly uimage3D words; // atlas
layout(binding = 1, r8ui) uniform writeonly uimage3D labels;
// place of each brick in the saved lists
layout(binding = 1, std430) readonly buffer Places { uint places[]; };
layout(binding = 2, std430) readonly buffer SavedWords { uint savedWords[]; };
layout(binding = 3, std430) readonly buffer SavedLabels { uint savedLabels[]; }; // four to a word
#ifdef OVERWRITTEN
layout(binding = 4, std430) readonly buffer SavedOverwritten { uint savedOverwritten[]; }; // likewise
layout(binding = 2) uniform usampler3D overwrittenPages;
layout(binding = 2, r8ui) uniform writeonly uimage3D overwritten; // atlas
#endif

uniform uint keep;
uniform bool keepSeeds;

void main()
{
    for (uint slot = gl_WorkGroupID.x; slot < brickCount; slot += gl_NumWorkGroups.x) {
        ivec3 brick = brickPosition(int(bricks[slot]), volumeBricks);
        uint entry = texelFetch(pageTable, brick, 0).r;
        uint place = places[slot];
#ifdef OVERWRITTEN
        uint overwrittenEntry = texelFetch(overwrittenPages, brick, 0).r;
#endif
        for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
            ivec3 voxel = brick * brickSide + voxelInBrick(offset);
            if (!inside(voxel, volumeSize))
                continue;
            uint word = savedWords[place * 4096u + uint(offset)];
            uint four = savedLabels[place * 1024u + uint(offset >> 2)];
            uint held = four >> (8 * (offset & 3)) & 255u;
            uint label = labelOf(word);
            bool stays = !isMember(word) || generationOf(word) <= keep || !mayGo(label);
            bool seedStays = !stays && keepSeeds && isSeed(word);
            uint after = seedStays ? memberWord(1u, label, word & 31u)
                : isSeed(word)     ? pendingSeedWord(label)
                                   : unvisited;
            bool wasHeld = (word & 31u) == heldDirection || (word & 31u) == heldSeedDirection;
            bool loses = !stays && !seedStays && !wasHeld && held == label;
            imageStore(words, atlasTexel(entry, voxel), uvec4(stays ? word : after));
            uint below = 0u;
#ifdef OVERWRITTEN
            below = savedOverwritten[place * 1024u + uint(offset >> 2)] >> (8 * (offset & 3)) & 255u;
            if (overwrittenEntry != 0u)
                imageStore(overwritten, atlasTexel(overwrittenEntry, voxel), uvec4(loses ? 0u : below));
#endif
            imageStore(labels, voxel, uvec4(loses ? below : held));
        }
    }
}

#endif
