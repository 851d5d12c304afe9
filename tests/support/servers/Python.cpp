// SPDX-License-Identifier: Apache-2.0
#include "tests/support/servers/Python.h"

#include <QProcess>

namespace test {

namespace {

ScriptOutput run(QProcess& process, const QString& program, const QStringList& arguments)
{
    constexpr int limitMs = 300'000;
    process.start(program, arguments);
    ScriptOutput result;
    if (!process.waitForFinished(limitMs)) {
        result.errors = program + QStringLiteral(": ") + process.errorString();
        process.kill();
        process.waitForFinished();
        return result;
    }
    result.exitCode = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
    result.output = process.readAllStandardOutput();
    if (process.processChannelMode() == QProcess::SeparateChannels)
        result.errors = QString::fromLocal8Bit(process.readAllStandardError());
    return result;
}

} // namespace

ScriptOutput runScript(const QString& script, const QStringList& arguments)
{
    QProcess process;
    const QString path = QStringLiteral(BURIN_SOURCE_DIR "/tests/support/python/%1").arg(script);
    return run(process, QStringLiteral("/usr/bin/python3"), QStringList{path} + arguments);
}

ScriptOutput runProgram(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    return run(process, program, arguments);
}

} // namespace test
