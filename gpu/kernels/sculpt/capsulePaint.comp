// Paints or erases a label in the candidate bricks of a brush (PaintLabel in
// core/engine/LabelCommands.h). One work-group per brick; each voxel is written by one invocation.
// With MEMBERS it does so where bits say so, those of the members of a brush that follows edges.
// With EDITABLE it leaves alone what bits do not allow (core/sculpt/labels/EditableVoxels.h).

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "kernels/sculpt/capsule.glsl"
#include "fields/bricks/seedWord.glsl"

layout(binding = 0) uniform usampler3D codes;
layout(binding = 1) uniform usampler3D pageTable; // of the seed words
layout(binding = 0, r8ui) uniform uimage3D labels;
layout(binding = 1, r32ui) uniform uimage3D words; // atlas

uniform uint label;
uniform uint overwritable[8];
uniform bool erase;
uniform bool seeds;
uniform uint lowCode;
uniform uint highCode;

#ifdef EDITABLE
layout(binding = 7, std430) readonly buffer Editable { uint editable[]; }; // EditableBits.h
#endif
#ifdef MEMBERS
layout(binding = 4, std430) readonly buffer Members { uint members[]; };
#endif

const uint changedLabel = 1u;
const uint changedWord = 2u;

bool bearsAny(uint word)
{
    return isMember(word) || isPendingSeed(word);
}

uint paintedWord(uint word)
{
    if (word == barrierWord)
        return word;
    if (seeds)
        return isMember(word) && labelOf(word) == label ? word
                                                        : memberWord(0u, label, seedDirection);
    return bearsAny(word) && labelOf(word) != label ? unvisited : word;
}

uint erasedWord(uint word)
{
    return bearsAny(word) && labelOf(word) == label ? unvisited : word;
}

bool isChosen(Candidate candidate, int offset)
{
#ifdef MEMBERS
    uint word = members[gl_WorkGroupID.x * 128u + uint(offset >> 5)];
    return (word >> uint(offset & 31) & 1u) != 0u;
#else
    return isWithin(candidate, voxelInBrick(offset));
#endif
}

bool isEditable(int offset)
{
#ifdef EDITABLE
    uint word = editable[gl_WorkGroupID.x * 128u + uint(offset >> 5)];
    return (word >> uint(offset & 31) & 1u) != 0u;
#else
    return true;
#endif
}

void main()
{
    Candidate candidate = candidates[gl_WorkGroupID.x];
    ivec3 origin = brickPosition(candidate.base.w, volumeBricks) * brickSide;
    uint entry = texelFetch(pageTable, origin >> 4, 0).r;
    uint found = 0u;
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
        ivec3 voxel = origin + voxelInBrick(offset);
        if (!inside(voxel, volumeSize) || !isChosen(candidate, offset) || !isEditable(offset))
            continue;
        uint code = texelFetch(codes, voxel, 0).r;
        if (code < lowCode || code > highCode)
            continue;
        uint held = imageLoad(labels, voxel).r;
        if (!erase && held != 0u && held != label
            && (overwritable[held >> 5] >> (held & 31u) & 1u) == 0u)
            continue;
        uint wanted = erase ? (held == label ? 0u : held) : label;
        if (wanted != held) {
            imageStore(labels, voxel, uvec4(wanted));
            found |= changedLabel;
        }
        if (entry == 0u)
            continue;
        ivec3 texel = atlasTexel(entry, voxel);
        uint word = imageLoad(words, texel).r;
        uint wantedWord = erase ? erasedWord(word) : paintedWord(word);
        if (wantedWord != word) {
            imageStore(words, texel, uvec4(wantedWord));
            found |= changedWord;
        }
    }
    if (found != 0u)
        atomicOr(changed[gl_WorkGroupID.x], found);
}
