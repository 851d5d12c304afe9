// X-ray: the mean of the interpolated values along the ray that are not carved away. All of them
// count, including air; black if none is left.

/* Uniforms */
uniform vec2 window; // grey = mean code / 65535 · x + y

vec3 greyOf(float sum, float count)
{
    return vec3(count > 0.0 ? clamp(sum / count * window.x + window.y, 0.0, 1.0) : 0.0);
}

#if SCULPTED
#if PIECES
/// Adds the values of a piece to the sum and to their number.
void addPiece(Ray ray, int piece, inout float sum, inout float count)
{
    const Samples samples = samplesOf(ray, cellSide);
    const float opacity = pieces[piece].low.w;
    float n = floor((ray.first - ray.gridZero) / stepMm) + 1.0;
    while (n < samples.last) {
        n = leaveFreeCells(piece, samples, n);
        const float end = min(
            max(leaves(samples, cellOf(samples, n), 0.0), n + 0.5), samples.last);
        while (n < end) {
            const vec3 at = samples.origin + samples.step * n;
            const float kept = footprintAt(piece, at) >= 0.5 ? opacity : 0.0;
            sum += kept * texture(intensity, at).r;
            count += kept;
            n += 1.0;
        }
    }
}
#endif

vec3 seenAlong(Ray ray)
{
    const Samples samples = samplesOf(ray, cellSide);
    float n = 1.0;
    float sum = 0.0;
    float count = 0.0;
    float segmentAt = nowhere;
#if PIECES
    for (int k = 0; k < pieceCount; ++k) {
        const Ray own = pieceRay(ray, k);
        if (own.first < own.last)
            addPiece(own, k, sum, count);
    }
    n = ray.first < ray.last ? n : nowhere; // beside the volume
#endif
    do {
        vec3 cell = vec3(0.0);
        uvec2 skip = uvec2(0u);
        for (;;) { // free: carved away completely
            cell = cellOf(samples, n);
            skip = skipAt(cell);
            if (skip.x == 0u || n >= samples.last)
                break;
            n = max(n, floor(leaves(samples, cell, float(skip.x) - 1.0))) + 1.0;
        }
        const float end = min(max(leaves(samples, cell, 0.0), n + 0.5), samples.last);
        const bool plain = (skip.y & (carvedFlag | segmentFlag)) == 0u;
        const float sculptedEnd = plain ? n : end;
        do {
            const vec3 at = samples.origin + samples.step * n;
            const bool there = n < sculptedEnd;
            const float kept = there && texture(radiation, at).r < 0.5 ? 1.0 : 0.0;
            sum += kept * texture(intensity, at).r;
            count += kept;
            const bool enters = there && segmentAt == nowhere && segmentationAt(at) >= 0.5;
            segmentAt = enters ? n : segmentAt;
            n += there ? 1.0 : 0.0;
        } while (n < sculptedEnd);
        const float plainEnd = plain ? end : n;
        do {
            const float kept = n < plainEnd ? 1.0 : 0.0;
            sum += kept * texture(intensity, samples.origin + samples.step * n).r;
            count += kept;
            n += kept;
        } while (n < plainEnd);
    } while (n < samples.last);
    const vec3 at = samples.origin + samples.step * segmentAt;
    const vec3 inward = segmentRise(ray, at);
    const vec3 normal = normalize(gradientToWorld * -inward - 1e-9 * ray.world);
    const vec3 segment = lit(segmentColour(at), lightOn(normal, -ray.world, 1.0, 0.15));
    vec3 picture = greyOf(sum, count);
    float over = 0.7;
#if CONTEXT == 1
    const float grey = segmentAt == nowhere && !pastTranslucent ? contextOpacity.x : contextOpacity.y;
    picture *= grey;
    over = mix(1.0, over, grey);
#endif
    meetSegment(segmentAt != nowhere);
    return mix(picture, segment, segmentAt != nowhere ? over : 0.0);
}
#else
vec3 seenAlong(Ray ray)
{
    const float last = (ray.last - ray.gridZero) / stepMm;
    const vec3 origin = ray.origin + ray.direction * ray.gridZero;
    const vec3 perSample = ray.direction * stepMm;
    float sum = 0.0;
    float n = 1.0;
    do {
        const float value = texture(intensity, origin + perSample * n).r;
        sum += n < last ? value : 0.0;
        n += 1.0;
    } while (n < last);
    const vec3 picture = greyOf(sum, ceil(last) - 1.0);
#if CONTEXT == 1
    return picture * contextOpacity.x;
#endif
    return picture;
}
#endif
