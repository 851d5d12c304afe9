// Converts the sums of sparse points to bytes: radiation and label (core/sculpt/radiation/SparseRadiation.h).

layout(local_size_x = 64) in;

const int tileSide = 19;
const uint one = 1u << 20;

layout(binding = 0, rg8) uniform writeonly image3D target;
layout(binding = 0, std430) readonly buffer Tiles { ivec4 tiles[]; };
layout(binding = 1, std430) readonly buffer Sums { uint sums[]; };

void main()
{
    int slot = int(gl_WorkGroupID.y);
    int number = int(gl_GlobalInvocationID.x);
    if (number >= tileSide * tileSide * tileSide)
        return;
    ivec3 at = ivec3(
        number % tileSide, number / tileSide % tileSide, number / (tileSide * tileSide));
    int place = 2 * (number + slot * tileSide * tileSide * tileSide);
    uint value = (min(sums[place], one) * 255u + one / 2u) >> 20;
    uint label = sums[place + 1] & 255u;
    imageStore(target, tiles[slot].xyz + at, vec4(float(value), float(label), 0.0, 0.0) / 255.0);
}
