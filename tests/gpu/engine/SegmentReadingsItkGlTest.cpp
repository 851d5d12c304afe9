// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "tests/peers/cases/OneRealSegment.h"
#include "tests/peers/cases/SegmentReadings.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

namespace segmentReadingsItkGlTest {

/// The volume masked by a segment of a real series, and the distances between its islands, are
/// those that ITK's filters find. With BURIN_LONG=1 of whole series, else of the voxels around
/// their middle.
class SegmentReadingsItkGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY2(m_gpu.isReady(), m_gpu.why()); }
    void init() { test::failOnUnexpectedMessages(); }
    void cleanup() { QCOMPARE(m_gpu.newErrors(), 0); }
    void cleanupTestCase() { m_segment.close(); }

    void maskedVolume_data() { everySeries(); }
    void maskedVolume();
    void distances_data() { everySeries(); }
    void distances();

private:
    static void everySeries();

    test::EditEngineFixture m_gpu;
    peer::OneRealSegment m_segment;
};

void SegmentReadingsItkGlTest::everySeries()
{
    QTest::addColumn<int>("series");
    for (std::size_t series = 0; series < peer::realSeries().size(); ++series)
        QTest::newRow(peer::realSeries().at(series).name) << int(series);
}

void SegmentReadingsItkGlTest::maskedVolume()
{
    QFETCH(const int, series);
    peer::RealSegment* segment = m_segment.of(m_gpu.engine(), std::size_t(series));
    if (!segment)
        QSKIP("the shared test data are not there (BURIN_SHARED_DATA)");
    const core::Result<peer::ComparedVolume> compared = peer::compareMaskedVolume(*segment);
    QVERIFY2(compared,
        compared ? "" : qPrintable(compared.error().arguments.join(QStringLiteral(", "))));
    qInfo("%lld voxels, %lld masked, %lld differ from %s", qlonglong(compared->voxels),
        qlonglong(compared->masked), qlonglong(compared->differing), compared->peer);
    QVERIFY2(compared->masked > 0 && compared->masked < compared->voxels, "nothing was done");
    QCOMPARE(compared->differing, 0);
    qInfo("%.2f ms (the whole step; exported and checked in %.2f ms), %s %.2f ms: %.2f times as "
          "fast",
        compared->stepMilliseconds, compared->exportMilliseconds, compared->peer,
        compared->theirMilliseconds, compared->theirMilliseconds / compared->stepMilliseconds);
}

void SegmentReadingsItkGlTest::distances()
{
    QFETCH(const int, series);
    const peer::RealSegment* segment = m_segment.of(m_gpu.engine(), std::size_t(series));
    if (!segment)
        QSKIP("the shared test data are not there (BURIN_SHARED_DATA)");
    const core::Result<peer::ComparedDistances> compared = peer::compareDistances(*segment);
    QVERIFY2(compared,
        compared ? "" : qPrintable(compared.error().arguments.join(QStringLiteral(", "))));
    qInfo("%d pairs of islands, up to %.3f mm apart, %d differ from %s", compared->pairs,
        compared->greatestMm, compared->differing, compared->peer);
    QVERIFY2(compared->greatestMm > 0.0, "no islands that are apart");
    QCOMPARE(compared->differing, 0);
    qInfo("%.2f ms, %s %.2f ms: %.2f times as fast", compared->ourMilliseconds, compared->peer,
        compared->theirMilliseconds, compared->theirMilliseconds / compared->ourMilliseconds);
}

BURIN_TEST(SegmentReadingsItkGlTest)

} // namespace segmentReadingsItkGlTest

#include "SegmentReadingsItkGlTest.moc"
