// Takes back what a growth added after a generation, in listed bricks (ShrinkGrowth in
// core/engine/EngineCommands.h). Tells which of them lose something; writes only where told to.

layout(local_size_x = 64) in;

#include "edit/bricks.glsl"
#include "edit/seedWord.glsl"

layout(binding = 1) uniform usampler3D pageTable;
layout(binding = 0, r32ui) uniform uimage3D words; // atlas
layout(binding = 1, r8ui) uniform uimage3D labels;
layout(binding = 0, std430) readonly buffer Bricks { uint bricks[]; };
layout(binding = 1, std430) buffer Found {
    uint greatest; // generation of a member that stays
    uint flags[]; // one a brick
} found;
const uint losesWords = 1u;
const uint losesLabels = 2u;

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform uint brickCount;
uniform bool write;
uniform uint keep;
uniform bool keepSeeds;
uniform uint frozen[8]; // one bit a label

void main()
{
    for (uint slot = gl_WorkGroupID.x; slot < brickCount; slot += gl_NumWorkGroups.x) {
        ivec3 brick = brickPosition(int(bricks[slot]), volumeBricks);
        uint entry = texelFetch(pageTable, brick, 0).r;
        uint flags = 0u;
        uint greatest = 0u;
        for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
            ivec3 voxel = brick * brickSide + voxelInBrick(offset);
            if (!inside(voxel, volumeSize))
                continue;
            ivec3 texel = atlasTexel(entry, voxel);
            uint word = imageLoad(words, texel).r;
            if (!isMember(word))
                continue;
            uint label = labelOf(word);
            bool stays = generationOf(word) <= keep
                || (frozen[label >> 5] >> (label & 31u) & 1u) != 0u;
            bool seedStays = !stays && keepSeeds && isSeed(word);
            uint after = seedStays ? memberWord(1u, label, word & 31u)
                : isSeed(word)     ? pendingSeedWord(label)
                                   : unvisited;
            after = stays ? word : after;
            greatest = max(greatest, isMember(after) ? generationOf(after) : 0u);
            if (after == word)
                continue;
            flags |= losesWords;
            bool wasHeld = (word & 31u) == heldDirection || (word & 31u) == heldSeedDirection;
            bool loses = !seedStays && !wasHeld && imageLoad(labels, voxel).r == label;
            if (loses)
                flags |= losesLabels;
            if (write) {
                imageStore(words, texel, uvec4(after));
                if (loses)
                    imageStore(labels, voxel, uvec4(0u));
            }
        }
        if (flags != 0u)
            atomicOr(found.flags[slot], flags);
        if (greatest != 0u)
            atomicMax(found.greatest, greatest);
    }
}
