// SPDX-License-Identifier: Apache-2.0
#include "core/demo/HeadShapes.h"

#include "core/demo/Noise.h"
#include "core/demo/Shapes.h"

namespace core::demo {

float cranialCavity(const vec3& p)
{
    const vec3 q = folded(p);
    // An egg: broader behind.
    const vec3 egg(p.x * (1.0F + 0.0011F * (4.0F - p.y)), p.y, p.z);
    float cavity = ellipsoid(egg, {0, 4, 29}, {63, 82, 53});
    cavity = join(cavity, ellipsoid(q, {35, -14, -7}, {22, 28, 19}), 10);
    cavity = join(cavity, ellipsoid(p, {0, 39, -14}, {47, 37, 29}), 10);
    // The middle of the base rises between the fossae.
    float base = capsule(p, {0, -44, -16}, {0, -12, -19}, 15, 12);
    base = join(base, capsule(p, {0, -10, -18}, {0, 8, -36}, 10, 9), 6);
    base = carve(base, ellipsoid(p, {0, -15, -3}, {8, 6, 6}), 4);
    const float petrous = capsule(q, {62, 24, -27}, {15, -1, -24}, 11, 6);
    // Lesser wings of the sphenoid, and the orbits' roofs.
    const float wing = capsule(q, {56, -36, 4}, {14, -24, 1}, 5, 3);
    cavity = carve(cavity, base, 6);
    cavity = carve(cavity, petrous, 6);
    cavity = carve(cavity, wing, 9);
    return carve(cavity, ellipsoid(q, {30, -68, -8}, {20, 27, 18}), 4);
}

float spinalCanal(const vec3& p)
{
    return capsule(p, {0, 22, -30}, {0, 26, -130}, 15, 9);
}

float skullThickness(const vec3& p)
{
    float thickness = 6.4F + 1.1F * noise(p / 24.0F, 3).value;
    thickness += 1.6F * coverage(64.0F - p.y, 90.0F); // occiput
    thickness += 1.2F * coverage(58.0F + p.y, 70.0F); // forehead
    // Squama of the temple.
    const float temple =
        coverage(50.0F - std::abs(p.x), 12.0F) * coverage(std::abs(p.z - 8.0F) - 20.0F, 20.0F);
    return thickness - 2.4F * temple;
}

float facialMass(const vec3& p)
{
    const vec3 q = folded(p);
    float mass = ellipsoid(q, {31, -66, -8}, {22, 18, 20}); // around the orbits
    mass = join(mass, ellipsoid(q, {20, -60, 22}, {32, 22, 26}), 16); // forehead and brows
    mass = join(mass, ellipsoid(p, {0, -80, 12}, {26, 11, 14}), 8); // glabella
    mass = join(mass, ellipsoid(q, {44, -63, -24}, {12, 12, 13}), 8); // cheek bones
    mass = join(mass, ellipsoid(q, {22, -64, -40}, {21, 20, 17}), 10); // upper jaw
    mass = join(mass, capsule(q, {5, -84, 4}, {3.5F, -96, -14}, 5, 3), 6); // nasal bones
    // Cheek arches.
    mass = join(mass, capsule(q, {52, -54, -24}, {67, -26, -24}, 5.0F, 3.4F), 4);
    return join(mass, capsule(q, {67, -26, -24}, {65, 4, -19}, 3.4F, 4.5F), 3);
}

float mastoid(const vec3& p)
{
    return capsule(folded(p), {56, 27, -24}, {52, 24, -49}, 13, 7);
}

namespace {

float ear(const vec3& p)
{
    const vec3 q = folded(p);
    // Tilted plate with a rim and a hollow.
    const vec3 centre(77, 17, -14);
    vec3 r = (q - centre) * 1.1F;
    r = {r.x - 0.42F * r.y, r.y + 0.28F * r.z, r.z};
    const float plate = ellipsoid(r, vec3(0), {4.2F, 15, 29});
    const float radial = glm::length(glm::vec2(r.y / 15.0F, r.z / 29.0F));
    const float rim = glm::length(glm::vec2((radial - 0.88F) * 17.0F, r.x - 2.5F)) - 3.2F;
    float shape = join(plate, rim, 4);
    shape = carve(shape, ellipsoid(r, {4.5F, -2, -5}, {5.0F, 8, 12}), 3);
    shape = carve(shape, ellipsoid(r, {4.5F, 3, 14}, {3.4F, 7, 6}), 3);
    const float tragus = ellipsoid(q, {77, 4, -19}, {4, 4, 6});
    return join(shape, tragus, 3);
}

float nose(const vec3& p)
{
    const vec3 q = folded(p);
    float shape = capsule(p, {0, -86, 4}, {0, -104, -36}, 7.5F, 9);
    shape = join(shape, sphere(q, {9.5F, -96, -39}, 7), 8);
    shape = join(shape, ellipsoid(p, {0, -96, -41}, {5, 13, 4}), 4);
    return carve(shape, ellipsoid(q, {6.5F, -98, -47}, {3.4F, 6, 8}), 2);
}

} // namespace

float bodySurface(const vec3& p, float vault)
{
    const vec3 q = folded(p);
    float body = vault - 6.5F;
    // Temples are filled by the temporal muscle, so that the face goes over into the vault.
    body = join(body, ellipsoid(q, {40, -40, -8}, {29, 42, 40}), 20);
    body = join(body, ellipsoid(p, {0, -46, -42}, {47, 46, 44}), 18);
    body = join(body, capsule(q, {46, -6, -58}, {12, -64, -81}, 18, 20), 26);
    body = join(body, ellipsoid(q, {43, -36, -46}, {19, 34, 28}), 20);
    body = join(body, sphere(q, {7, -83, -82}, 10), 16);
    body = join(body, sphere(q, {42, -62, -34}, 17), 18);
    if (p.z < 75.0F) {
        body = join(body, facialMass(p) - 4.5F, 20);
        body = join(body, mastoid(p) - 5.0F, 22);
    }
    body = join(body, capsule(p, {0, 20, -40}, {0, 26, -150}, 52, 56), 24);
    // Sockets, then lids over the eyes.
    body = carve(body, ellipsoid(q, {32, -99, -8}, {18, 15, 12}), 12);
    body = join(body, sphere(q, {31, -73, -8}, 14.0F), 4);
    const float lid = -9.5F - 0.014F * (q.x - 31.0F) * (q.x - 31.0F);
    body = carve(body, ellipsoid(vec3(q.x, q.y, q.z - lid), {31, -88, 0}, {13, 4, 0.9F}), 1.5F);
    body = join(body, nose(p), 10);
    // Lips around a closed mouth.
    const float smile = 0.006F * p.x * p.x;
    body = join(body, ellipsoid(p, {0, -89, -59.0F + smile}, {21, 8, 4.5F}), 4);
    body = join(body, ellipsoid(p, {0, -88, -67.0F + smile}, {18, 8.5F, 5}), 4);
    body = carve(body, ellipsoid(p, {0, -96, -63.0F + smile}, {22, 7, 0.8F}), 2);
    body = carve(body, capsule(p, {0, -101, -47}, {0, -99, -56}, 3), 4);
    body = join(body, ear(p), 5);
    return body;
}

namespace {

/// Air cells: hollows of a foam, each @p size mm wide with walls between.
float cells(const vec3& p, float size, int seed)
{
    const vec3 q = p / size;
    const NoiseSample a = noise(q, seed);
    const NoiseSample b = noise(q * 1.3F + 7.0F, seed + 1);
    const float wall = std::min(std::abs(a.value) / (glm::length(a.slope) + 0.3F),
        std::abs(b.value) / (1.3F * glm::length(b.slope) + 0.3F));
    return (0.14F - wall) * size;
}

} // namespace

FaceDistances faceCavities(const vec3& p)
{
    const vec3 q = folded(p);
    FaceDistances face;
    // A cone whose apex points to the optic canal.
    face.orbit = join(ellipsoid(q, {31.5F, -74, -8}, {19, 19, 16.5F}),
        capsule(q, {29, -70, -8}, {14, -34, -5}, 15.5F, 3.5F), 6);
    face.globe = ellipsoid(q, {31, -73, -8}, {12, 12.3F, 12});

    // The two frontal sinuses differ, as they do.
    const vec3 frontal = p.x > 0 ? vec3(11, -84.5F, 16) : vec3(-9, -84.5F, 14);
    const vec3 frontalSize = p.x > 0 ? vec3(12, 4.2F, 12) : vec3(9, 3.8F, 9);
    const float wobble = 1.2F * noise(p / 9.0F, 11).value;
    float sinus = ellipsoid(p, frontal, frontalSize) + wobble;
    sinus = std::max(sinus, 0.8F - std::abs(p.x));
    const float maxillary = ellipsoid(q, {30, -60, -38}, {13.5F, 17, 14}) + wobble;
    sinus = std::min(sinus, maxillary);
    if (sinus < 3.0F)
        sinus = std::max(sinus, facialMass(p) + 2.2F); // and keeps a wall in front
    const float sphenoid =
        std::max(ellipsoid(q, {7, -29, -20}, {11, 12, 9}) + wobble, 0.9F - std::abs(p.x - 1.5F));
    sinus = std::min(sinus, sphenoid);
    const float ethmoid = roundBox(q, {8.5F, -60, -8}, {5.0F, 21, 10}, 3);
    if (ethmoid < 2.0F)
        sinus = std::min(sinus, std::max(ethmoid, cells(p, 10, 21)));
    sinus = std::max(sinus, 2.3F - face.orbit); // the orbit keeps its walls
    const float process = mastoid(p) + 3.4F;
    if (process < 2.0F)
        sinus = std::min(sinus, std::max(process, cells(p, 8, 31)));
    face.sinus = sinus;

    float nasal = ellipsoid(p, {0, -70, -30}, {15, 26, 19});
    nasal = join(nasal, roundBox(p, {0, -50, -34}, {13, 26, 11}, 6), 4);
    nasal = std::max(nasal, 0.7F - std::abs(p.x + 1.2F * std::sin(p.z * 0.12F))); // septum
    for (int level = 0; level < 3; ++level) {
        const float z = -22.0F - 9.0F * static_cast<float>(level);
        const float reach = 8.0F + static_cast<float>(level);
        const float turbinate = capsule(q, {reach, -78.0F, z}, {reach - 1.0F, -36.0F, z}, 3.6F);
        nasal = carve(nasal, turbinate, 1.5F);
    }
    // Nostrils, pharynx and larynx.
    nasal = join(nasal, capsule(q, {6.5F, -98, -53}, {6, -86, -34}, 3.0F, 4.2F), 2);
    nasal = join(nasal, capsule(p, {0, -26, -34}, {0, -12, -56}, 9, 8), 4);
    nasal = join(nasal, capsule(p, {0, -12, -56}, {0, -14, -130}, 8, 9), 4);
    face.nasal = nasal;

    face.earCanal = capsule(q, {80, 10, -19}, {50, 12, -20}, 3.4F, 2.8F);
    return face;
}

} // namespace core::demo
