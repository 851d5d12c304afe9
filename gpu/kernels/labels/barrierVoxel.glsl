// A voxel is shut to growth, or opened again, by the rules of PaintBarrier
// (core/growth/GrowthCommands.h). OVERWRITTEN: labels that members have overwritten return to the
// plane. Before it: fields/bricks/bricks.glsl, fields/bricks/seedWord.glsl.

layout(binding = 1) uniform usampler3D pageTable; // of the seed words
layout(binding = 0, r8ui) uniform uimage3D labels;
layout(binding = 1, r32ui) uniform uimage3D words; // atlas
#ifdef OVERWRITTEN
layout(binding = 2) uniform usampler3D overwrittenPages;
layout(binding = 2, r8ui) uniform uimage3D overwritten; // atlas
#endif

uniform bool erase;
uniform uint lockedLabels[8]; // one bit a label

const uint changedLabel = 1u;
const uint changedWord = 2u;
const uint changedOverwritten = 4u;

bool stays(uint word)
{
    uint label = labelOf(word);
    return (isMember(word) || isPendingSeed(word))
        && (lockedLabels[label >> 5] >> (label & 31u) & 1u) != 0u;
}

bool wasAdded(uint word)
{
    uint direction = word & 31u;
    return isMember(word) && generationOf(word) > 0u && direction != heldDirection
        && direction != heldSeedDirection;
}

/// What changed. `entry`: of the voxel's brick in the page table.
uint setOrClearBarrier(ivec3 voxel, uint entry)
{
    ivec3 texel = atlasTexel(entry, voxel);
    uint word = imageLoad(words, texel).r;
    if ((word == barrierWord) != erase || (!erase && stays(word)))
        return 0u;
    imageStore(words, texel, uvec4(erase ? unvisited : barrierWord));
    uint found = changedWord;
    if (!erase && wasAdded(word) && imageLoad(labels, voxel).r == labelOf(word)) {
        uint below = 0u;
#ifdef OVERWRITTEN
        uint overwrittenEntry = texelFetch(overwrittenPages, voxel >> 4, 0).r;
        if (overwrittenEntry != 0u)
            below = imageLoad(overwritten, atlasTexel(overwrittenEntry, voxel)).r;
        if (below != 0u) {
            imageStore(overwritten, atlasTexel(overwrittenEntry, voxel), uvec4(0u));
            found |= changedOverwritten;
        }
#endif
        imageStore(labels, voxel, uvec4(below));
        found |= changedLabel;
    }
    return found;
}
