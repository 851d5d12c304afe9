// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/DelayedEngine.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/StrokeCases.h"
#include "tests/support/cases/StrokeHashes.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

namespace strokeHashTest {

/// An edit finished, cancelled, undone, redone, made again, reopened and replayed, on the oracle.
class StrokeHashTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void agrees_data();
    void agrees();
};

void StrokeHashTest::agrees_data()
{
    QTest::addColumn<test::StrokeCase>("stroke");
    QTest::addColumn<bool>("delayed");
    int row = 0;
    for (const test::StrokeCase& stroke : test::strokeCases(test::longRun() ? 100 : 8))
        QTest::addRow("%s", stroke.name.constData())
            << stroke << (test::longRun() || row++ % 6 == 0);
}

void StrokeHashTest::agrees()
{
    QFETCH(test::StrokeCase, stroke);
    QFETCH(bool, delayed);
    reference::ReferenceEngine engine;
    const test::StrokeHashes direct = test::runStroke(engine, stroke);
    const QString text = test::contradiction(direct);
    QVERIFY2(text.isEmpty(), qPrintable(text));
    const bool changesNothing = stroke.name == "growth of nothing" || stroke.name == "erase nothing"
        || stroke.name == "restore what is whole" || stroke.name == "nothing to a new segment"
        || stroke.name == "shrinking of nothing" || stroke.name == "empty segment to layer"
        || stroke.name == "nothing is seen" || stroke.name == "growth after a shut cut"
        || stroke.name == "plugging where nothing is narrow"
        || stroke.name == "seeds that have grown are not taken away"
        || stroke.name == "a mask that is held already" || stroke.name == "divide again"
        || stroke.name == "take what is not there" || stroke.name == "follow what did not change"
        || stroke.name == "fill holes where there are none"
        || stroke.name == "write back what was not changed"
        || stroke.name == "write back a second time" || stroke.name == "lay a surface again"
        || stroke.name == "barrier around the surface again"
        || stroke.name == "open no barrier around the surface"
        || stroke.name == "lay crossing parts anew where none cross"
        || stroke.name == "merge an empty segment into another"
        || stroke.name == "close an empty segment"
        || stroke.name == "fill between slices of a solid segment"
        || stroke.name == "fill between slices of an empty segment"
        || stroke.name == "a contour of an empty segment"
        || stroke.name == "mirror an empty segment"
        || stroke.name == "a threshold of no voxel"
        || stroke.name == "growth after a swap of segments"; // their seeds have gone
    if (!stroke.name.startsWith("random"))
        QCOMPARE(direct.finished == direct.before, changesNothing);

    if (!delayed)
        return;
    reference::ReferenceEngine inner;
    reference::DelayedEngine late(inner, 11);
    const QString apart = test::difference(direct.ends(), test::runStroke(late, stroke));
    QVERIFY2(apart.isEmpty(), qPrintable(apart));
}

BURIN_TEST(StrokeHashTest)

} // namespace strokeHashTest

#include "StrokeHashTest.moc"
