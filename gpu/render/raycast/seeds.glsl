// Seeds that wait for a growth: small bodies where their radiation (core/sculpt/radiation/SparseRadiation.h)
// is at least one half, in the colours of their segments. Seeds behind tissue shine through.

/* Textures */
layout(binding = 12) uniform usampler3D seedPages; // tile + 1, by bricks
layout(binding = 13) uniform sampler3D seedTiles;  // radiation, label / 255

/* Uniforms */
uniform vec3 seedLow; // index: low corner of the box around all seeds
uniform vec3 seedHigh;

const float seedBrick = 16.0;
const int seedTileSide = 19;
const int seedTilesPerRow = 16;

/// The texel of voxel −1 of a tile.
ivec3 seedTile(uint page)
{
    const int tile = int(page) - 1;
    return seedTileSide
        * ivec3(tile % seedTilesPerRow, tile / seedTilesPerRow % seedTilesPerRow,
            tile / (seedTilesPerRow * seedTilesPerRow));
}

/// The brick whose tile is used at a place (index).
ivec3 seedBrickOf(vec3 place)
{
    const ivec3 last = textureSize(seedPages, 0) - 1;
    return clamp(ivec3(floor(place / seedBrick)), ivec3(0), last);
}

float seedsIn(uint page, ivec3 brick, vec3 place)
{
    const vec3 texel = vec3(seedTile(page)) + place - vec3(brick) * seedBrick + 1.5;
    return texture(seedTiles, texel / vec3(textureSize(seedTiles, 0))).r;
}

/// Adds the seeds to what is seen: those in front of it, and those behind it faintly.
vec3 withSeeds(Ray ray, vec3 seen)
{
    const vec3 origin = ray.origin / voxel - 0.5; // index
    const vec3 direction = ray.direction / voxel;
    const vec3 inverse = ray.inverse * voxel;
    const vec3 toLow = (seedLow - origin) * inverse;
    const vec3 toHigh = (seedHigh - origin) * inverse;
    const vec3 enter = min(toLow, toHigh);
    const vec3 leave = max(toLow, toHigh);
    float t = max(ray.first, max(max(enter.x, enter.y), enter.z));
    const float last = min(ray.last, min(min(leave.x, leave.y), leave.z));
    const float stepSeed = 0.75 * stepMm;
    t += stepSeed * fract(pixelNoise(gl_FragCoord.xy) + jitterPhase);

    bool found = false;
    for (;;) {
        if (found || t >= last)
            break;
        const vec3 place = origin + direction * t;
        const ivec3 brick = seedBrickOf(place);
        const uint page = texelFetch(seedPages, brick, 0).r;
        const vec3 border = (vec3(brick) + vec3(greaterThan(inverse, vec3(0.0)))) * seedBrick;
        const vec3 times = (border - origin) * inverse;
        const float leaving = min(min(times.x, times.y), times.z);
        found = page != 0u && seedsIn(max(page, 1u), brick, place) >= 0.5;
        const float next = page != 0u ? t + stepSeed : max(t, leaving) + 0.01 * stepSeed;
        t = found ? t : next;
    }
    float before = t - stepSeed;
    for (int halving = 0; halving < 4; ++halving) {
        const float middle = 0.5 * (before + t);
        const vec3 place = origin + direction * middle;
        const ivec3 brick = seedBrickOf(place);
        const uint page = texelFetch(seedPages, brick, 0).r;
        const bool inside = page != 0u && seedsIn(max(page, 1u), brick, place) >= 0.5;
        before = inside ? before : middle;
        t = inside ? middle : t;
    }

    const vec3 place = origin + direction * t;
    const ivec3 brick = seedBrickOf(place);
    const uint page = max(texelFetch(seedPages, brick, 0).r, 1u);
    const vec3 rise = vec3(
        seedsIn(page, brick, place + vec3(0.7, 0, 0)) - seedsIn(page, brick, place - vec3(0.7, 0, 0)),
        seedsIn(page, brick, place + vec3(0, 0.7, 0)) - seedsIn(page, brick, place - vec3(0, 0.7, 0)),
        seedsIn(page, brick, place + vec3(0, 0, 0.7)) - seedsIn(page, brick, place - vec3(0, 0, 0.7)));
    const vec3 normal = normalize(gradientToWorld * -rise - 1e-9 * ray.world);
    const ivec3 nearestVoxel = ivec3(round(place)) - brick * int(seedBrick) + 1;
    const float label = texelFetch(seedTiles, seedTile(page) + nearestVoxel, 0).g * 255.0;
    const vec3 own = texelFetch(palette, ivec2(int(label + 0.5), 0), 0).rgb;
    const vec3 look = lit(own, lightOn(normal, -ray.world, 1.0, 0.35));
    const bool hidden = t > solidFrom + 2.0 * stepMm;
    solidFrom = found && !hidden ? min(solidFrom, t) : solidFrom;
    return mix(seen, look, found ? (hidden ? 0.25 : 1.0) : 0.0);
}
