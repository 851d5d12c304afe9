// SPDX-License-Identifier: Apache-2.0
#include "core/demo/HeadShapes.h"

#include "core/demo/Noise.h"
#include "core/demo/Shapes.h"

namespace core::demo {

namespace {

/// Cheek bones, arches, rims of the orbits, upper jaw, nasal bones.
float upperFace(const vec3& p, const FaceDistances& face)
{
    const vec3 q = folded(p);
    float bone = facialMass(p);
    // Upper jaw with the anterior nasal spine, palate and tooth sockets.

    bone = join(bone, capsule(p, {0, -84, -46}, {0, -90, -45}, 4, 1.5F), 4);
    bone = join(bone, roundBox(p, {0, -58, -47}, {26, 24, 2.5F}, 2), 3);
    bone = join(bone, capsule(q, {18, -38, -26}, {20, -34, -50}, 4, 3), 4); // pterygoid plates
    // Thin walls where a cavity ends.
    bone = std::min(bone, std::max(face.orbit - 2.1F, -66.0F - p.y));
    return bone;
}

/// The curve that the teeth stand on: angle, distance across and length along it.
struct ArchPoint {
    float along = 0.0F; ///< mm from the midline
    float across = 0.0F; ///< mm, positive outwards
};

ArchPoint onArch(const vec3& p, float halfWidth, float front, float length)
{
    // An ellipse's upper half, measured by angle.
    const float y = (p.y - (front + length)) / -length;
    const float x = p.x / halfWidth;
    const float angle = std::atan2(x, y);
    const float radius = std::sqrt(x * x + y * y);
    const float scale = std::sqrt(halfWidth * halfWidth * std::cos(angle) * std::cos(angle)
        + length * length * std::sin(angle) * std::sin(angle));
    const float local = std::sqrt(halfWidth * halfWidth * std::sin(angle) * std::sin(angle)
        + length * length * std::cos(angle) * std::cos(angle));
    return {angle * scale, (radius - 1.0F) * local};
}

/// One row of teeth; z grows from the biting edge to the root's tip.
float toothRow(const ArchPoint& arch, float z)
{
    const float pitch = 7.2F;
    const float index = std::floor(arch.along / pitch);
    if (index < -7.0F || index > 6.0F || z < -2.0F || z > 22.0F)
        return 4.0F;
    const float along = arch.along - (index + 0.5F) * pitch;
    const bool molar = index < -4.0F || index > 3.0F;
    // Incisors are chisels, molars are blocks; roots taper.
    const float taper = z < 8.0F ? 1.0F : 1.0F - 0.045F * (z - 8.0F);
    const float halfAcross = (molar ? 4.6F : 1.6F + 0.28F * std::min(z, 8.0F)) * taper;
    const float halfAlong = 3.25F * (z < 8.0F ? 0.93F + 0.07F * z / 8.0F : taper * 0.9F);
    const vec3 d(std::abs(along) - halfAlong, std::abs(arch.across) - halfAcross,
        std::abs(z - 10.0F) - 10.0F);
    const float rounding = 1.4F;
    return glm::length(glm::max(d + rounding, 0.0F))
        + std::min(std::max({d.x, d.y, d.z}) + rounding, 0.0F) - rounding;
}

float jaw(const vec3& p)
{
    const vec3 q = folded(p);
    const ArchPoint arch = onArch(p, 33, -82, 42);
    // Body: a band along the arch that leans outwards to its lower edge.
    const float lower = -90.0F + 0.006F * q.x * q.x;
    const float middle = 0.5F * (lower - 72.0F);
    const vec3 d(
        0.0F, std::abs(arch.across - 1.5F) - 5.0F, std::abs(p.z - middle) - (middle - lower));
    float bone = glm::length(glm::vec2(std::max(d.y + 3.0F, 0.0F), std::max(d.z + 3.0F, 0.0F)))
        + std::min(std::max(d.y, d.z) + 3.0F, 0.0F) - 3.0F;
    bone = std::max(bone, p.y + 38.0F);
    bone = join(bone, ellipsoid(p, {0, -86, -88}, {13, 5, 6}), 6);
    // Ramus, condyle and coronoid process.
    const float ramus =
        roundBox(vec3(q.x - 0.14F * (q.z + 60.0F), q.y + 0.25F * (q.z + 60.0F), q.z),
            {44, -22, -61}, {3.5F, 15, 22}, 3);
    bone = join(bone, ramus, 8);
    bone = join(bone, capsule(q, {34, -44, -82}, {43, -16, -76}, 6, 5.5F), 8);
    bone = join(bone, capsule(q, {47, -14, -40}, {52, -3, -27}, 4, 4.5F), 5);
    bone = join(bone, capsule(q, {46, -34, -42}, {48, -36, -29}, 4, 2), 5);
    return bone;
}

float spine(const vec3& p)
{
    const vec3 q = folded(p);
    // Atlas: a ring with lateral masses; axis with its tooth; then like ones.
    const float ring = glm::length(glm::vec2(
                           glm::length(glm::vec2(p.x, (p.y - 24.0F) * 0.95F)) - 19.0F, p.z + 53.0F))
        - 4.2F;
    float bone = join(ring, ellipsoid(q, {22, 16, -52}, {8, 9, 8}), 4);
    bone = join(bone, capsule(q, {24, 20, -53}, {37, 22, -54}, 4, 3.5F), 4);
    bone = std::min(bone, capsule(p, {0, 9, -46}, {0, 12, -66}, 5, 6.5F));
    for (int level = 0; level < 4; ++level) {
        const float z = -69.0F - 16.0F * static_cast<float>(level);
        const float y = 14.0F + 1.5F * static_cast<float>(level);
        float one = roundBox(p, {0, y, z}, {10.5F, 8, 6.3F}, 3);
        one = join(one, capsule(q, {10, y + 6, z}, {20, y + 12, z}, 3.5F, 5.5F), 4);
        one = join(one, capsule(q, {20, y + 12, z}, {3, y + 27, z - 3}, 4, 3), 4);
        one = join(one, capsule(q, {0, y + 27, z - 3}, {4, y + 41, z - 8}, 3.5F, 3), 3);
        one = join(one, capsule(q, {14, y, z}, {23, y + 1, z}, 3, 2.5F), 3);
        bone = std::min(bone, one);
    }
    return bone;
}

} // namespace

float suture(const vec3& p)
{
    // Interlocking: the line wanders with two wavelengths.
    const float jag = 2.0F * noise(p / 3.2F, 41).value + 1.6F * noise(p / 7.0F, 42).value;
    const float coronalY = -22.0F - 0.10F * (80.0F - p.z) + jag;
    float distance = 1e3F;
    if (p.z > 12.0F)
        distance = std::abs(p.y - coronalY);
    const float lambdaY = 66.0F;
    if (p.z > 30.0F && p.y > coronalY && p.y < lambdaY + 6.0F)
        distance = std::min(distance, std::abs(p.x + jag));
    // Lambdoid: from lambda down to both sides.
    if (p.y > 34.0F && p.z > -14.0F && p.z < 56.0F)
        distance =
            std::min(distance, 0.72F * std::abs((52.0F - p.z) - 1.05F * std::abs(p.x) + jag));
    // Squamous: an arch over the ear.
    if (std::abs(p.x) > 48.0F && p.z > -8.0F && p.y > -30.0F && p.y < 46.0F) {
        const float arch = 26.0F - 0.018F * (p.y - 8.0F) * (p.y - 8.0F);
        distance = std::min(distance, std::abs(p.z - arch + 0.6F * jag));
    }
    return coverage(distance - 0.75F, 0.9F);
}

BoneDistances bones(const vec3& p, float cavity, float thickness, const FaceDistances& face)
{
    BoneDistances bone;
    const vec3 q = folded(p);
    if (p.z > -62.0F) {
        float skull = cavity - thickness;
        // The vault ends at the base: below, only what follows.
        skull = join(skull, capsule(q, {62, 22, -24}, {15, -1, -24}, 10, 6), 6);
        skull = join(skull, mastoid(p), 6);
        skull = join(skull, capsule(p, {0, -38, -17}, {0, 8, -38}, 15, 8), 8);
        skull = join(skull, capsule(q, {13, 12, -42}, {16, 20, -45}, 6), 4); // condyles
        skull = join(skull, ellipsoid(p, {0, 81, -8}, {8, 4, 5}), 12); // inion
        skull = join(skull, upperFace(p, face), 9);
        skull = std::max(skull, -cavity);
        skull = carve(skull, spinalCanal(p), 2);
        skull = std::max({skull, -face.orbit, -face.sinus, -face.earCanal});
        skull = std::max(skull, -(face.nasal - 1.0F));
        // Optic canal, superior orbital fissure, inner ear canal, carotid canal, jugular foramen.
        float holes = capsule(q, {15, -36, -5}, {8, -18, -1}, 2.6F);
        holes = std::min(holes, ellipsoid(q, {21, -34, -8}, {5, 6, 2.4F}));
        holes = std::min(holes, capsule(q, {14, 8, -21}, {32, 12, -22}, 3.0F));
        holes = std::min(holes, capsule(q, {25, 6, -60}, {24, 4, -28}, 3.4F));
        holes = std::min(holes, capsule(q, {24, 4, -28}, {10, -10, -20}, 3.4F));
        holes = std::min(holes, capsule(q, {29, 22, -60}, {30, 24, -26}, 5));
        bone.skull = std::max(skull, -holes);
        const float joint = ellipsoid(q, {52, -3, -25}, {10, 8, 7});
        bone.skull = std::max(bone.skull, -joint);
    } else {
        bone.skull = 20.0F;
    }

    bone.mandible = p.z < -18.0F && p.y < 14.0F ? jaw(p) : 20.0F;
    bone.vertebrae = p.z < -38.0F && p.y > -14.0F ? std::max(spine(p), -spinalCanal(p)) : 20.0F;
    bone.teeth = 20.0F;
    if (p.y < -34.0F && p.z < -40.0F && p.z > -92.0F) {
        const ArchPoint upper = onArch(p, 31, -87, 46);
        const ArchPoint lower = onArch(p, 29.5F, -84.5F, 45);
        bone.teeth = std::min(toothRow(upper, p.z + 64.5F), toothRow(lower, -65.5F - p.z));
        // Sockets.
        const glm::vec2 d(std::abs(upper.across) - 2.0F, std::abs(p.z + 50.0F) - 3.5F);
        const float alveolus =
            glm::length(glm::max(d, 0.0F)) + std::min(std::max(d.x, d.y), 0.0F) - 3.5F;
        bone.skull = join(bone.skull, std::max(alveolus, p.y + 44.0F), 4);
    }
    return bone;
}

} // namespace core::demo
