// The label that the plane would hold if a segment grew from its seeds to a tolerance
// (core/growth/Tolerance.h): the members at that tolerance, without present members that a growth
// has added.
#include "kernels/labels/memberWords.glsl"

layout(binding = 13) uniform usampler3D tolerances;
uniform uint toleranceLabel;
uniform uint tolerance;

uint labelAtTolerance(uint held, ivec3 voxel)
{
    if (texelFetch(tolerances, voxel, 0).r <= tolerance)
        return toleranceLabel;
    if (held != toleranceLabel)
        return held;
    uint word = wordAt(voxel);
    uint direction = word & 31u;
    bool grown = isMember(word) && labelOf(word) == held && generationOf(word) > 0u
        && direction != heldDirection && direction != heldSeedDirection;
    return grown ? 0u : held;
}
