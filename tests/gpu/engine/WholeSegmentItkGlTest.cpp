// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "core/volume/VolumeGeometry.h"
#include "tests/peers/cases/ComparedSegments.h"
#include "tests/peers/cases/WholeSegments.h"
#include "tests/reference/filling/BetweenSlices.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <memory>

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
    void cleanupTestCase() { m_segment.reset(); }

    void equalsItk_data();
    void equalsItk();
    void betweenSlices_data();
    void betweenSlices();

private:
    /// Opened once for all operations on it; null: it is not there.
    RealSegment* segmentOf(std::size_t series);

    test::EditEngineFixture m_gpu;
    std::unique_ptr<RealSegment> m_segment;
    std::size_t m_series = peer::realSeries().size();
};

RealSegment* WholeSegmentItkGlTest::segmentOf(std::size_t series)
{
    if (m_series == series)
        return m_segment.get();
    m_segment.reset(); // its session ends before another begins on the engine
    m_series = series;
    constexpr int side = 64;
    auto opened = RealSegment::open(
        m_gpu.engine(), peer::realSeries().at(series), test::longRun() ? 0 : side);
    if (!opened)
        qWarning("%s: %s", peer::realSeries().at(series).name,
            qPrintable(opened.error().arguments.join(QStringLiteral(", "))));
    else
        m_segment = *std::move(opened);
    return m_segment.get();
}

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
    RealSegment* segment = segmentOf(std::size_t(series));
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
    RealSegment* segment = segmentOf(std::size_t(series));
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
