// What is not carved (core/sculpt/SparedLabels.h). The label plane is not written meanwhile.

layout(binding = 2) uniform usampler3D labelPlane;

uniform bool sparesAny;
uniform uint spared[8]; // a bit for each label

bool isSpared(ivec3 voxel)
{
    if (!sparesAny)
        return false;
    uint label = texelFetch(labelPlane, voxel, 0).r;
    return (spared[label >> 5] >> (label & 31u) & 1u) != 0u;
}
