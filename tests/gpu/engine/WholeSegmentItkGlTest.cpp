// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "core/volume/VolumeGeometry.h"
#include "tests/peers/cases/ComparedSegments.h"
#include "tests/peers/cases/OneRealSegment.h"
#include "tests/peers/cases/WholeSegments.h"
#include "tests/reference/filling/BetweenSlices.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

namespace wholeSegmentItkGlTest {

using peer::RealSegment;

/// What the operations on a whole segment make of real series is what ITK's filters make of them,
/// voxel for voxel; where voxels may differ, a case says which and why. What lies between slices,
/// for which Debian's ITK has no filter, is what the oracle finds there, too. With BURIN_LONG=1 of
/// whole series, else of the voxels around their middle.
class WholeSegmentItkGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY2(m_gpu.isReady(), m_gpu.why()); }
    void init() { test::failOnUnexpectedMessages(); }
    void cleanup() { QCOMPARE(m_gpu.newErrors(), 0); }
    void cleanupTestCase() { m_segment.close(); }

    void equalsItk_data();
    void equalsItk();
    void betweenSlices_data();
    void betweenSlices();

private:
    test::EditEngineFixture m_gpu;
    peer::OneRealSegment m_segment;
};

void WholeSegmentItkGlTest::equalsItk_data()
{
    QTest::addColumn<int>("series");
    QTest::addColumn<int>("operation");
    for (std::size_t series = 0; series < peer::realSeries().size(); ++series) {
        for (std::size_t at = 0; at < peer::wholeSegments().size(); ++at)
            QTest::addRow(
                "%s: %s", peer::realSeries().at(series).name, peer::wholeSegments()[at].name)
                << int(series) << int(at);
    }
}

void WholeSegmentItkGlTest::equalsItk()
{
    QFETCH(const int, series);
    QFETCH(const int, operation);
    RealSegment* segment = m_segment.of(m_gpu.engine(), std::size_t(series));
    if (!segment)
        QSKIP("the shared test data are not there (BURIN_SHARED_DATA)");
    const peer::WholeSegment& tried = peer::wholeSegments()[std::size_t(operation)];
    const core::Result<peer::Compared> compared = peer::compare(*segment, tried);
    QVERIFY2(compared,
        compared ? "" : qPrintable(compared.error().arguments.join(QStringLiteral(", "))));
    qInfo("%lld voxels, %lld changed, %lld differ from %s", qlonglong(compared->voxels),
        qlonglong(compared->changed), qlonglong(compared->differing), tried.peer);
    if (compared->either > 0)
        qInfo("of %lld voxels either is right: %s", qlonglong(compared->either), tried.whyEither);
    QVERIFY2(compared->changed > 0, "nothing was done");
    QCOMPARE(compared->unexplained, 0);
    // How long both took is no test's to judge; packaging/bench.sh measures it.
    const double ours = compared->workedOutMilliseconds.value_or(compared->stepMilliseconds);
    qInfo("%.2f ms (%s), %s %.2f ms: %.2f times as fast", ours,
        compared->workedOutMilliseconds ? "worked out" : "the whole step", tried.peer,
        compared->theirMilliseconds, compared->theirMilliseconds / ours);
}

void WholeSegmentItkGlTest::betweenSlices_data()
{
    QTest::addColumn<int>("series");
    for (std::size_t series = 0; series < peer::realSeries().size(); ++series)
        QTest::newRow(peer::realSeries().at(series).name) << int(series);
}

void WholeSegmentItkGlTest::betweenSlices()
{
    QFETCH(const int, series);
    RealSegment* segment = m_segment.of(m_gpu.engine(), std::size_t(series));
    if (!segment)
        QSKIP("the shared test data are not there (BURIN_SHARED_DATA)");
    // Noise and all: many parts in every slice.
    const auto& thresholded = segment->labels(RealSegment::State::Thresholded);
    for (const auto state : {RealSegment::State::Thresholded, RealSegment::State::Drawn}) {
        QVERIFY(segment->goTo(state));
        if (state == RealSegment::State::Thresholded)
            QVERIFY(segment->leaveDrawnSlices());
        const auto before = segment->session().questions().labels(0);
        QVERIFY(segment->session().apply(
            core::FillBetweenSlices{.segment = RealSegment::label, .axis = core::SliceAxis::K}));
        QVERIFY(segment->session().settle());
        const auto after = segment->session().questions().labels(0);
        QVERIFY(before && after && *before != *after && *before != thresholded);
        const std::vector<bool> between = reference::voxelsBetween(
            *before, segment->geometry(), RealSegment::label, core::SliceAxis::K);
        std::int64_t differing = 0;
        for (std::size_t voxel = 0; voxel < before->size(); ++voxel) {
            const bool expected = (*before)[voxel] == RealSegment::label || between[voxel];
            differing += ((*after)[voxel] == RealSegment::label) != expected ? 1 : 0;
        }
        QCOMPARE(differing, 0);
    }
}

BURIN_TEST(WholeSegmentItkGlTest)

} // namespace wholeSegmentItkGlTest

#include "WholeSegmentItkGlTest.moc"
