// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/OrganScenes.h"

#include "tests/reenactment/CounterRandom.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/series/OpenedVolume.h"

#include <algorithm>
#include <cmath>

namespace reenact {

namespace {

constexpr int codeOfZero = 1024; ///< codes are HU + this
constexpr double noiseHu = 14.0;
constexpr double softness = 3.0; ///< voxels over which shapes run into each other
constexpr double spacingMm = 2.2;

struct Ellipsoid {
    glm::dvec3 middle{0.0};
    glm::dvec3 radii{1.0};
    /// About the distance, in voxels; negative inside.
    [[nodiscard]] double at(const glm::dvec3& place) const
    {
        const glm::dvec3 from = (place - middle) / radii;
        const double length = glm::length(from);
        const double slope = glm::length(from / radii);
        return slope > 1e-9 ? length * (length - 1.0) / slope : -glm::length(radii);
    }
};

double joined(double one, double other)
{
    const double share = std::clamp(0.5 + 0.5 * (other - one) / softness, 0.0, 1.0);
    return other + share * (one - other) - softness * share * (1.0 - share);
}

/// Balls joined, others taken off.
struct Body {
    Organ organ = Organ::None;
    double hu = 0.0;
    std::vector<Ellipsoid> parts;
    std::vector<Ellipsoid> hollows{};

    [[nodiscard]] double at(const glm::dvec3& place) const
    {
        double distance = parts.front().at(place);
        for (std::size_t i = 1; i < parts.size(); ++i)
            distance = joined(distance, parts[i].at(place));
        for (const Ellipsoid& hollow : hollows)
            distance = -joined(-distance, hollow.at(place));
        return distance;
    }
};

struct Plan {
    glm::ivec3 size{0};
    std::vector<Body> bodies; ///< the first has what several would
    double muscleHu = 55.0;
    double fatHu = -70.0;
};

Plan planOf(Organ organ)
{
    if (organ == Organ::Spleen || organ == Organ::Kidney)
        return {.size = {88, 80, 84},
            .bodies = {{Organ::Spleen, 116.0, {{{28, 38, 44}, {19, 27, 29}}},
                           {{{46, 30, 50}, {15, 22, 24}}}},
                {Organ::Kidney, 125.0, {{{56, 46, 38}, {17, 18, 27}}},
                    {{{70, 40, 38}, {8, 8, 9}}}}}};
    if (organ == Organ::Lung)
        return {.size = {84, 84, 96},
            .bodies = {{Organ::Lung, -850.0, {{{40, 42, 58}, {27, 31, 32}}},
                           {{{44, 42, 14}, {30, 34, 26}}, {{66, 36, 56}, {13, 16, 18}}}},
                {Organ::Stomach, -860.0, {{{44, 42, 21}, {25, 27, 18}}}}}};
    return {.size = {108, 86, 84},
        .bodies = {
            {Organ::Liver, 108.0, {{{36, 43, 38}, {25, 29, 30}}, {{68, 38, 47}, {27, 18, 14}}},
                {{{50, 58, 14}, {16, 22, 18}}}},
            {Organ::Heart, 117.0, {{{74, 38, 71}, {19, 19, 11}}}},
            {Organ::Stomach, 98.0, {{{82, 46, 22}, {18, 23, 14}}}}}};
}

} // namespace

Mask OrganScene::maskOf(Organ organ) const
{
    Mask mask = organs;
    for (std::uint8_t& value : mask.values)
        value = Organ(value) == organ ? 1 : 0;
    return mask;
}

OrganScene organPhantom(Organ organ, double scale)
{
    const Plan plan = planOf(organ);
    OrganScene scene;
    const glm::ivec3 size(glm::round(scale * glm::dvec3(plan.size)));
    core::Volume& volume = scene.study.volume;
    volume.identity.patientName = QStringLiteral("TEST^REFINE");
    volume.identity.modality = QStringLiteral("CT");
    volume.geometry.size = size;
    for (int axis = 0; axis < 3; ++axis) {
        volume.geometry.indexToWorld[axis][axis] = spacingMm / scale;
        volume.geometry.indexToWorld[3][axis] = -60.0 + 20.0 * axis;
    }
    volume.encoding = {.rescaleSlope = 1.0, .rescaleIntercept = -double(codeOfZero)};
    volume.unit = QStringLiteral("HU");
    scene.organs = {size, {}};
    const SmoothNoise fat(7, 1, 14.0 * scale);
    CounterRandom noise(7, 2);
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec3 place = glm::dvec3(x, y, z) / scale;
                const double fatShare = std::clamp(0.5 + fat.at(glm::dvec3(x, y, z)), 0.0, 1.0);
                double hu = plan.muscleHu + fatShare * (plan.fatHu - plan.muscleHu);
                Organ here = Organ::None;
                double room = 1.0;
                for (const Body& body : plan.bodies) {
                    const double distance = body.at(place) * scale;
                    // Half a voxel to either side of the border values are mixed.
                    const double share = std::min(room, std::clamp(0.5 - distance, 0.0, 1.0));
                    hu += share * (body.hu - hu);
                    room -= share;
                    if (distance < 0.0 && here == Organ::None)
                        here = body.organ;
                }
                scene.organs.values.push_back(std::uint8_t(here));
                const double value = hu + noiseHu * noise.normal();
                scene.study.codes.push_back(
                    std::uint16_t(std::clamp(value + codeOfZero, 0.0, 4000.0)));
            }
        }
    }
    volume.minimum = -codeOfZero;
    volume.maximum = 2976;
    volume.histogram = {volume.minimum, volume.maximum, std::vector<std::uint32_t>(64, 1)};
    volume.voxelsSha256 = "of a phantom";
    return scene;
}

std::optional<OrganScene> realOrgans(Organ organ, Organ beside)
{
    const test::SharedCase data = test::sharedCase(QStringLiteral("ct_totalseg_body_3mm"));
    if (data.source.isEmpty() || organ == Organ::Lung || organ == Organ::Heart
        || beside == Organ::Heart)
        return std::nullopt;
    OrganScene scene;
    const core::LoadedVolume whole =
        test::openVolume(data.source + QStringLiteral("/ct_3mm.nii.gz"));
    const core::LoadedVolume labels =
        test::openVolume(data.source + QStringLiteral("/ct_3mm_labels.nii.gz"));
    std::vector<std::pair<int, Organ>> names{
        {1, Organ::Spleen}, {3, Organ::Kidney}, {5, Organ::Liver}, {6, Organ::Stomach}};
    // These only where they are asked for: a fault runs along whatever is an organ.
    for (const auto& [label, name] : {std::pair(14, Organ::Lung), std::pair(64, Organ::PortalVein),
             std::pair(75, Organ::Femur), std::pair(77, Organ::Hip)}) {
        if (name == organ || name == beside)
            names.emplace_back(label, name);
    }
    // The box around it and its neighbours, so that an edit takes no longer than it must.
    const glm::ivec3 size = whole.volume.geometry.size;
    const auto organAt = [&](const glm::ivec3& voxel) {
        const std::size_t at = (std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y))
                * std::size_t(size.x)
            + std::size_t(voxel.x);
        const int label = int(std::lround(labels.volume.encoding.value(labels.codes[at])));
        const auto known = std::find_if(
            names.begin(), names.end(), [label](const auto& name) { return name.first == label; });
        return std::pair(known == names.end() ? Organ::None : known->second, at);
    };
    glm::ivec3 least = size;
    glm::ivec3 most(-1);
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const Organ here = organAt({x, y, z}).first;
                const bool isBeside = (organ == Organ::Spleen && here == Organ::Kidney)
                    || (organ == Organ::Liver && here == Organ::Stomach)
                    || (beside != Organ::None && here == beside);
                if (here != organ && !isBeside)
                    continue;
                least = glm::min(least, glm::ivec3(x, y, z));
                most = glm::max(most, glm::ivec3(x, y, z));
            }
        }
    }
    constexpr int margin = 8;
    least = glm::max(least - margin, glm::ivec3(0));
    most = glm::min(most + margin, size - 1);
    scene.study.volume = whole.volume;
    core::VolumeGeometry& geometry = scene.study.volume.geometry;
    geometry.indexToWorld[3] = glm::dvec4(whole.volume.geometry.toWorld(glm::dvec3(least)), 1.0);
    geometry.size = most - least + 1;
    scene.study.volume.voxelsSha256 = "of a part";
    scene.organs = {geometry.size, {}};
    for (int z = least.z; z <= most.z; ++z) {
        for (int y = least.y; y <= most.y; ++y) {
            for (int x = least.x; x <= most.x; ++x) {
                const auto [here, at] = organAt({x, y, z});
                scene.organs.values.push_back(std::uint8_t(here));
                scene.study.codes.push_back(whole.codes[at]);
            }
        }
    }
    return scene;
}

} // namespace reenact
