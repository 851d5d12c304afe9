// Integer interpolation of codes and radiation along rays (core/sculpt/CutFrame.h, rule 3).
// Requires volumeSize and the functions codeAt(ivec3) and radiationAt(ivec3).

const uint carvedAt = 128u << 24;

bool insideVolume(ivec3 p)
{
    return all(greaterThanEqual(p, ivec3(-(1 << 15))))
        && all(lessThan(p, (2 * volumeSize - 1) << 15));
}

ivec3 betweenCentres(ivec3 p)
{
    return clamp(p, ivec3(0), (volumeSize - 1) << 16);
}

// Z of rule 3: the code at p (index16), in 1/65536 of a code.
uint interpolatedCode(ivec3 p)
{
    p = betweenCentres(p);
    ivec3 low = p >> 16;
    ivec3 high = min(low + 1, volumeSize - 1);
    uvec3 f = uvec3(p & 0xFFFF) >> 8;
    uvec3 g = 256u - f;
    uint x00 = (codeAt(low) * g.x + codeAt(ivec3(high.x, low.yz)) * f.x) >> 4;
    uint x10 = (codeAt(ivec3(low.x, high.y, low.z)) * g.x + codeAt(ivec3(high.xy, low.z)) * f.x) >> 4;
    uint x01 = (codeAt(ivec3(low.xy, high.z)) * g.x + codeAt(ivec3(high.x, low.y, high.z)) * f.x) >> 4;
    uint x11 = (codeAt(ivec3(low.x, high.yz)) * g.x + codeAt(high) * f.x) >> 4;
    uint y0 = (x00 * g.y + x10 * f.y) >> 4;
    uint y1 = (x01 * g.y + x11 * f.y) >> 4;
    return y0 * g.z + y1 * f.z;
}

// The radiation at p (index16), in units of 2⁻²⁴.
uint interpolatedRadiation(ivec3 p)
{
    p = betweenCentres(p);
    ivec3 low = p >> 16;
    ivec3 high = min(low + 1, volumeSize - 1);
    uvec3 f = uvec3(p & 0xFFFF) >> 8;
    uvec3 g = 256u - f;
    uint x00 = radiationAt(low) * g.x + radiationAt(ivec3(high.x, low.yz)) * f.x;
    uint x10 = radiationAt(ivec3(low.x, high.y, low.z)) * g.x
        + radiationAt(ivec3(high.xy, low.z)) * f.x;
    uint x01 = radiationAt(ivec3(low.xy, high.z)) * g.x
        + radiationAt(ivec3(high.x, low.y, high.z)) * f.x;
    uint x11 = radiationAt(ivec3(low.x, high.yz)) * g.x + radiationAt(high) * f.x;
    return (x00 * g.y + x10 * f.y) * g.z + (x01 * g.y + x11 * f.y) * f.z;
}

bool carved(ivec3 p)
{
    return interpolatedRadiation(p) >= carvedAt;
}

// A thresholdCode of 65536 is never reached.
bool dense(ivec3 p, int thresholdCode)
{
    return thresholdCode <= 65535 && insideVolume(p)
        && interpolatedCode(p) >= uint(thresholdCode) << 16;
}

bool material(ivec3 p, int thresholdCode)
{
    return dense(p, thresholdCode) && !carved(p);
}
