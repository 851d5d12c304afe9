// SPDX-License-Identifier: Apache-2.0
#include "core/session/questions/SegmentsAt.h"

#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace segmentsAtTest {

using namespace core;

namespace {

/// Liver in plane 0, Tumour in plane 1, Vessel in plane 3.
Document overlapping()
{
    Document document;
    document.segments.push_back({.label = 4, .plane = 0, .name = QStringLiteral("Liver")});
    document.segments.push_back({.label = 5, .plane = 1, .name = QStringLiteral("Tumour")});
    document.segments.push_back({.label = 9, .plane = 3, .name = QStringLiteral("Vessel")});
    return document;
}

int labelOf(const Segment* segment)
{
    return segment ? int(segment->label) : 0;
}

} // namespace

class SegmentsAtTest : public QObject {
    Q_OBJECT

    const ProbedVoxel m_all{.label = 4, .labels = {4, 5, 0, 9}};
    const ProbedVoxel m_two{.label = 4, .labels = {4, 5, 0, 0}};
    const ProbedVoxel m_none{};

private Q_SLOTS:
    void allOfThemFromBelow()
    {
        const Document document = overlapping();
        QStringList names;
        for (const Segment* segment : segmentsAt(document, m_all))
            names += segment->name;
        QCOMPARE(names.join(QStringLiteral(", ")), QStringLiteral("Liver, Tumour, Vessel"));
        QVERIFY(segmentsAt(document, m_none).empty());
        // A label without a segment, as after a removal that is still under way.
        const ProbedVoxel gone{.labels = {0, 6, 0, 9}};
        QCOMPARE(segmentsAt(document, gone).size(), std::size_t(1));
    }

    void theActiveOneElseTheHighestThatIsShown()
    {
        Document document = overlapping();
        QCOMPARE(labelOf(segmentMeant(document, m_all, 4)), 4);
        QCOMPARE(labelOf(segmentMeant(document, m_all, 5)), 5);
        QCOMPARE(labelOf(segmentMeant(document, m_all, 0)), 9);
        QCOMPARE(labelOf(segmentMeant(document, m_two, 9)), 5); // the active one is elsewhere
        QCOMPARE(labelOf(segmentMeant(document, m_none, 4)), 0);
        document.segment(9)->visible = false;
        QCOMPARE(labelOf(segmentMeant(document, m_all, 0)), 5);
        QCOMPARE(labelOf(segmentMeant(document, m_all, 9)), 9);
        document.segment(4)->visible = document.segment(5)->visible = false;
        QCOMPARE(labelOf(segmentMeant(document, m_all, 0)), 9); // none is shown
    }

    void fromOneToTheNext()
    {
        Document document = overlapping();
        QCOMPARE(labelOf(segmentNext(document, m_all, 0)), 9);
        QCOMPARE(labelOf(segmentNext(document, m_all, 9)), 5);
        QCOMPARE(labelOf(segmentNext(document, m_all, 5)), 4);
        QCOMPARE(labelOf(segmentNext(document, m_all, 4)), 9);
        QCOMPARE(labelOf(segmentNext(document, m_none, 4)), 0);
        const ProbedVoxel one{.labels = {0, 5, 0, 0}};
        QCOMPARE(labelOf(segmentNext(document, one, 5)), 5);
        QCOMPARE(labelOf(segmentNext(document, one, 4)), 5);
        // What is hidden is passed by.
        document.segment(5)->visible = false;
        QCOMPARE(labelOf(segmentNext(document, m_all, 9)), 4);
        QCOMPARE(labelOf(segmentNext(document, m_all, 5)), 4);
    }
};

BURIN_TEST(SegmentsAtTest)

} // namespace segmentsAtTest

#include "SegmentsAtTest.moc"
