// Tri-cubic interpolation: Catmull-Rom along each axis in turn, through the values of the voxels.
// All 64 voxels are fetched and weighted here, because filtering hardware rounds its weights to 8
// bits. Beyond the border the outermost voxels are repeated.

/// The weights of the values at −1, 0, 1 and 2.
vec4 cubicWeights(float part)
{
    const float square = part * part;
    const float cube = square * part;
    return 0.5
        * vec4(-part + 2.0 * square - cube, 2.0 - 5.0 * square + 3.0 * cube,
            part + 4.0 * square - 3.0 * cube, cube - square);
}

/// @param place in index space
float cubicAt(sampler3D field, vec3 place)
{
    const ivec3 last = textureSize(field, 0) - 1;
    const vec3 at = clamp(place, vec3(-2.0), vec3(last) + 2.0);
    const vec3 base = floor(at);
    const vec3 part = at - base;
    const vec4 alongX = cubicWeights(part.x);
    const vec4 alongY = cubicWeights(part.y);
    const vec4 alongZ = cubicWeights(part.z);
    const ivec4 offsets = ivec4(-1, 0, 1, 2);
    const ivec4 x = clamp(int(base.x) + offsets, ivec4(0), ivec4(last.x));
    const ivec4 y = clamp(int(base.y) + offsets, ivec4(0), ivec4(last.y));
    const ivec4 z = clamp(int(base.z) + offsets, ivec4(0), ivec4(last.z));
    float sum = 0.0;
    for (int k = 0; k < 4; ++k) {
        for (int j = 0; j < 4; ++j) {
            const vec4 row = vec4(texelFetch(field, ivec3(x.x, y[j], z[k]), 0).r,
                texelFetch(field, ivec3(x.y, y[j], z[k]), 0).r,
                texelFetch(field, ivec3(x.z, y[j], z[k]), 0).r,
                texelFetch(field, ivec3(x.w, y[j], z[k]), 0).r);
            sum += alongZ[k] * alongY[j] * dot(alongX, row);
        }
    }
    return sum;
}
