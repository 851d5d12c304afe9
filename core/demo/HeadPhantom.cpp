// SPDX-License-Identifier: Apache-2.0
#include "core/demo/HeadPhantom.h"

#include "core/demo/BrainShapes.h"
#include "core/demo/HeadShapes.h"
#include "core/demo/Noise.h"
#include "core/demo/Shapes.h"

#include <array>

namespace core {

namespace {

using namespace demo;

constexpr std::array names{
    HeadPartName{HeadPart::Air, "Air"},
    HeadPartName{HeadPart::Skin, "Skin"},
    HeadPartName{HeadPart::Fat, "Fat"},
    HeadPartName{HeadPart::Muscle, "Muscle and other soft tissue"},
    HeadPartName{HeadPart::Skull, "Skull"},
    HeadPartName{HeadPart::Mandible, "Mandible"},
    HeadPartName{HeadPart::Vertebrae, "Cervical vertebrae"},
    HeadPartName{HeadPart::Teeth, "Teeth"},
    HeadPartName{HeadPart::Airway, "Airway and sinuses"},
    HeadPartName{HeadPart::Eye, "Eyes"},
    HeadPartName{HeadPart::GreyMatter, "Cortex"},
    HeadPartName{HeadPart::WhiteMatter, "White matter"},
    HeadPartName{HeadPart::DeepNuclei, "Basal ganglia and thalamus"},
    HeadPartName{HeadPart::Cerebellum, "Cerebellum"},
    HeadPartName{HeadPart::BrainStem, "Brain stem and spinal cord"},
    HeadPartName{HeadPart::Fluid, "Cerebrospinal fluid"},
    HeadPartName{HeadPart::Ventricles, "Ventricles"},
    HeadPartName{HeadPart::Membranes, "Dura"},
    HeadPartName{HeadPart::Vessels, "Contrast-filled vessels"},
};

HeadPart partOf(BrainTissue tissue)
{
    switch (tissue) {
    case BrainTissue::Fluid:
        return HeadPart::Fluid;
    case BrainTissue::Ventricle:
    case BrainTissue::Calcification:
        return HeadPart::Ventricles;
    case BrainTissue::Grey:
        return HeadPart::GreyMatter;
    case BrainTissue::White:
        return HeadPart::WhiteMatter;
    case BrainTissue::Nucleus:
        return HeadPart::DeepNuclei;
    case BrainTissue::Cerebellum:
        return HeadPart::Cerebellum;
    case BrainTissue::BrainStem:
        return HeadPart::BrainStem;
    case BrainTissue::Membrane:
        return HeadPart::Membranes;
    }
    return HeadPart::Fluid;
}

void paint(HeadPhantom::Sample& sample, float share, float value, HeadPart part)
{
    sample.hounsfield = mix(sample.hounsfield, value, share);
    if (share >= 0.5F)
        sample.part = part;
}

/// Hard outside, spongy inside.
float boneValue(const vec3& p, float distance)
{
    const float texture = noise(p / 2.6F, 71).value + 0.7F * noise(p / 1.4F, 72).value;
    const float sponge = 500.0F + 140.0F * texture;
    const float cortex = 1290.0F + 90.0F * noise(p / 6.0F, 73).value;
    return mix(sponge, cortex, coverage(-distance - 1.9F, 1.2F));
}

/// Skin, fat, and what lies between them and the bones.
void paintSoftTissue(HeadPhantom::Sample& sample, const vec3& p, float body, float vault)
{
    paint(sample, coverage(body), 42.0F, HeadPart::Skin);
    if (body > -0.5F)
        return;
    const float scalp = coverage(vault - 9.0F, 6.0F);
    const float fat = mix(5.5F + 2.5F * noise(p / 26.0F, 81).value, 3.2F, scalp);
    paint(sample, coverage(body + 1.9F), -95.0F, HeadPart::Fat);
    if (body > -1.5F)
        return;
    paint(sample, coverage(body + 1.9F + fat), 57.0F, HeadPart::Muscle);
    // Muscles are bundles with a little fat between them.
    const NoiseSample bundles = noise(vec3(p.x / 17.0F, p.y / 17.0F, p.z / 40.0F), 82);
    const float septum = std::abs(bundles.value) * 17.0F / (glm::length(bundles.slope) + 0.5F);
    paint(sample, 0.22F * coverage(std::max(septum - 0.9F, body + 4.0F + fat)), -95.0F,
        HeadPart::Fat);
    // The tongue, and a film of air over it.
    paint(sample, coverage(ellipsoid(p, {0, -54, -68}, {22, 28, 18})), 58.0F, HeadPart::Muscle);
    paint(sample, coverage(ellipsoid(p, {0, -58, -50.5F}, {17, 18, 1.6F})), -700.0F,
        HeadPart::Airway);
}

void paintEye(HeadPhantom::Sample& sample, const vec3& p, const FaceDistances& face, float body)
{
    const vec3 q = folded(p);
    paint(sample, coverage(std::max(face.orbit, body + 2.5F)), -85.0F, HeadPart::Fat);
    if (face.orbit < 2.0F) {
        float muscles = capsule(q, {31, -66, 4.5F}, {17, -40, -3}, 2.1F, 1.4F);
        muscles = std::min(muscles, capsule(q, {31, -66, -20}, {17, -40, -9}, 2.2F, 1.4F));
        muscles = std::min(muscles, capsule(q, {43, -66, -8}, {20, -40, -6}, 2.2F, 1.4F));
        muscles = std::min(muscles, capsule(q, {19, -66, -8}, {14, -40, -6}, 2.3F, 1.4F));
        paint(sample, coverage(muscles), 60.0F, HeadPart::Muscle);
        paint(sample, coverage(capsule(q, {29.5F, -62, -8}, {15, -36, -5}, 2.2F)), 38.0F,
            HeadPart::Eye);
    }
    paint(sample, coverage(face.globe), 62.0F, HeadPart::Eye);
    paint(sample, coverage(face.globe + 1.3F), 8.0F, HeadPart::Eye);
    paint(
        sample, coverage(ellipsoid(q, {31, -79.5F, -8}, {4.8F, 2.2F, 4.8F})), 85.0F, HeadPart::Eye);
}

} // namespace

std::span<const HeadPartName> headPartNames()
{
    return names;
}

HeadPhantom::Sample HeadPhantom::at(const vec3& scanned) const
{
    Sample sample;
    const vec3 ellipse = scanned / vec3(112.0F, 116.0F, 1e4F);
    if (glm::dot(ellipse, ellipse) > 1.0F)
        return sample;
    // Nobody is symmetrical.
    const vec3 p = scanned
        + 1.5F
            * vec3(noise(scanned / 52.0F, 91).value, noise(scanned / 52.0F, 92).value,
                noise(scanned / 52.0F, 93).value);

    const float cavity = cranialCavity(p);
    const float thickness = skullThickness(p);
    const bool deep = cavity < -4.0F;
    if (!deep) {
        const float vault = cavity - thickness;
        const float body = bodySurface(p, vault);
        if (body > 2.0F)
            return sample;
        paintSoftTissue(sample, p, body, vault);
        const bool faceNear = p.z < 45.0F;
        const FaceDistances face = faceNear ? faceCavities(p) : FaceDistances{99, 99, 99, 99, 99};
        if (face.orbit < 2.0F || face.globe < 2.0F)
            paintEye(sample, p, face, body);
        // Mucosa and cartilage around the airways.
        paint(sample, coverage(std::max(face.nasal - 3.0F, body + 1.0F)), 45.0F, HeadPart::Muscle);

        const BoneDistances bone = bones(p, cavity, thickness, face);
        float skullValue = boneValue(p, bone.skull);
        if (p.z > -14.0F && vault > -3.6F)
            skullValue = mix(skullValue, 130.0F, suture(p));
        paint(sample, coverage(bone.skull), skullValue, HeadPart::Skull);
        paint(sample, coverage(bone.mandible), boneValue(p, bone.mandible), HeadPart::Mandible);
        paint(sample, coverage(bone.vertebrae), boneValue(p, bone.vertebrae), HeadPart::Vertebrae);
        if (bone.teeth < 2.0F) {
            const bool crown = std::abs(p.z + 65.0F) < 8.0F;
            const float enamel = crown ? coverage(-bone.teeth - 1.3F, 1.0F) : 0.0F;
            paint(sample, coverage(bone.teeth), mix(1500.0F, 2450.0F, enamel), HeadPart::Teeth);
        }
        paint(sample, coverage(face.sinus), -995.0F, HeadPart::Airway);
        paint(sample, coverage(face.nasal), -998.0F, HeadPart::Airway);
        paint(sample, coverage(face.earCanal), -998.0F, HeadPart::Airway);
    }

    const float space = std::min(cavity, spinalCanal(p));
    if (space < 1.0F) {
        const BrainSample brain = brainAt(p, space);
        paint(sample, coverage(space), brain.value, partOf(brain.tissue));
    }
    const float vessel = m_vessels.distance(p);
    if (vessel < 1.0F)
        paint(sample, coverage(vessel, 1.1F), 285.0F, HeadPart::Vessels);
    return sample;
}

} // namespace core
