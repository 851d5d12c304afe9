// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/RandomHistory.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <numeric>
#include <vector>

namespace randomHistoryTest {

/// Random sequences of all kinds of commands with undo, redo, branches and files: after each step
/// the session holds what a recomputation says.
class RandomHistoryTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void equalsTheTruthAfterEveryStep_data()
    {
        QTest::addColumn<int>("commands");
        QTest::addColumn<uint>("seed");
        const bool isLong = qEnvironmentVariableIsSet("BURIN_LONG");
        // Those of a daily run are chosen: the rarest commands occur in one seed of twenty.
        std::vector<uint> seeds{1, 3, 4, 7, 9, 11, 23};
        if (isLong) {
            seeds.resize(32);
            std::iota(seeds.begin(), seeds.end(), 1u);
        }
        for (const uint seed : seeds)
            QTest::addRow("seed %u", seed) << (isLong ? 500 : 340) << seed;
    }
    void equalsTheTruthAfterEveryStep()
    {
        QFETCH(int, commands);
        QFETCH(uint, seed);
        reference::ReferenceEngine engine;
        const test::RandomHistory history = test::runRandomHistory(engine, commands, seed);
        QVERIFY2(history.failure.isEmpty(), qPrintable(history.failure));
        QCOMPARE(history.hashes.size(), std::size_t(commands));
        for (const auto& [kind, count] : history.done)
            m_done[kind] += count;
    }
    void cleanupTestCase()
    {
        for (const auto& [kind, count] : m_done)
            qInfo("%s: %d", qPrintable(kind), count);
        // No kind of command was left out.
        for (const char* kind : {"addSegment", "changeSegment", "moveSegment", "removeSegment",
                 "addLayer", "changeLayer", "moveLayer", "addBookmark", "removeBookmark", "seed",
                 "grow", "interval", "resume", "shrink", "shrinkAt", "plug", "barrier",
                 "growFromSeeds", "drill", "paint", "brush", "peel", "scissors", "laser",
                 "cutPiece", "pastePiece", "changePiece", "sendPiecesHome", "removePiece", "revert",
                 "reviseStroke", "addMeasurement", "annotate", "moveMeasurement",
                 "removeMeasurement", "removeLayer", "mergeLayers", "layerToSegment",
                 "segmentToLayer", "segmentSeen", "invertSegment", "combineSegments merge",
                 "combineSegments swap", "cleanSegment fill holes", "cleanSegment keep largest",
                 "cleanSegment remove small", "cleanSegment keep clicked",
                 "cleanSegment remove clicked", "cleanSegment give clicked", "fillOutline",
                 "reshapeSegment", "fillBetweenSlices", "floodFill", "thresholdSegment",
                 "segmentScissors", "mirrorSegment", "evolveContour", "splitIslands",
                 "splitSegment", "splitByCurve", "undo", "redo", "goTo", "reopen", "given up"})
            QVERIFY2(m_done[QLatin1String(kind)] > 0, kind);
    }

    /// Edits of labels that keep to an editable range, in histories of their own.
    void withEditableRanges_data()
    {
        QTest::addColumn<uint>("seed");
        const bool isLong = qEnvironmentVariableIsSet("BURIN_LONG");
        for (uint seed = 103; seed < (isLong ? 113u : 104u); ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void withEditableRanges()
    {
        QFETCH(uint, seed);
        reference::ReferenceEngine engine;
        test::RandomHistory history =
            test::runRandomHistory(engine, 200, seed, {}, {.limited = true});
        QVERIFY2(history.failure.isEmpty(), qPrintable(history.failure));
        m_editable += history.done[QStringLiteral("editable")];
        QVERIFY(m_editable > 3);
    }

    /// Masks that overlap, and edits of segments in further label planes, in histories of their
    /// own: half of them with editable ranges, which may be inside a segment of another plane.
    void withOverlappingMasks_data()
    {
        QTest::addColumn<uint>("seed");
        const bool isLong = qEnvironmentVariableIsSet("BURIN_LONG");
        for (uint seed = 201; seed < (isLong ? 221u : 203u); ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void withOverlappingMasks()
    {
        QFETCH(uint, seed);
        reference::ReferenceEngine engine;
        const int commands = qEnvironmentVariableIsSet("BURIN_LONG") ? 400 : 150;
        test::RandomHistory history = test::runRandomHistory(
            engine, commands, seed, {}, {.limited = seed % 2 == 0, .planes = true});
        QVERIFY2(history.failure.isEmpty(), qPrintable(history.failure));
        QCOMPARE(history.hashes.size(), std::size_t(commands));
        for (const auto& [kind, count] : history.done) {
            if (!kind.endsWith(QStringLiteral("further plane")))
                continue;
            qInfo("%s: %d", qPrintable(kind), count);
            m_inFurtherPlanes += count;
        }
        QVERIFY(history.done.count(QStringLiteral("importMask, further plane")) != 0);
        m_copies += history.done[QStringLiteral("copySegment, further plane")];
        QVERIFY(m_copies > 0);
        m_grownInPlanes += history.done[QStringLiteral("grow, further plane")];
        QVERIFY(m_grownInPlanes > 0);
        QVERIFY(m_inFurtherPlanes > 5);
    }

    /// Growths that compare medians, what moves their interval and what is done to them, in
    /// histories of their own.
    void withSmoothedGrowth_data()
    {
        QTest::addColumn<uint>("seed");
        const bool isLong = qEnvironmentVariableIsSet("BURIN_LONG");
        for (uint seed = 301; seed < (isLong ? 313u : 302u); ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void withSmoothedGrowth()
    {
        QFETCH(uint, seed);
        reference::ReferenceEngine engine;
        test::RandomHistory history =
            test::runRandomHistory(engine, 150, seed, {}, {.smoothed = true});
        QVERIFY2(history.failure.isEmpty(), qPrintable(history.failure));
        QVERIFY(history.done[QStringLiteral("smoothed")] > 0);
    }

    /// What was drawn on planes that cross, in histories of their own.
    void withPlanesThatCross_data()
    {
        QTest::addColumn<uint>("seed");
        const bool isLong = qEnvironmentVariableIsSet("BURIN_LONG");
        for (uint seed = 401; seed < (isLong ? 413u : 402u); ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void withPlanesThatCross()
    {
        QFETCH(uint, seed);
        reference::ReferenceEngine engine;
        test::RandomHistory history = test::runRandomHistory(
            engine, 150, seed, {}, {.limited = seed % 2 == 0, .crossing = true});
        QVERIFY2(history.failure.isEmpty(), qPrintable(history.failure));
        qInfo("between planes: %d", history.done[QStringLiteral("between planes")]);
        QVERIFY(history.done[QStringLiteral("between planes")] > 0);
    }

private:
    std::map<QString, int> m_done;
    int m_grownInPlanes = 0; ///< in all of them
    int m_copies = 0; ///< likewise, of segments
    int m_inFurtherPlanes = 0; ///< edits of segments there, likewise
    int m_editable = 0; ///< edits with a range, in all of them
};

BURIN_TEST(RandomHistoryTest)

} // namespace randomHistoryTest

#include "RandomHistoryTest.moc"
