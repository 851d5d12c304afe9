// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"

#include <QRegularExpression>
#include <QTest>

namespace test {

namespace {

QtMessageHandler testHandler = nullptr;

// Qt Test fails on warnings only.
void criticalAsWarning(QtMsgType type, const QMessageLogContext& context, const QString& message)
{
    testHandler(type == QtCriticalMsg ? QtWarningMsg : type, context, message);
}

// What passes: Qt about a session without a login (containers, CI).
const QRegularExpression& unexpected()
{
    static const QRegularExpression pattern(QStringLiteral(
        "^(?!QStandardPaths: (XDG_RUNTIME_DIR|runtime directory|wrong permissions))"));
    return pattern;
}

} // namespace

void failOnUnexpectedMessages()
{
    // Qt Test installs its own handler when the program starts and keeps it.
    const QtMessageHandler previous = qInstallMessageHandler(criticalAsWarning);
    if (previous != criticalAsWarning)
        testHandler = previous;
    QTest::failOnWarning(unexpected());
}

} // namespace test
