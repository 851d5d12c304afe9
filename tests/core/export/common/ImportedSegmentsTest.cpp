// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/ImportedSegments.h"

#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace importedSegmentsTest {

using core::ImportMask;
using core::VoxelRuns;

namespace {

VoxelRuns runsAt(std::uint64_t first, std::uint64_t count)
{
    VoxelRuns runs;
    runs.append(first, count);
    return runs;
}

core::ImportedSegment segmentOf(const char* name, const VoxelRuns& runs)
{
    return {.name = QLatin1String(name), .rgb = 0, .code = {}, .voxels = core::packedRuns(runs)};
}

ImportMask maskOf(std::vector<core::ImportedSegment> segments)
{
    ImportMask mask;
    mask.segments = std::move(segments);
    return mask;
}

std::vector<core::Segment> segmentsOf(const std::vector<const char*>& names)
{
    std::vector<core::Segment> segments;
    for (const char* name : names) {
        core::Segment segment;
        segment.label = std::uint8_t(segments.size() + 1);
        segment.name = QLatin1String(name);
        segments.push_back(segment);
    }
    return segments;
}

} // namespace

/// Which imported voxels a segment is compared with.
class ImportedSegmentsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void byName()
    {
        const auto found = core::importedAs(segmentsOf({"Own", "Liver", "Spleen"}),
            {maskOf({segmentOf("Spleen", runsAt(5, 3)), segmentOf("Liver", runsAt(20, 4)),
                segmentOf("Gone", runsAt(40, 1))})},
            100);
        QCOMPARE(found.size(), std::size_t(2));
        QCOMPARE(found[0].label, std::uint8_t(2));
        QVERIFY(found[0].voxels == runsAt(20, 4));
        QCOMPARE(found[1].label, std::uint8_t(3));
        QVERIFY(found[1].voxels == runsAt(5, 3));
    }

    void theNewerImportStands()
    {
        const auto found = core::importedAs(segmentsOf({"Liver"}),
            {maskOf({segmentOf("Liver", runsAt(1, 2))}),
                maskOf({segmentOf("Liver", runsAt(7, 2))})},
            100);
        QCOMPARE(found.size(), std::size_t(1));
        QVERIFY(found[0].voxels == runsAt(7, 2));
    }

    /// All of a file in one segment that was there.
    void takenIntoOneSegment()
    {
        ImportMask mask = maskOf({segmentOf("a", runsAt(1, 2)), segmentOf("b", runsAt(9, 3))});
        mask.as = core::SegmentWord{.number = 2, .name = {}};
        const auto found = core::importedAs(segmentsOf({"First", "Second"}), {mask}, 100);
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found[0].label, std::uint8_t(2));
        QVERIFY(found[0].voxels == core::united(runsAt(1, 2), runsAt(9, 3)));
    }

    void nothingWasImported()
    {
        QVERIFY(core::importedAs(segmentsOf({"Liver"}), {}, 100).empty());
        // Voxels that are not in the volume cannot be unpacked.
        QVERIFY(core::importedAs(
            segmentsOf({"Liver"}), {maskOf({segmentOf("Liver", runsAt(99, 5))})}, 100)
                    .empty());
    }
};

BURIN_TEST(ImportedSegmentsTest)

} // namespace importedSegmentsTest

#include "ImportedSegmentsTest.moc"
