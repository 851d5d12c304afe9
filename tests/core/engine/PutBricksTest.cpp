// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/PutBricks.h"
#include "core/engine/EngineCommands.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

namespace putBricksTest {

/// Bricks put in place, differences laid over them, guards and single seed words, on the oracle.
class PutBricksTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void keepsItsPromises_data() { test::addPutBricksRows(); }
    void keepsItsPromises()
    {
        QFETCH(QString, name);
        reference::ReferenceEngine engine;
        const QString wrong = test::tryPutBricks(engine, name);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    }
};

BURIN_TEST(PutBricksTest)

} // namespace putBricksTest

#include "PutBricksTest.moc"
