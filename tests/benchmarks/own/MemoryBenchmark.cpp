// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/own/MemoryBenchmark.h"

#include "core/volume/Volume.h"
#include "gpu/engine/GpuEngine.h"
#include "tests/benchmarks/common/PeerReport.h"
#include "tests/benchmarks/own/SessionDriver.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/base/ErrorText.h"

#include <QTemporaryDir>

#include <array>
#include <cstdint>
#include <cstdio>

namespace bench {

namespace {

constexpr int side = 512;
constexpr int segments = 20;
constexpr double radiusMm = 24.0;

core::LoadedVolume block()
{
    core::LoadedVolume made;
    made.volume.geometry.size = glm::ivec3(side);
    made.volume.encoding.rescaleIntercept = -1024.0;
    made.volume.voxelsSha256 = QByteArray(64, '1');
    made.codes.resize(made.volume.geometry.voxelCount());
    // Not all alike, as no study is.
    std::uint32_t state = 1;
    for (std::uint16_t& code : made.codes) {
        state = state * 1664525u + 1013904223u;
        code = std::uint16_t(1000 + (state >> 24));
    }
    return made;
}

/// In five columns and four rows, with room between.
glm::dvec3 middleOf(int segment)
{
    return {60.0 + 90.0 * (segment % 5), 60.0 + 110.0 * (segment / 5), side / 2.0};
}

} // namespace

QString measureMemory(PeerReport& report)
{
    std::fprintf(stderr, "memory: %d segments in %d cubed\n", segments, side);
    const QTemporaryDir folder;
    const qint64 begun = residentBytes();
    const auto engine = gpu::GpuEngine::create();
    if (!engine)
        return ui::errorText(engine.error());
    const auto driver = SessionDriver::create(
        (*engine)->edits(), block(), folder.filePath(QStringLiteral("memory.burin")));
    if (!driver)
        return QStringLiteral("memory: no session");
    for (int segment = 0; segment < segments; ++segment) {
        driver->apply(test::newSegment(QStringLiteral("Segment %1").arg(segment + 1)));
        driver->apply(test::paintAt(segment + 1, {middleOf(segment)}, radiusMm));
    }
    driver->settle();
    const qint64 taken = residentBytes() - begun;
    if (const QString problem = driver->problem(); !problem.isEmpty())
        return QStringLiteral("memory: ") + problem;
    std::array<std::int64_t, segments + 1> voxels{};
    for (const std::uint8_t label : driver->dense(core::Field::Labels, 0)) {
        if (label <= segments)
            ++voxels[label];
    }
    for (int segment = 1; segment <= segments; ++segment) {
        if (voxels[std::size_t(segment)] < 50'000)
            return QStringLiteral("memory: segment %1 has %2 voxels")
                .arg(segment)
                .arg(qlonglong(voxels[std::size_t(segment)]));
    }
    const double voxelBytes = double(side) * side * side * sizeof(std::uint16_t);
    report.add({"memory.segments", "Bytes", double(taken), "3 times the voxels", 3.0 * voxelBytes});
    return {};
}

} // namespace bench
