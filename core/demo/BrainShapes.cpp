// SPDX-License-Identifier: Apache-2.0
#include "core/demo/BrainShapes.h"

#include "core/demo/Noise.h"
#include "core/demo/Shapes.h"

namespace core::demo {

namespace {

constexpr float greyHu = 39.0F;
constexpr float whiteHu = 27.5F;

/// Paints tissue over what is there, with soft edges; the tissue with the greater share names it.
class Painter {
public:
    void paint(float distance, float value, BrainTissue tissue)
    {
        const float share = coverage(distance);
        m_sample.value = mix(m_sample.value, value, share);
        if (share >= 0.5F)
            m_sample.tissue = tissue;
    }
    [[nodiscard]] const BrainSample& sample() const { return m_sample; }

private:
    BrainSample m_sample;
};

/// Height of the tentorium: a tent whose ridge falls to the back.
float tentorium(const vec3& p)
{
    return 11.0F - 0.2F * (p.y - 14.0F) - 0.24F * std::abs(p.x);
}

float ventricles(const vec3& p)
{
    // Left and right differ a little.
    const vec3 q(std::abs(p.x) * (p.x > 0 ? 0.97F : 1.04F), p.y, p.z);
    float shape = capsule(q, {8, -29, 17}, {8.5F, -10, 25}, 3.6F, 4.2F);
    shape = join(shape, capsule(q, {8.5F, -10, 25}, {13, 16, 28}, 4.2F, 4.6F), 3);
    shape = join(shape, capsule(q, {13, 16, 28}, {22, 30, 19}, 4.6F, 6.8F), 4);
    shape = join(shape, capsule(q, {22, 30, 19}, {18, 56, 14}, 5.5F, 2.2F), 4);
    shape = join(shape, capsule(q, {22, 30, 19}, {32, 14, 0}, 5.0F, 2.8F), 4);
    shape = join(shape, capsule(q, {32, 14, 0}, {28, -12, -9}, 2.8F, 2.0F), 3);
    shape = std::max(shape, 0.9F - q.x); // septum pellucidum
    float third = ellipsoid(p, {0, 3, 10}, {2.4F, 14, 10});
    third = join(third, capsule(q, {6, -9, 20}, {1, -4, 15}, 1.3F), 1.5F); // foramina of Monro
    float fourth = capsule(p, {0, 17, 3}, {0, 25, -10}, 1.2F);
    fourth = join(fourth, ellipsoid(p, {0, 28, -17}, {8, 5, 9}), 2);
    return std::min({shape, third, fourth});
}

float corpusCallosum(const vec3& p)
{
    const float y = (p.y - 4.0F) / 38.0F;
    const float z = (p.z - 14.0F) / 20.0F;
    const float radius = std::sqrt(y * y + z * z);
    const float arc = (radius - 1.0F) * 24.0F;
    return std::max({std::abs(arc) - 3.6F, std::abs(p.x) - 20.0F, 6.0F - p.z});
}

/// Distance to the nearest sulcus: zero set of noise that hardly changes along the radius, so that
/// its sheets stand upright on the surface.
float sulci(const vec3& p, float depth)
{
    const vec3 centre(0, 6, 14);
    const vec3 ray = p - centre;
    const float length = glm::length(ray) + 1e-3F;
    const vec3 out = ray / length;
    vec3 q = centre + out * (52.0F + 0.28F * length);
    q += 5.0F
        * vec3(noise(p / 21.0F, 51).value, noise(p / 21.0F, 52).value, noise(p / 21.0F, 53).value);
    const float size = 17.0F;
    const NoiseSample fold = noise(q / size, 54);
    const NoiseSample fine = noise(q / 11.0F + 3.0F, 55);
    const float sheet = std::abs(fold.value) * size / (glm::length(fold.slope) + 0.35F);
    const float other = std::abs(fine.value) * 11.0F / (glm::length(fine.slope) + 0.35F);
    const float reach = 15.0F + 6.0F * noise(p / 27.0F, 56).value;
    // Deep folds and shallow ones; both close with depth.
    const float deep = std::max(sheet - 0.9F + 0.035F * depth, depth - reach);
    const float shallow = std::max(other - 0.7F + 0.05F * depth, depth - 0.55F * reach);
    return std::min(deep, shallow);
}

struct StemShapes {
    float stem = 0.0F;
    float cord = 0.0F;
};

float brainStem(const vec3& p)
{
    const vec3 q = folded(p);
    float stem = ellipsoid(p, {0, 8, -15}, {15, 12, 13}); // pons
    stem = join(stem, capsule(p, {0, 10, 0}, {0, 14, -28}, 9, 9), 5);
    stem = join(stem, capsule(q, {5, 2, 0}, {12, -6, 8}, 6, 6), 4); // peduncles
    stem = join(stem, capsule(p, {0, 15, -26}, {0, 20, -48}, 8, 6), 4);
    stem = join(stem, capsule(p, {0, 20, -48}, {0, 26, -130}, 6, 5), 3);
    return stem;
}

} // namespace

BrainSample brainAt(const vec3& p, float cavity)
{
    const vec3 q = folded(p);
    const float depth = -cavity;
    Painter painter;
    const float tent = p.z - tentorium(p);
    const float stem = brainStem(p);

    // Cerebrum: the cavity less the fluid's coat, the cisterns, the cerebellum's room and the
    // cleft.
    float cerebrum = 2.3F + 0.9F * noise(p / 12.0F, 61).value - depth;
    // Under the tentorium, which ends at the petrous ridges and in the middle at its notch.
    const float notch = std::max(4.0F + 0.53F * (q.x - 15.0F), 17.0F - 0.6F * q.x);
    if (p.y > 2.0F)
        cerebrum = std::max(cerebrum, std::min(1.6F - tent, p.y - notch));
    cerebrum = std::max(cerebrum, std::min(3.2F - stem, 2.0F - p.z));
    cerebrum = carve(cerebrum, ellipsoid(p, {0, -15, -5}, {14, 11, 8}), 5);
    cerebrum = carve(cerebrum, ellipsoid(p, {0, 24, 4}, {12, 8, 6}), 4);
    const float core = ellipsoid(p, {0, 4, 14}, {24, 41, 22});
    const float wander = 1.0F * noise(p / 14.0F, 62).value;
    const float cleft = std::max(std::abs(p.x + 0.4F * wander) - 1.5F, -core);
    cerebrum = std::max(cerebrum, -cleft);
    // Sylvian fissure: a curved sheet that opens to the side; its floor is the insula.
    const float lift = p.z - (1.0F + 0.42F * (p.y + 16.0F)) - 2.0F * wander;
    const float sylvian = std::max({std::abs(lift) - 1.3F - 0.03F * std::max(q.x - 40.0F, 0.0F),
        33.5F + 0.02F * lift * lift - q.x, p.y - 28.0F, -30.0F - p.y});
    const float insula =
        std::max({std::abs(q.x - 36.0F) - 0.9F, std::abs(lift) - 11.0F, p.y - 16.0F, -24.0F - p.y});
    cerebrum = std::max({cerebrum, -sylvian, -insula});
    if (depth < 26.0F || q.x < 14.0F) {
        const float fissured = std::min(depth, q.x + 3.0F);
        if (core > 4.0F)
            cerebrum = std::max(cerebrum, -sulci(p, fissured));
    }

    const float ribbon = 2.9F + 0.5F * noise(p / 8.0F, 63).value;
    painter.paint(cerebrum, greyHu, BrainTissue::Grey);
    painter.paint(cerebrum + ribbon, whiteHu, BrainTissue::White);
    const bool inside = cerebrum < -2.0F;

    if (core < 12.0F && inside) {
        painter.paint(ellipsoid(q, {26, -3, 12}, {5.5F, 16, 9}), 37, BrainTissue::Nucleus);
        painter.paint(ellipsoid(q, {19, -1, 11}, {4, 9, 6}), 40, BrainTissue::Nucleus);
        painter.paint(ellipsoid(q, {11, 8, 14}, {8, 13, 8}), 36, BrainTissue::Nucleus);
        const float caudate = join(capsule(q, {14, -22, 18}, {17, 0, 26}, 5.5F, 3.0F),
            capsule(q, {17, 0, 26}, {22, 18, 24}, 3.0F, 1.6F), 3);
        painter.paint(caudate, 38, BrainTissue::Nucleus);
    }
    painter.paint(std::max(corpusCallosum(p), -depth + 20.0F), whiteHu - 1.0F, BrainTissue::White);

    // Cerebellum with its leaves: shells around the fourth ventricle.
    if (p.y > 4.0F && tent < 4.0F && p.z < 14.0F) {
        float cerebellum = std::max(
            {2.4F - depth, tent + 1.4F, 2.0F - stem, ellipsoid(q, {16, 40, -16}, {39, 36, 30})});
        const float bend = 2.2F * noise(p / 9.0F, 64).value;
        const float radius = glm::length((p - vec3(0, 16, -14)) * vec3(0.55F, 1.0F, 1.1F)) + bend;
        const float leaf = std::abs(radius / 4.6F - std::round(radius / 4.6F)) * 4.6F;
        cerebellum = std::max(cerebellum, std::min(0.45F - leaf, cerebellum + 9.0F));
        painter.paint(cerebellum, greyHu, BrainTissue::Cerebellum);
        const float medulla = std::max(cerebellum + 1.5F,
            std::min(ellipsoid(q, {16, 36, -17}, {22, 15, 11}), 0.55F - leaf + 1.0F)
                + 2.5F * noise(p / 7.0F, 65).value);
        painter.paint(medulla, whiteHu + 1.0F, BrainTissue::Cerebellum);
    }
    painter.paint(stem, 32, BrainTissue::BrainStem);
    painter.paint(ventricles(p), 6, BrainTissue::Ventricle);

    // Membranes: falx between the halves, tentorium over the cerebellum.
    if (core > 3.0F && p.z > 4.0F)
        painter.paint(std::abs(p.x) - 0.45F, 55, BrainTissue::Membrane);
    if (p.y > 14.0F && p.z < 20.0F && stem > 6.0F)
        painter.paint(std::abs(tent) - 0.5F, 52, BrainTissue::Membrane);
    painter.paint(0.3F + depth - 1.2F, 50, BrainTissue::Membrane);

    painter.paint(ellipsoid(p, {0.5F, 24, 9}, {2.2F, 2.6F, 2}), 190, BrainTissue::Calcification);
    const float plexus = ellipsoid(q, {20, 31, 18}, {2.2F, 4, 3});
    painter.paint(plexus + 1.2F * noise(p / 2.5F, 66).value, 110, BrainTissue::Calcification);
    return painter.sample();
}

} // namespace core::demo
