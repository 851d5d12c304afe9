// SPDX-License-Identifier: Apache-2.0
#include "tests/support/BurinProgram.h"

#include <QJsonDocument>
#include <QProcess>

namespace test {

Outcome burin(const QStringList& arguments)
{
    QProcess process;
    process.start(QStringLiteral(BURIN_PROGRAM), arguments);
    process.waitForFinished(300000);
    Outcome outcome;
    outcome.status = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
    outcome.complaint = QString::fromUtf8(process.readAllStandardError());
    outcome.output = process.readAllStandardOutput();
    for (const QByteArray& line : outcome.output.split('\n')) {
        if (!line.isEmpty())
            outcome.lines.append(QJsonDocument::fromJson(line).object());
    }
    return outcome;
}

} // namespace test
