// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "core/session/SessionDisplay.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTemporaryDir>
#include <QTest>

namespace hiddenSegmentsTest {

using namespace core;

/// Segments that are not shown: display state, which the history does not tell.
class HiddenSegmentsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// The label of one that was undone is given again, and what bears it then is another segment.
    void aNewSegmentIsShown()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("hidden.burin"));
        reference::ReferenceEngine engine;
        {
            const auto session = *EditSession::create(engine, test::smallStudy(), {.file = path});
            QVERIFY(session->apply(test::addSegment("A")));
            QVERIFY(session->apply(test::addSegment("B")));
            QVERIFY(session->settle());
            session->display().setSegmentVisible(1, false);
            session->display().setSegmentVisible(2, false);
            QVERIFY(session->apply(test::seedInBrain(1)));
            QVERIFY(session->settle());
            QVERIFY(!session->document().segment(2)->visible);
            QVERIFY(session->undo());
            QVERIFY(session->undo());
            QVERIFY(session->settle());
            QVERIFY(!session->document().segment(2));
            // What comes back is the same as before.
            QVERIFY(session->redo());
            QVERIFY(session->settle());
            QVERIFY(!session->document().segment(2)->visible);
            QVERIFY(session->undo());
            QVERIFY(session->apply(test::addSegment("C")));
            QVERIFY(session->settle());
            QCOMPARE(session->document().segment(2)->name, QStringLiteral("C"));
            QVERIFY(session->document().segment(2)->visible);
            QVERIFY(!session->document().segment(1)->visible);
        }
        reference::ReferenceEngine other;
        const auto again = *EditSession::open(other, test::smallStudy(), path);
        QVERIFY(again->document().segment(2)->visible);
        QVERIFY(!again->document().segment(1)->visible);
    }
};

BURIN_TEST(HiddenSegmentsTest)

} // namespace hiddenSegmentsTest

#include "HiddenSegmentsTest.moc"
