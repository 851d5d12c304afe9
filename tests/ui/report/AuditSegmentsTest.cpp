// SPDX-License-Identifier: Apache-2.0
#include "ui/report/AuditSegments.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "ui/report/AuditTexts.h"

#include <QTest>

#include <algorithm>
#include <vector>

namespace auditSegmentsTest {

using namespace core;

namespace {

constexpr int side = 12;

std::size_t at(int x, int y, int z)
{
    return std::size_t((z * side + y) * side + x);
}

/// A cube of 4³ voxels in the middle of a volume of 10 x 10 x 10 mm a voxel, 1 mL each.
VoxelRuns cube()
{
    VoxelRuns runs;
    for (int z = 4; z < 8; ++z) {
        for (int y = 4; y < 8; ++y)
            runs.append(at(4, y, z), 4);
    }
    return runs;
}

struct Study {
    Study()
        : codes(std::size_t(side) * side * side, 1)
        , labels(codes.size(), 0)
    {
        volume.geometry.size = glm::ivec3(side);
        for (int axis = 0; axis < 3; ++axis)
            volume.geometry.indexToWorld[axis][axis] = 10.0;
        volume.defaultWindow = {.centre = 0.0, .width = 2.0};
    }
    void fill(std::uint8_t label)
    {
        const VoxelRuns voxels = cube();
        for (const VoxelRun& run : voxels.runs())
            std::fill_n(labels.begin() + std::ptrdiff_t(run.first), run.count, label);
    }
    /// @param imported labels of segments that were imported as the cube
    [[nodiscard]] ui::AuditSegments audited(
        int segments, const std::vector<std::uint8_t>& imported) const
    {
        ExportRequest request;
        for (int label = 1; label <= segments; ++label) {
            Segment& segment = request.segments.emplace_back();
            segment.label = std::uint8_t(label);
            segment.name = QStringLiteral("S%1").arg(label);
        }
        request.planes = {{.plane = 0, .labels = labels}};
        request.codes = codes;
        for (const std::uint8_t label : imported)
            request.imported.push_back({.label = label, .voxels = cube()});
        const auto audited = ui::auditSegments(volume, request, Progress());
        if (!audited)
            qFatal("%s", qPrintable(audited.error().arguments.join(u' ')));
        return *audited;
    }

    Volume volume;
    std::vector<std::uint16_t> codes;
    std::vector<std::uint8_t> labels;
};

} // namespace

class AuditSegmentsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// That it was imported, and that all of it was taken, is told nevertheless.
    void anImportedOneThatWasErased()
    {
        Study study;
        study.fill(3);
        const ui::AuditSegments audited = study.audited(3, {1});
        QCOMPARE(audited.segments.size(), std::size_t(3));
        const auto texts = ui::AuditTexts::of({}, &audited);
        QCOMPARE(texts.segments.size(), std::size_t(3));
        QCOMPARE(texts.segments[0].name, QStringLiteral("S3"));
        QVERIFY(texts.segments[0].size.contains(QStringLiteral("64 voxels")));
        QVERIFY(texts.segments[0].change.isEmpty());
        QCOMPARE(texts.segments[1].name, QStringLiteral("S1"));
        QCOMPARE(texts.segments[1].size, QStringLiteral("no voxel"));
        QCOMPARE(texts.segments[1].change,
            QStringLiteral("imported; 0.00 mL added and 64.0 mL taken since, Dice 0.000"));
        QCOMPARE(texts.segments[2].name, QStringLiteral("S2"));
        QCOMPARE(texts.segments[2].size, QStringLiteral("no voxel"));
        QVERIFY(texts.segments[2].change.isEmpty());
        QCOMPARE(texts.changes.size(), std::size_t(1));
        QVERIFY(!texts.changes.front().png.isEmpty());
        QCOMPARE(audited.segments[1].slice, 4);
    }

    void allThatIsThereWasErased()
    {
        const ui::AuditSegments audited = Study().audited(1, {1});
        const auto texts = ui::AuditTexts::of({}, &audited);
        QCOMPARE(texts.segments.size(), std::size_t(1));
        QCOMPARE(texts.segments.front().size, QStringLiteral("no voxel"));
        QVERIFY(texts.segments.front().change.contains(QStringLiteral("64.0 mL taken")));
        QCOMPARE(texts.changes.size(), std::size_t(1));
    }

    /// Where the study does not say how large its voxels are, nobody has measured millilitres.
    void voxelsOfUnknownSizeAreCounted()
    {
        Study study;
        study.fill(1);
        study.volume.problems.push_back(
            {.kind = VolumeProblem::Kind::AssumedSpacing, .said = {ProblemCode::SpacingAssumed}});
        const ui::AuditSegments audited = study.audited(2, {1, 2});
        const auto texts = ui::AuditTexts::of({}, &audited);
        QCOMPARE(texts.segments.size(), std::size_t(2));
        QCOMPARE(texts.segments[0].size, QStringLiteral("64 voxels"));
        QCOMPARE(texts.segments[0].change, QStringLiteral("imported; Dice 1.000 with what it was"));
        QCOMPARE(texts.segments[1].size, QStringLiteral("no voxel"));
        QCOMPARE(texts.segments[1].change, QStringLiteral("imported; Dice 0.000 with what it was"));
    }

    void nothingIsThere()
    {
        const ui::AuditSegments audited = Study().audited(0, {});
        QVERIFY(audited.segments.empty());
    }
};

BURIN_TEST(AuditSegmentsTest)

} // namespace auditSegmentsTest

#include "AuditSegmentsTest.moc"
