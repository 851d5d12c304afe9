// Finds what the rays of scissors meet first (core/sculpt/labels/LabelScissors.h, rule 4). One invocation
// per ray.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"

layout(binding = 0) uniform usampler3D codes;
layout(binding = 1) uniform usampler3D labels;
layout(binding = 2) uniform sampler3D codeRanges; // macro-cells: least and greatest code
layout(binding = 0, std430) readonly buffer Rays { ivec4 rays[]; };         // index16 at sample 0
layout(binding = 1, std430) writeonly buffer Surfaces { int surfaces[]; };  // mm16
layout(binding = 2, std430) readonly buffer Samples { ivec2 samples[]; };   // first, one past the last
layout(binding = 3, std430) readonly buffer Concerned { uint concerned[]; }; // by brick; 0: no voxel

uniform uint rayCount;
uniform ivec3 stepPerSample; // index16
uniform ivec3 volumeBricks;
uniform int zStart;
uniform int zPerSample;
uniform uint lowCode;
uniform uint highCode;
uniform bool erases;
uniform uint erased[8]; // one bit per label

const int nowhere = 0x7FFFFFFF;

// Whether a voxel of a macro-cell of 8³ may be met. Its least and greatest code may be those of a
// little more than the cell.
bool mayMeet(ivec3 cell)
{
    if (concerned[brickIndex(cell >> 1, volumeBricks)] == 0u)
        return false;
    uvec2 range = uvec2(texelFetch(codeRanges, cell, 0).rg * 65535.0 + 0.5);
    return range.r <= highCode && range.g >= lowCode;
}

// The number of samples from a place on, half a voxel shifted, that lie in its macro-cell.
int samplesInCell(ivec3 shifted)
{
    int count = 0x7FFFF; // of the finest step
    for (int axis = 0; axis < 3; ++axis) {
        int perSample = stepPerSample[axis];
        int within = shifted[axis] & 0x7FFFF;
        if (perSample != 0)
            count = min(count, (perSample > 0 ? 0x7FFFF - within : within) / abs(perSample) + 1);
    }
    return count;
}

bool meets(ivec3 voxel)
{
    uint code = texelFetch(codes, voxel, 0).r;
    if (code < lowCode || code > highCode)
        return false;
    uint held = texelFetch(labels, voxel, 0).r;
    return !erases || (erased[held >> 5] >> (held & 31u) & 1u) != 0u;
}

void main()
{
    uint ray = gl_GlobalInvocationID.x;
    if (ray >= rayCount)
        return;
    int found = nowhere;
    int n = samples[ray].x;
    while (n < samples[ray].y) {
        ivec3 shifted = rays[ray].xyz + n * stepPerSample + (1 << 15);
        if (!mayMeet(shifted >> 19)) {
            n += samplesInCell(shifted);
            continue;
        }
        if (meets(shifted >> 16)) {
            found = zStart + n * zPerSample;
            break;
        }
        ++n;
    }
    surfaces[ray] = found;
}
