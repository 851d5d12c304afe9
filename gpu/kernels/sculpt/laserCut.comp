// Cuts the beams of a laser into candidate bricks (core/sculpt/LaserCut.h, rule 8). One work-group
// per brick; each voxel is written by one invocation.

layout(local_size_x = 64) in;

#include "fields/bricks/bricks.glsl"
#include "kernels/cut/coverageWrite.glsl"
#include "kernels/cut/hidden.glsl"

struct Candidate {
    ivec4 span; // range of its visits: first, one past the last; z: the brick
};
struct Visit {
    ivec4 base; // beam coordinates of the brick's first voxel, mm16; w: the beam
};
struct Beam {
    ivec4 perI; // mm16; w: depth
    ivec4 perJ; // w: where it ends; when restoring, where it begins
    ivec4 perK;
};
layout(binding = 0, std430) readonly buffer Candidates { Candidate candidates[]; };
layout(binding = 1, std430) readonly buffer Visits { Visit visits[]; };
layout(binding = 2, std430) readonly buffer Beams { Beam beams[]; };
layout(binding = 3, std430) readonly buffer Mask { uint mask[]; };
layout(binding = 4, std430) writeonly buffer Changed { uint changed[]; };

uniform ivec3 volumeSize;
uniform ivec3 volumeBricks;
uniform ivec2 maskFirst;
uniform ivec2 maskSize;
uniform int pitch;
uniform int rampHalfWidth;
uniform int lift;
uniform bool restoring;
uniform int beyond; // how far behind the depth a restored voxel may lie

uint ramp(int t)
{
    return uint((clamp(t, -rampHalfWidth, rampHalfWidth) + rampHalfWidth) * 255)
        / uint(2 * rampHalfWidth);
}

int depthUnder(ivec2 place, int depth)
{
    ivec2 fromCorner = place - maskFirst * pitch;
    if (any(lessThan(fromCorner, ivec2(0))))
        return 0;
    ivec2 element = fromCorner / pitch;
    if (any(greaterThanEqual(element, maskSize)))
        return 0;
    int weight = int(mask[element.x + maskSize.x * element.y]);
    // (depth · weight) >> 8 without computing the product
    return (depth >> 8) * weight + (((depth & 255) * weight) >> 8);
}

uint cutAt(Candidate candidate, ivec3 local)
{
    uint cut = 0u;
    for (int i = candidate.span.x; i < candidate.span.y; ++i) {
        ivec4 base = visits[i].base;
        Beam beam = beams[base.w];
        ivec3 p = base.xyz + local.x * beam.perI.xyz + local.y * beam.perJ.xyz
            + local.z * beam.perK.xyz;
        int depth = depthUnder(p.xy, beam.perI.w);
        if (depth <= 0)
            continue;
        cut = max(cut,
            restoring ? min(ramp(beam.perJ.w + depth + beyond - p.z),
                ramp(p.z - beam.perJ.w + (beam.perJ.w == 0 ? lift : 0)))
                      : min(ramp(min(depth, beam.perJ.w) - p.z), ramp(p.z + lift)));
    }
    return cut;
}

void main()
{
    Candidate candidate = candidates[gl_WorkGroupID.x];
    ivec3 origin = brickPosition(candidate.span.z, volumeBricks) * brickSide;
    uint entry = texelFetch(pageTable, origin >> 4, 0).r;
    bool any = false;
    for (int offset = int(gl_LocalInvocationID.x); offset < 4096; offset += 64) {
        ivec3 local = voxelInBrick(offset);
        if (!inside(origin + local, volumeSize))
            continue;
        uint cut = cutAt(candidate, local);
        if (cut == 0u || isHidden(gl_WorkGroupID.x, local))
            continue;
        any = writeCut(entry, origin + local, cut) || any;
    }
    if (any)
        changed[gl_WorkGroupID.x] = 1u;
}
