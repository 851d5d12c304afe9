// Tests whether a voxel is protected from carving (core/sculpt/SparedLabels.h). The label plane is
// not written at the same time.

layout(binding = 2) uniform usampler3D labelPlane;

uniform bool sparesAny;
uniform uint spared[8]; // one bit per label

bool isSpared(ivec3 voxel)
{
    if (!sparesAny)
        return false;
    uint label = texelFetch(labelPlane, voxel, 0).r;
    return (spared[label >> 5] >> (label & 31u) & 1u) != 0u;
}
