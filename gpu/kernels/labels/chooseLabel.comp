// Gives a label to chosen voxels of listed bricks, or takes it from them, by one of LabelWrites
// (core/sculpt/labels/LayerWrites.h, LabelOutlined.h), by their values (LabelThreshold.h), or by where they
// lie on a view (LabelScissors.h). Tells what changes in each; writes only where it is told to. One
// work-group a brick, each voxel written by one invocation. With EDITABLE it leaves alone what bits do
// not allow (EditableBits.h).

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "fields/bricks/seedWord.glsl"

#ifdef OUTLINED
#define RELABELLED 1 // of some values only
#endif
#ifdef SCISSORS
#include "kernels/cut/hidden.glsl"
#endif
#if defined(SEEN) || defined(OUTLINED) || defined(THRESHOLD) || defined(SCISSORS)
layout(binding = 0) uniform usampler3D codes;
uniform uint lowCode;
uniform uint highCode;
#endif
#if defined(SEEN) || defined(THRESHOLD)
layout(binding = 2) uniform usampler3D radiation; // at voxel centres it says what coverage does
#endif
#ifdef THRESHOLD
layout(binding = 3) uniform sampler3D codeRanges; // macro-cells: least and greatest code
uniform uint how; // LabelThreshold::How
uniform bool onlyVisible;
uniform ivec3 boxFrom;
uniform ivec3 boxTo; // one past the last voxel
#elif defined(SEEN)
layout(binding = 2, std430) readonly buffer Bounds { ivec4 bounds[]; };
uniform uint boundCount;
#elif defined(LISTED) || defined(RELABELLED)
layout(binding = 2, std430) readonly buffer Asked { uint asked[]; }; // four voxels each, by brick
#elif defined(MAPPED)
layout(binding = 2, std430) readonly buffer Becomes { uint becomes[]; }; // by label
#elif defined(SCISSORS)
layout(binding = 2, std430) readonly buffer PlaneBases { ivec4 planeBases[]; }; // mm16, by brick
layout(binding = 3, std430) readonly buffer Reach { int reach[]; }; // mm16, by element of the mask
uniform ivec3 planePerI; // mm16
uniform ivec3 planePerJ;
uniform ivec3 planePerK;
uniform int pitch;
uniform ivec2 maskFirst; // elements
uniform ivec2 maskSize;
uniform bool outside;
uniform bool erases;
uniform uint erased[8]; // one bit per label
#elif defined(CARVED)
layout(binding = 0) uniform usampler3D coverage; // atlas
layout(binding = 2) uniform usampler3D coveragePages;
#else
#error by which rule?
#endif
#ifdef EDITABLE
layout(binding = 7, std430) readonly buffer Editable { uint editable[]; }; // EditableBits.h
#endif
layout(binding = 1) uniform usampler3D pageTable; // of the seed words
layout(binding = 0, r8ui) uniform uimage3D labels;
layout(binding = 1, r32ui) uniform uimage3D words; // atlas
layout(binding = 0, std430) readonly buffer Bricks { uint bricks[]; };
layout(binding = 1, std430) buffer Changed { uint changed[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform uint label;
uniform uint overwritable[8];
#ifdef LISTED
uniform uint frees; // what is asked for where a label is to go; 0: nowhere
#endif
uniform bool write;

const uint changedLabel = 1u;
const uint changedWord = 2u;

#if defined(SEEN) || defined(OUTLINED) || defined(THRESHOLD) || defined(SCISSORS)
bool hasValue(ivec3 voxel)
{
    uint code = texelFetch(codes, voxel, 0).r;
    return code >= lowCode && code <= highCode;
}
#endif

#ifdef THRESHOLD
const uint replaces = 0u;
const uint subtracts = 2u;

// What the macro-cells tell of a brick: codes are read only where it holds some of either kind.
bool holdsChosen = true;
bool holdsOthers = true;

void lookAtCells(ivec3 brick)
{
    uint least = 65535u;
    uint greatest = 0u;
    for (int i = 0; i < 8; ++i) {
        ivec3 cell = 2 * brick + ivec3(i & 1, i >> 1 & 1, i >> 2);
        if (any(greaterThanEqual(cell, textureSize(codeRanges, 0))))
            continue;
        uvec2 range = uvec2(texelFetch(codeRanges, cell, 0).rg * 65535.0 + 0.5);
        least = min(least, range.r);
        greatest = max(greatest, range.g);
    }
    holdsChosen = least <= highCode && greatest >= lowCode;
    holdsOthers = least < lowCode || greatest > highCode;
}

bool isChosen(ivec3 voxel)
{
    return holdsChosen && (!holdsOthers || hasValue(voxel));
}

bool isInRange(ivec3 voxel)
{
    if (any(lessThan(voxel, boxFrom)) || any(greaterThanEqual(voxel, boxTo)))
        return false;
    return !onlyVisible || texelFetch(radiation, voxel, 0).r < 128u;
}
#elif defined(SEEN)
bool isChosen(ivec3 voxel)
{
    if (!hasValue(voxel) || texelFetch(radiation, voxel, 0).r >= 128u)
        return false;
    for (uint i = 0u; i < boundCount; ++i) {
        ivec4 bound = bounds[i];
        if (bound.x * voxel.x + bound.y * voxel.y + bound.z * voxel.z > bound.w)
            return false;
    }
    return true;
}
#elif defined(LISTED) || defined(RELABELLED)
uint askedFor(int offset)
{
    uint four = asked[gl_WorkGroupID.x * 1024u + uint(offset >> 2)];
    return four >> (8 * (offset & 3)) & 255u;
}
#elif defined(SCISSORS)
const uint nobody = 256u; // no label

bool isErased(uint held)
{
    return (erased[held >> 5] >> (held & 31u) & 1u) != 0u;
}

// Rules 1, 3 and 4: `reach` holds which elements are under the curve, and how deep.
bool isReached(ivec3 place)
{
    ivec2 fromCorner = place.xy - maskFirst * pitch;
    if (any(lessThan(fromCorner, ivec2(0))))
        return false;
    ivec2 element = fromCorner / pitch;
    return all(lessThan(element, maskSize))
        && place.z <= reach[element.x + maskSize.x * element.y];
}

bool isChosen(ivec3 voxel)
{
    ivec3 local = voxel & (brickSide - 1);
    ivec3 place = planeBases[gl_WorkGroupID.x].xyz + local.x * planePerI + local.y * planePerJ
        + local.z * planePerK;
    return isReached(place) != outside && hasValue(voxel) && !isHidden(gl_WorkGroupID.x, local);
}
#elif defined(CARVED)
bool isChosen(ivec3 voxel)
{
    uint entry = texelFetch(coveragePages, voxel >> 4, 0).r;
    return entry != 0u && texelFetch(coverage, atlasTexel(entry, voxel), 0).r >= 128u;
}
#endif

/// Whether the edit may change it at all.
bool isEditable(int offset)
{
#ifdef EDITABLE
    uint word = editable[gl_WorkGroupID.x * 128u + uint(offset >> 5)];
    return (word >> uint(offset & 31) & 1u) != 0u;
#else
    return true;
#endif
}

/// 0: nothing is asked for. @param held the label that is there
uint labelFor(ivec3 voxel, int offset, uint held)
{
#ifdef LISTED
    uint its = askedFor(offset);
    if (its == 0u || its != frees)
        return its;
    return (overwritable[held >> 5] >> (held & 31u) & 1u) != 0u ? held : 0u;
#elif defined(OUTLINED)
    return askedFor(offset) != 0u && hasValue(voxel) ? label : 0u;
#elif defined(RELABELLED)
    return askedFor(offset) != 0u ? label : 0u;
#elif defined(MAPPED)
    uint next = becomes[held];
    return next == held ? 0u : next == 0u ? held : next;
#elif defined(THRESHOLD)
    return (how == replaces || isChosen(voxel)) && isInRange(voxel) ? label : 0u;
#elif defined(SCISSORS)
    if (!isChosen(voxel))
        return 0u;
    return erases ? isErased(held) ? held : nobody : label;
#else
    return isChosen(voxel) ? label : 0u;
#endif
}

/// Whether that label is to go from here.
bool isTaken(ivec3 voxel, int offset, uint held)
{
#ifdef LISTED
    return frees != 0u && askedFor(offset) == frees;
#elif defined(RELABELLED)
    return askedFor(offset) == 2u;
#elif defined(THRESHOLD)
    return how == subtracts || (how == replaces && !isChosen(voxel));
#elif defined(MAPPED)
    return becomes[held] == 0u;
#elif defined(SCISSORS)
    return erases;
#else
    return false;
#endif
}

/// Whether a seed word's label is one that is asked for.
bool isOfWanted(uint seedLabel, uint wanted)
{
#ifdef SCISSORS
    if (erases)
        return isErased(seedLabel);
#endif
    return seedLabel == wanted;
}

void main()
{
    ivec3 brick = brickPosition(int(bricks[gl_WorkGroupID.x]), volumeBricks);
    uint entry = texelFetch(pageTable, brick, 0).r;
    uint found = 0u;
#ifdef THRESHOLD
    lookAtCells(brick);
    if (!holdsChosen && how != replaces)
        return;
#endif
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
        ivec3 voxel = brick * brickSide + voxelInBrick(offset);
        if (!inside(voxel, volumeSize) || !isEditable(offset))
            continue;
        uint held = imageLoad(labels, voxel).r;
        uint wanted = labelFor(voxel, offset, held);
        if (wanted == 0u)
            continue;
        bool taken = isTaken(voxel, offset, held);
        if (!taken && held != 0u && held != wanted
            && (overwritable[held >> 5] >> (held & 31u) & 1u) == 0u)
            continue;
        if ((held == wanted) == taken) {
            found |= changedLabel;
            if (write)
                imageStore(labels, voxel, uvec4(taken ? 0u : wanted));
        }
        if (entry == 0u)
            continue;
        ivec3 texel = atlasTexel(entry, voxel);
        uint word = imageLoad(words, texel).r;
        if ((isMember(word) || isPendingSeed(word)) && isOfWanted(labelOf(word), wanted) == taken) {
            found |= changedWord;
            if (write)
                imageStore(words, texel, uvec4(unvisited));
        }
    }
    if (found != 0u)
        atomicOr(changed[gl_WorkGroupID.x], found);
}
