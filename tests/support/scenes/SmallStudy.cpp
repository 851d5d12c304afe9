// SPDX-License-Identifier: Apache-2.0
#include "tests/support/scenes/SmallStudy.h"

#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"

namespace test {

namespace {

const glm::ivec3 smallSize(40, 36, 34);
const glm::dvec3 spacing(1.0, 1.0, 1.5);
const glm::dvec3 origin(-20.0, -18.0, 100.0);
const glm::dvec3 middle = origin + spacing * (glm::dvec3(smallSize) - 1.0) / 2.0;

} // namespace

core::LoadedVolume smallStudy()
{
    core::LoadedVolume loaded;
    core::Volume& volume = loaded.volume;
    volume.geometry.size = smallSize;
    volume.geometry.indexToWorld = glm::dmat4(glm::dvec4(spacing.x, 0, 0, 0),
        glm::dvec4(0, spacing.y, 0, 0), glm::dvec4(0, 0, spacing.z, 0), glm::dvec4(origin, 1));
    volume.encoding = {.rescaleSlope = 1.0, .rescaleIntercept = -1024.0};
    volume.unit = QStringLiteral("HU");
    volume.minimum = -1000;
    volume.maximum = 1000;
    volume.identity.seriesUid = QStringLiteral("1.2.3.4");
    volume.identity.modality = QStringLiteral("CT");
    volume.sourcePath = QStringLiteral("/nowhere/small");
    volume.voxelsSha256 = QByteArray(64, 'a');
    for (int k = 0; k < smallSize.z; ++k) {
        for (int j = 0; j < smallSize.y; ++j) {
            for (int i = 0; i < smallSize.x; ++i) {
                const double radius = glm::length(volume.geometry.toWorld({i, j, k}) - middle);
                const int value = radius < 11 ? 40 : (radius < 15 ? 1000 : -1000);
                loaded.codes.push_back(std::uint16_t(value + 1024));
            }
        }
    }
    return loaded;
}

const core::VolumeGeometry& smallGrid()
{
    static const core::VolumeGeometry grid = smallStudy().volume.geometry;
    return grid;
}

std::size_t smallIndexOf(const glm::ivec3& voxel)
{
    const glm::ivec3& size = smallGrid().size;
    return (std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y)) * std::size_t(size.x)
        + std::size_t(voxel.x);
}

std::vector<glm::dvec3> pointsInBrain()
{
    return {middle, middle + glm::dvec3(2, 0, 0)};
}

std::vector<glm::dvec3> pointsInBone()
{
    return {middle + glm::dvec3(0, -13, 0)};
}

core::OrthographicView frontView()
{
    return {.eyeLps = middle - glm::dvec3(0, 200, 0),
        .targetLps = middle,
        .up = {0, 0, 1},
        .heightMm = 80};
}

core::Edit addSegment(const char* name)
{
    return newSegment(QLatin1String(name), 0xE0C068);
}

core::Edit seedInBrain(int segment)
{
    return seedAt(segment, pointsInBrain());
}

core::Edit seedInBone(int segment)
{
    return seedAt(segment, pointsInBone());
}

core::Edit growBrain(std::optional<int> steps)
{
    return growBetween(0, 100, steps);
}

core::Edit growBone(std::optional<int> steps)
{
    return growBetween(500, 2000, steps);
}

core::Edit drillAt(double xMm)
{
    return drillWith({.view = frontView(),
        .radiusMm = 4.0,
        .depthMm = 5.0,
        .surfaceThreshold = 500.0,
        .samples =
            std::vector<core::PenSample>{{.xMm = xMm, .yMm = 0.3, .pressure = 0.7, .tSeconds = 0.0},
                {.xMm = xMm + 3.21, .yMm = 1.7, .pressure = 1.0, .tSeconds = 0.1}}});
}

std::vector<core::Edit> manyEdits()
{
    return {addSegment("Brain"), addSegment("Skull"), seedInBrain(1), growBrain(3), drillAt(-6),
        renameSegment(2, QStringLiteral("Bone")), growBrain(), drillAt(5), seedInBone(2),
        growBone(), revertRows({8})};
}

} // namespace test
