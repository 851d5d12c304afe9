// Shuts voxels to growth in the candidate bricks of a brush, or opens them again (PaintBarrier in
// core/growth/GrowthCommands.h). BENEATH: labels that lie beneath members return to the plane. One
// work-group a brick, each voxel written by one invocation.

layout(local_size_x = 64) in;

#include "edit/bricks.glsl"
#include "edit/capsule.glsl"
#include "edit/seedWord.glsl"

layout(binding = 1) uniform usampler3D pageTable; // of the seed words
layout(binding = 0, r8ui) uniform uimage3D labels;
layout(binding = 1, r32ui) uniform uimage3D words; // atlas
#ifdef BENEATH
layout(binding = 2) uniform usampler3D beneathPages;
layout(binding = 2, r8ui) uniform uimage3D beneath; // atlas
#endif

uniform bool erase;
uniform uint frozen[8]; // one bit a label

const uint changedLabel = 1u;
const uint changedWord = 2u;
const uint changedBeneath = 4u;

bool stays(uint word)
{
    uint label = labelOf(word);
    return (isMember(word) || isPendingSeed(word))
        && (frozen[label >> 5] >> (label & 31u) & 1u) != 0u;
}

bool wasAdded(uint word)
{
    uint direction = word & 31u;
    return isMember(word) && generationOf(word) > 0u && direction != heldDirection
        && direction != heldSeedDirection;
}

void main()
{
    Candidate candidate = candidates[gl_WorkGroupID.x];
    ivec3 origin = brickPosition(candidate.base.w, volumeBricks) * brickSide;
    uint entry = texelFetch(pageTable, origin >> 4, 0).r;
    uint found = 0u;
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
        ivec3 local = voxelInBrick(offset);
        ivec3 voxel = origin + local;
        if (!inside(voxel, volumeSize))
            continue;
        uint unitRadius = uint(radius >> shift);
        if (leastDistance(candidate, local) > unitRadius * unitRadius)
            continue;
        ivec3 texel = atlasTexel(entry, voxel);
        uint word = imageLoad(words, texel).r;
        if ((word == barrierWord) != erase || (!erase && stays(word)))
            continue;
        imageStore(words, texel, uvec4(erase ? unvisited : barrierWord));
        found |= changedWord;
        if (!erase && wasAdded(word) && imageLoad(labels, voxel).r == labelOf(word)) {
            uint below = 0u;
#ifdef BENEATH
            uint beneathEntry = texelFetch(beneathPages, voxel >> 4, 0).r;
            if (beneathEntry != 0u)
                below = imageLoad(beneath, atlasTexel(beneathEntry, voxel)).r;
            if (below != 0u) {
                imageStore(beneath, atlasTexel(beneathEntry, voxel), uvec4(0u));
                found |= changedBeneath;
            }
#endif
            imageStore(labels, voxel, uvec4(below));
            found |= changedLabel;
        }
    }
    if (found != 0u)
        atomicOr(changed[gl_WorkGroupID.x], found);
}
