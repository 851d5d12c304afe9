// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/ImportedSegments.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/session/past/PastImports.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"

#include <QTest>

#include <utility>

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
    mask.size = glm::ivec3(100, 1, 1);
    mask.segments = std::move(segments);
    return mask;
}

/// The segments and the imports that these steps lead to.
struct Steps {
    explicit Steps(const std::vector<core::Edit>& edits)
    {
        for (const core::Edit& edit : edits) {
            core::HistoryRow row;
            row.edit = edit;
            history.append(std::move(row));
            isApplied = core::applyToDocument(edit, document).has_value() && isApplied;
        }
    }
    [[nodiscard]] std::vector<core::ImportedVoxels> imported() const
    {
        return core::importedAs(document.segments, core::doneImports(history), 100);
    }

    core::History history;
    core::Document document = core::initialDocument({});
    bool isApplied = true;
};

core::Edit drawn(const char* name)
{
    return test::newSegment(QLatin1String(name));
}

} // namespace

/// Which imported voxels a segment is compared with.
class ImportedSegmentsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void ofEachSegmentItsOwn()
    {
        const Steps steps({drawn("Own"),
            maskOf({segmentOf("Spleen", runsAt(5, 3)), segmentOf("Liver", runsAt(20, 4))})});
        QVERIFY(steps.isApplied);
        const auto found = steps.imported();
        QCOMPARE(found.size(), std::size_t(2));
        QCOMPARE(found[0].label, std::uint8_t(2));
        QVERIFY(found[0].voxels == runsAt(5, 3));
        QCOMPARE(found[1].label, std::uint8_t(3));
        QVERIFY(found[1].voxels == runsAt(20, 4));
    }

    /// Names are not unique, in a file or among several.
    void twoOfOneName()
    {
        const Steps steps(
            {maskOf({segmentOf("Liver", runsAt(1, 2)), segmentOf("Liver", runsAt(30, 5))}),
                maskOf({segmentOf("Liver", runsAt(7, 2))})});
        QVERIFY(steps.isApplied);
        const auto found = steps.imported();
        QCOMPARE(found.size(), std::size_t(3));
        QVERIFY(found[0].voxels == runsAt(1, 2));
        QVERIFY(found[1].voxels == runsAt(30, 5));
        QVERIFY(found[2].voxels == runsAt(7, 2));
        QCOMPARE(found[2].label, std::uint8_t(3));
    }

    /// What was drawn was not imported, whatever its name.
    void drawnInItsPlace()
    {
        const Steps steps({maskOf({segmentOf("Liver", runsAt(1, 2))}),
            core::RemoveSegment{.segment = 1}, drawn("Liver")});
        QVERIFY(steps.isApplied);
        QCOMPARE(steps.document.segments.size(), std::size_t(1));
        QVERIFY(steps.imported().empty());
    }

    void anotherNameChangesNothing()
    {
        const Steps steps({maskOf({segmentOf("1", runsAt(4, 2))}),
            test::renameSegment(1, QStringLiteral("Liver")), drawn("1")});
        QVERIFY(steps.isApplied);
        const auto found = steps.imported();
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found[0].label, std::uint8_t(1));
        QVERIFY(found[0].voxels == runsAt(4, 2));
    }

    /// All of a file in one segment that was there; the newer import stands.
    void takenIntoOneSegment()
    {
        ImportMask older = maskOf({segmentOf("c", runsAt(50, 6))});
        ImportMask newer = maskOf({segmentOf("a", runsAt(1, 2)), segmentOf("b", runsAt(9, 3))});
        older.as = newer.as = core::SegmentWord{.number = 2, .name = {}};
        const Steps steps({drawn("First"), drawn("Second"), older, newer});
        QVERIFY(steps.isApplied);
        const auto found = steps.imported();
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found[0].label, std::uint8_t(2));
        QVERIFY(found[0].voxels == core::united(runsAt(1, 2), runsAt(9, 3)));
    }

    void nothingWasImported()
    {
        QVERIFY(Steps({drawn("Liver")}).imported().empty());
        // Voxels that are not in the volume cannot be unpacked.
        QVERIFY(Steps({maskOf({segmentOf("Liver", runsAt(99, 5))})}).imported().empty());
    }
};

BURIN_TEST(ImportedSegmentsTest)

} // namespace importedSegmentsTest

#include "ImportedSegmentsTest.moc"
