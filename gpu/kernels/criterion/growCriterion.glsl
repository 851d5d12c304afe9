// The criterion of a growth besides its interval and the label plane; the rules are in
// core/growth/GrowthCommands.h (GrowLimits). Each limit is compiled only if its define is set, so
// that a growth without limits costs nothing more. Include this file after `codes`, `volumeSize`,
// `lowCode` and `highCode`.

// llvmpipe silently ends all loops of an invocation after 65535 iterations in total. So if the
// criterion itself has loops (27 neighbours, the digits of a root) an invocation tests fewer
// voxels.
#if defined(MAJORITY) || defined(GRADIENT_DIFFERENCE)
#define LONG_CRITERION
#endif

#ifdef ONLY_VISIBLE
layout(binding = 0) uniform usampler3D radiation; // at voxel centres it agrees with coverage
#endif
#ifdef SIGMAS
layout(binding = 4) uniform usampler2D seedCodes; // rows of bits: the codes that the seeds allow
uniform uint seedRows[256]; // row + 1 by label; 0: no code qualifies
#endif
#ifdef DIFFERENCE
uniform uint difference;
#endif
#if defined(GRADIENT) || defined(GRADIENT_DIFFERENCE)
uniform uvec3 gradientWeights;
#endif
#ifdef GRADIENT
uniform uint gradient;
#endif
#ifdef GRADIENT_DIFFERENCE
uniform uint gradientDifference;
#endif
#ifdef MAJORITY
uniform int majority;
#endif
#ifdef BOXED
uniform ivec3 boxFrom;
uniform ivec3 boxTo;
#endif

// The code at a voxel; outside the volume that of the nearest voxel.
uint codeAt(ivec3 voxel)
{
    return imageLoad(codes, clamp(voxel, ivec3(0), volumeSize - 1)).r;
}

bool isWithin(uint label, uint code)
{
#ifdef SIGMAS
    uint row = seedRows[label];
    if (row == 0u
        || (texelFetch(seedCodes, ivec2(code >> 5, row - 1u), 0).r >> (code & 31u) & 1u) == 0u)
        return false;
#endif
    return code >= lowCode && code <= highCode;
}

#ifdef SMOOTHED
// The codes of the 27 voxels around and at a voxel: in rows along x, by how many of the other axes
// a row lies aside on. Nothing here is a loop (LONG_CRITERION).
struct Around {
    uvec3 middle;
    uvec3 sides[4];
    uvec3 corners[4];
};

const uint halfWeight = 32u; // of 65, rounded down

uvec3 rowAt(ivec3 voxel)
{
    return uvec3(codeAt(voxel - ivec3(1, 0, 0)), codeAt(voxel), codeAt(voxel + ivec3(1, 0, 0)));
}

Around aroundAt(ivec3 voxel)
{
    Around around;
    around.middle = rowAt(voxel);
    around.sides[0] = rowAt(voxel + ivec3(0, -1, 0));
    around.sides[1] = rowAt(voxel + ivec3(0, 1, 0));
    around.sides[2] = rowAt(voxel + ivec3(0, 0, -1));
    around.sides[3] = rowAt(voxel + ivec3(0, 0, 1));
    around.corners[0] = rowAt(voxel + ivec3(0, -1, -1));
    around.corners[1] = rowAt(voxel + ivec3(0, 1, -1));
    around.corners[2] = rowAt(voxel + ivec3(0, -1, 1));
    around.corners[3] = rowAt(voxel + ivec3(0, 1, 1));
    return around;
}

// The weight of what lies below a code in a row: 1, 2, 1.
uint rowBelow(uvec3 row, uint code)
{
    uvec3 below = uvec3(lessThan(row, uvec3(code)));
    return below.x + 2u * below.y + below.z;
}

// Whether the median is below a code.
bool isMedianBelow(Around around, uint code)
{
    uint corners = rowBelow(around.corners[0], code) + rowBelow(around.corners[1], code)
        + rowBelow(around.corners[2], code) + rowBelow(around.corners[3], code);
    uint sides = rowBelow(around.sides[0], code) + rowBelow(around.sides[1], code)
        + rowBelow(around.sides[2], code) + rowBelow(around.sides[3], code);
    uint itself = around.middle.y < code ? 1u : 0u; // it weighs 9
    return corners + 2u * sides + 4u * rowBelow(around.middle, code) + itself > halfWeight;
}

bool isMedianWithin(uint label, ivec3 voxel)
{
    Around around = aroundAt(voxel);
#ifdef SIGMAS
    uint median = 0u; // the greatest code that it is not below, digit by digit
#define DIGIT(bit) median += isMedianBelow(around, median + bit) ? 0u : bit
    DIGIT(0x8000u); DIGIT(0x4000u); DIGIT(0x2000u); DIGIT(0x1000u);
    DIGIT(0x800u); DIGIT(0x400u); DIGIT(0x200u); DIGIT(0x100u);
    DIGIT(0x80u); DIGIT(0x40u); DIGIT(0x20u); DIGIT(0x10u);
    DIGIT(8u); DIGIT(4u); DIGIT(2u); DIGIT(1u);
#undef DIGIT
    return isWithin(label, median);
#else
    return !isMedianBelow(around, lowCode) && isMedianBelow(around, highCode + 1u);
#endif
}
#endif

#if defined(GRADIENT) || defined(GRADIENT_DIFFERENCE)
uint squaredPart(ivec3 voxel, ivec3 axis, uint weight)
{
    uint part = uint(abs(int(codeAt(voxel + axis)) - int(codeAt(voxel - axis))));
    part = min(weight * part >> 10, 32767u);
    return part * part;
}

uint squaredMagnitude(ivec3 voxel)
{
    return squaredPart(voxel, ivec3(1, 0, 0), gradientWeights.x)
        + squaredPart(voxel, ivec3(0, 1, 0), gradientWeights.y)
        + squaredPart(voxel, ivec3(0, 0, 1), gradientWeights.z);
}
#endif

#ifdef GRADIENT_DIFFERENCE
// The gradient magnitude: the square root, rounded down, computed digit by digit.
uint magnitudeAt(ivec3 voxel)
{
    uint left = squaredMagnitude(voxel);
    uint root = 0u;
    for (uint bit = 1u << 30; bit != 0u; bit >>= 2) {
        bool fits = left >= root + bit;
        left -= fits ? root + bit : 0u;
        root = (root >> 1) + (fits ? bit : 0u);
    }
    return root;
}
#endif

// @param code of the voxel
bool allows(uint label, ivec3 voxel, uint code)
{
#ifndef SMOOTHED
    if (!isWithin(label, code))
        return false;
#endif
#ifdef BOXED
    if (any(lessThan(voxel, boxFrom)) || any(greaterThan(voxel, boxTo)))
        return false;
#endif
#ifdef ONLY_VISIBLE
    if (texelFetch(radiation, voxel, 0).r >= 128u)
        return false;
#endif
#ifdef SMOOTHED
    if (!isMedianWithin(label, voxel))
        return false;
#endif
#ifdef GRADIENT
    // ⌊√s⌋ ≤ g is s < (g + 1)².
    if (squaredMagnitude(voxel) >= (gradient + 1u) * (gradient + 1u))
        return false;
#endif
#ifdef MAJORITY
    int count = 0;
    for (int i = 0; i < 27; ++i)
        count += isWithin(label, codeAt(voxel + ivec3(i % 3, i / 3 % 3, i / 9) - 1)) ? 1 : 0;
    if (count < majority)
        return false;
#endif
    return true;
}

// Values of the parent that are compared with each child, looked up once.
struct Parent {
    uint code;
    uint magnitude;
};

Parent parentAt(ivec3 voxel)
{
    Parent parent = Parent(0u, 0u);
#ifdef DIFFERENCE
    parent.code = codeAt(voxel);
#endif
#ifdef GRADIENT_DIFFERENCE
    parent.magnitude = magnitudeAt(voxel);
#endif
    return parent;
}

bool follows(Parent parent, ivec3 voxel)
{
#ifdef DIFFERENCE
    if (uint(abs(int(codeAt(voxel)) - int(parent.code))) > difference)
        return false;
#endif
#ifdef GRADIENT_DIFFERENCE
    if (uint(abs(int(magnitudeAt(voxel)) - int(parent.magnitude))) > gradientDifference)
        return false;
#endif
    return true;
}
