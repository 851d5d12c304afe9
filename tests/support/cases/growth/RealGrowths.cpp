// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/growth/RealGrowths.h"

#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/criteria/GrowGuard.h"
#include "core/edits/kinds/growth/PlugLeak.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/parts/GrowBox.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/series/OpenedVolume.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace core;

namespace test {

namespace {

/// Voxels of the molar: slice, row, columns from and to.
constexpr int molarRuns[][4] = {{0, 174, 156, 160}, {0, 175, 155, 161}, {0, 176, 154, 162},
    {0, 177, 154, 162}, {0, 178, 154, 162}, {0, 179, 154, 162}, {0, 180, 154, 162},
    {0, 181, 154, 162}, {0, 182, 154, 162}, {0, 183, 155, 161}, {0, 184, 156, 161},
    {1, 175, 155, 160}, {1, 176, 154, 161}, {1, 177, 153, 162}, {1, 178, 153, 162},
    {1, 179, 153, 162}, {1, 180, 153, 162}, {1, 181, 153, 162}, {1, 182, 154, 162},
    {1, 183, 154, 162}, {1, 184, 155, 162}, {1, 185, 156, 161}, {2, 174, 155, 157},
    {2, 175, 154, 160}, {2, 176, 153, 162}, {2, 177, 153, 162}, {2, 178, 152, 163},
    {2, 179, 152, 163}, {2, 180, 152, 163}, {2, 181, 152, 163}, {2, 182, 153, 163},
    {2, 183, 153, 163}, {2, 184, 154, 162}, {2, 185, 156, 161}, {3, 174, 154, 158},
    {3, 175, 153, 160}, {3, 176, 152, 162}, {3, 177, 152, 163}, {3, 178, 152, 163},
    {3, 179, 152, 163}, {3, 180, 152, 163}, {3, 181, 152, 163}, {3, 182, 153, 163},
    {3, 183, 154, 163}, {3, 184, 155, 162}, {3, 185, 157, 161}, {4, 174, 153, 157},
    {4, 175, 152, 159}, {4, 176, 151, 161}, {4, 177, 151, 162}, {4, 178, 151, 162},
    {4, 179, 151, 162}, {4, 180, 152, 162}, {4, 181, 152, 162}, {4, 182, 153, 162},
    {4, 183, 154, 162}, {4, 184, 155, 162}, {4, 185, 158, 160}, {5, 174, 151, 155},
    {5, 175, 151, 156}, {5, 176, 151, 160}, {5, 177, 150, 161}, {5, 178, 150, 161},
    {5, 179, 151, 162}, {5, 180, 151, 162}, {5, 181, 152, 162}, {5, 182, 153, 162},
    {5, 183, 154, 161}, {5, 184, 157, 161}, {6, 174, 151, 155}, {6, 175, 150, 160},
    {6, 176, 150, 160}, {6, 177, 150, 161}, {6, 178, 150, 161}, {6, 179, 151, 161},
    {6, 180, 151, 161}, {6, 181, 153, 161}, {6, 182, 154, 161}, {6, 183, 155, 161},
    {6, 184, 158, 160}, {7, 174, 150, 153}, {7, 175, 150, 160}, {7, 176, 149, 160},
    {7, 177, 150, 160}, {7, 178, 150, 160}, {7, 179, 153, 160}, {7, 180, 153, 160},
    {7, 181, 153, 160}, {7, 182, 154, 160}, {7, 183, 156, 160}, {7, 184, 157, 160},
    {8, 173, 150, 152}, {8, 174, 149, 153}, {8, 175, 149, 153}, {8, 176, 149, 153},
    {8, 177, 149, 153}, {8, 178, 150, 152}, {8, 175, 157, 160}, {8, 176, 157, 160},
    {8, 177, 157, 161}, {8, 178, 157, 161}, {8, 179, 157, 161}, {8, 180, 154, 160},
    {8, 181, 153, 160}, {8, 182, 154, 160}, {8, 183, 155, 160}, {8, 184, 157, 159},
    {9, 174, 149, 152}, {9, 175, 149, 152}, {9, 176, 149, 152}, {9, 177, 149, 152},
    {9, 175, 157, 160}, {9, 176, 157, 160}, {9, 177, 156, 160}, {9, 178, 157, 160},
    {9, 180, 153, 158}, {9, 181, 154, 160}, {9, 182, 154, 160}, {9, 183, 156, 159},
    {10, 173, 150, 151}, {10, 174, 149, 152}, {10, 175, 149, 152}, {10, 176, 149, 152},
    {10, 177, 149, 152}, {10, 174, 157, 159}, {10, 175, 156, 160}, {10, 176, 156, 160},
    {10, 177, 157, 160}, {10, 179, 154, 156}, {10, 180, 153, 158}, {10, 181, 154, 159},
    {10, 182, 155, 158}, {11, 173, 149, 151}, {11, 174, 149, 152}, {11, 175, 148, 152},
    {11, 176, 149, 151}, {11, 174, 157, 159}, {11, 175, 156, 160}, {11, 176, 157, 160},
    {11, 177, 157, 159}, {11, 179, 154, 158}, {11, 180, 154, 158}, {11, 181, 154, 158},
    {11, 182, 154, 158}, {12, 174, 149, 151}, {12, 175, 149, 151}, {12, 174, 157, 159},
    {12, 175, 157, 159}, {12, 176, 157, 158}, {12, 178, 155, 157}, {12, 179, 154, 157},
    {12, 180, 154, 157}, {12, 181, 155, 157}, {13, 178, 155, 157}, {13, 179, 154, 157},
    {13, 180, 154, 157}};

std::vector<std::uint8_t> molar(const glm::ivec3& size)
{
    std::vector<std::uint8_t> mask(
        std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), 0);
    for (const auto& [slice, row, from, to] : molarRuns)
        std::fill_n(
            mask.begin() + (slice * size.y + row) * size.x + from, to - from + 1, std::uint8_t(1));
    return mask;
}

/// A label map on the study's grid, as codes that are its values.
std::vector<std::uint8_t> labelsIn(const QString& path)
{
    const LoadedVolume map = openVolume(path);
    std::vector<std::uint8_t> labels;
    labels.reserve(map.codes.size());
    for (const std::uint16_t code : map.codes)
        labels.push_back(std::uint8_t(std::lround(map.volume.encoding.value(code))));
    return labels;
}

/// Puts edits together as a user would do them, one after the other.
class Story {
public:
    explicit Story(RealGrowth& growth)
        : m_growth(growth)
    {
        growth.edits.emplace_back(test::newSegment(QStringLiteral("Segment"), 0xE06050));
    }
    void seed(const std::vector<glm::ivec3>& corners)
    {
        const std::vector<glm::ivec3> voxels = strokeVoxels(corners);
        m_growth.seeds.insert(m_growth.seeds.end(), voxels.begin(), voxels.end());
        m_growth.edits.emplace_back(test::seedAt(1, places(voxels)));
    }
    void grow(const GrowCriteria& criteria) { m_growth.edits.push_back(test::growBy(criteria)); }
    void shrinkAt(const std::vector<glm::ivec3>& corners)
    {
        m_growth.edits.emplace_back(ShrinkAt{.pointsLps = places(strokeVoxels(corners))});
    }
    /// All that lies behind the neck on the way to a voxel.
    void plug(const glm::ivec3& voxel)
    {
        m_growth.edits.emplace_back(PlugLeak{.pointLps = place(voxel)});
    }
    [[nodiscard]] glm::dvec3 place(const glm::ivec3& voxel) const
    {
        return places({voxel}).front();
    }

private:
    [[nodiscard]] std::vector<glm::dvec3> places(const std::vector<glm::ivec3>& voxels) const
    {
        return placesOf(m_growth.study.volume.geometry, voxels);
    }
    RealGrowth& m_growth;
};

/// Both lateral ventricles on one slice; what runs on through the third ventricle into the cisterns
/// is taken back by a plug there.
void takeVentricles(RealGrowth& growth)
{
    Story story(growth);
    story.seed({{34, 25, 51}, {33, 45, 51}});
    story.seed({{48, 25, 51}, {48, 45, 51}});
    story.grow({.lower = 0.0, .upper = 38.0, .majority = 14});
    story.plug({39, 57, 37});
}

/// Along the aorta and along its false lumen, each on a sagittal slice; the left heart goes by a
/// plug below the valve, the right heart by one in its ventricle.
void takeAorta(RealGrowth& growth)
{
    Story story(growth);
    story.seed(
        {{60, 46, 90}, {60, 44, 107}, {60, 55, 129}, {60, 72, 140}, {60, 88, 125}, {60, 97, 99}});
    story.seed(
        {{64, 78, 148}, {64, 95, 138}, {64, 104, 120}, {64, 107, 95}, {64, 104, 70}, {64, 91, 58}});
    story.grow({.lower = 200.0, .upper = 600.0, .majority = 14});
    story.plug({60, 58, 74});
    story.plug({60, 22, 63});
}

/// Once across; a box keeps growth from the spleen and the legs, a sketch takes the stomach back.
void takeLiver(RealGrowth& growth)
{
    Story story(growth);
    story.seed({{95, 45, 104}, {75, 78, 104}});
    const glm::ivec3 last = growth.study.volume.geometry.size - 1;
    story.grow({.lower = 10.0,
        .upper = 90.0,
        .majority = 24,
        .box = GrowBox{.fromLps = story.place({35, 0, 68}), .toLps = story.place(last)}});
    story.shrinkAt({{40, 50, 103}, {40, 60, 103}});
}

/// Down the crown; the jaw goes by a sketch on the bone beside the roots.
void takeTooth(RealGrowth& growth)
{
    Story story(growth);
    story.seed({{160, 178, 1}, {160, 178, 7}});
    story.grow({.lower = 900.0, .upper = 3071.0});
    story.shrinkAt({{162, 178, 14}, {162, 185, 14}});
}

} // namespace

std::optional<RealGrowth> realGrowth(RealStructure structure)
{
    constexpr std::array<const char*, 4> names{"mr_brain_mricrop_itksnap", "ct_totalseg_body_3mm",
        "ct_totalseg_body_3mm", "ct_cranium_inv3"};
    const SharedCase found = sharedCase(QString::fromLatin1(names[std::size_t(structure)]));
    if (found.source.isEmpty())
        return std::nullopt;
    const auto file = [&found](const char* name) {
        return found.source + QLatin1Char('/') + QLatin1String(name);
    };
    RealGrowth growth;
    switch (structure) {
    case RealStructure::Ventricles:
        growth.study = openVolume(file("mri.nii.gz"));
        growth.reference = maskOf(labelsIn(file("labels.nii.gz")), 1);
        takeVentricles(growth);
        break;
    case RealStructure::Aorta:
        growth.study = openVolume(file("aorta/ct.nii.gz"));
        growth.reference = maskOf(labelsIn(file("aorta/aorta.nii.gz")), 1);
        takeAorta(growth);
        break;
    case RealStructure::Liver:
        growth.study = openVolume(file("ct_3mm.nii.gz"));
        growth.reference = maskOf(labelsIn(file("ct_3mm_labels.nii.gz")), 5);
        takeLiver(growth);
        break;
    case RealStructure::Tooth:
        growth.study = openVolume(found.unpacked);
        growth.reference = molar(growth.study.volume.geometry.size);
        takeTooth(growth);
        break;
    }
    return growth;
}

std::optional<RealSketch> realSketch(SketchedStructure structure)
{
    using Stroke = std::vector<glm::ivec3>;
    const auto sketched = [](RealStructure known,
                              const std::vector<Stroke>& strokes) -> std::optional<RealSketch> {
        std::optional<RealGrowth> growth = realGrowth(known);
        if (!growth)
            return std::nullopt;
        RealSketch sketch{.study = std::move(growth->study),
            .reference = std::move(growth->reference),
            .sketch = {}};
        for (const Stroke& corners : strokes) {
            const Stroke voxels = strokeVoxels(corners);
            sketch.sketch.voxels.insert(sketch.sketch.voxels.end(), voxels.begin(), voxels.end());
        }
        return sketch;
    };
    const auto file = [](const char* name, const char* path) {
        return sharedCase(QString::fromLatin1(name)).source + QLatin1String(path);
    };
    std::optional<RealSketch> sketch;
    switch (structure) {
    case SketchedStructure::Ventricles:
        return sketched(RealStructure::Ventricles,
            {{{34, 25, 51}, {33, 45, 51}}, {{48, 25, 51}, {48, 45, 51}}});
    case SketchedStructure::Aorta:
        return sketched(RealStructure::Aorta,
            {{{60, 46, 90}, {60, 44, 107}, {60, 55, 129}, {60, 72, 140}, {60, 88, 125},
                {60, 97, 99}}});
    case SketchedStructure::Liver:
        return sketched(RealStructure::Liver, {{{95, 45, 104}, {75, 78, 104}}});
    case SketchedStructure::Tooth:
        return sketched(RealStructure::Tooth, {{{160, 178, 1}, {160, 178, 7}}});
    case SketchedStructure::Lung:
        sketch = sketched(RealStructure::Liver, {{{74, 27, 109}, {87, 27, 108}}});
        if (sketch)
            sketch->reference =
                maskOf(labelsIn(file("ct_totalseg_body_3mm", "/ct_3mm_labels.nii.gz")), 14);
        return sketch;
    case SketchedStructure::Bone:
        sketch = sketched(RealStructure::Tooth, {});
        if (!sketch)
            return sketch;
        sketch->reference =
            maskOf(labelsIn(file("ct_cranium_inv3", "/mask_bone_226_3071.nii.gz")), 1);
        break;
    }
    const LoadedVolume& study = sketch->study;
    const glm::ivec3 size = study.volume.geometry.size;
    for (int x = 100; x <= 156; ++x) {
        const std::size_t row = (std::size_t(70) * std::size_t(size.y)) * std::size_t(size.x);
        for (int y = 0; y < size.y; ++y) {
            const std::size_t place = row + std::size_t(y) * std::size_t(size.x) + std::size_t(x);
            if (study.volume.encoding.value(study.codes[place]) < 300.0)
                continue;
            sketch->sketch.voxels.emplace_back(x, y, 70);
            break;
        }
    }
    sketch->sketch.inward = glm::dvec3(0.0, 1.0, 0.0);
    return sketch;
}

std::vector<glm::ivec3> strokeVoxels(const std::vector<glm::ivec3>& corners)
{
    std::vector<glm::ivec3> voxels{corners.front()};
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const glm::dvec3 from(corners[i - 1]);
        const glm::dvec3 way = glm::dvec3(corners[i]) - from;
        const int steps = int(std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)}));
        for (int step = 1; step <= steps; ++step)
            voxels.emplace_back(glm::round(from + way * (double(step) / steps)));
    }
    return voxels;
}

std::vector<glm::dvec3> placesOf(
    const VolumeGeometry& geometry, const std::vector<glm::ivec3>& voxels)
{
    std::vector<glm::dvec3> places;
    for (const glm::ivec3& voxel : voxels)
        places.push_back(geometry.toWorld(glm::dvec3(voxel)));
    return places;
}

int userActions(const Edit& edit, const VolumeGeometry& geometry)
{
    if (!edit.is<GrowSteps>())
        return 1;
    const GrowCriteria& criteria = *growCriteriaOf(edit);
    int actions = 2 // the interval, the button
        + (criteria.connectivity != 6) + criteria.sigmas.has_value()
        + criteria.difference.has_value() + criteria.gradient.has_value()
        + criteria.gradientDifference.has_value() + criteria.majority.has_value()
        + criteria.onlyVisible + criteria.overwriteUnlocked + growGuardOf(edit)->factor.has_value();
    if (criteria.box) {
        const glm::ivec3 from(glm::round(geometry.toIndex(criteria.box->fromLps)));
        const glm::ivec3 to(glm::round(geometry.toIndex(criteria.box->toLps)));
        const glm::ivec3 low = glm::min(from, to);
        const glm::ivec3 high = glm::max(from, to);
        ++actions;
        for (int axis = 0; axis < 3; ++axis)
            actions += (low[axis] != 0) + (high[axis] != geometry.size[axis] - 1);
    }
    return actions;
}

double dice(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b)
{
    std::size_t both = 0;
    std::size_t sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        both += a[i] != 0 && b[i] != 0 ? 1 : 0;
        sum += std::size_t(a[i] != 0) + std::size_t(b[i] != 0);
    }
    return sum == 0 ? 0.0 : 2.0 * double(both) / double(sum);
}

std::vector<std::uint8_t> maskOf(const std::vector<std::uint8_t>& labels, std::uint8_t label)
{
    std::vector<std::uint8_t> mask(labels.size());
    std::transform(labels.begin(), labels.end(), mask.begin(),
        [label](std::uint8_t held) { return std::uint8_t(held == label ? 1 : 0); });
    return mask;
}

} // namespace test
