// SPDX-License-Identifier: Apache-2.0
#include "tests/support/servers/BurinProgram.h"

#include "tests/support/program/Sanitizer.h"

#include <QElapsedTimer>
#include <QJsonDocument>
#include <QProcess>
#include <QProcessEnvironment>

#include <algorithm>

#include <sys/resource.h>

namespace test {

namespace {

Outcome outcomeOf(QProcess& process)
{
    Outcome outcome;
    outcome.status = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
    outcome.complaint = QString::fromUtf8(process.readAllStandardError());
    outcome.output = process.readAllStandardOutput();
    return outcome;
}

void readLines(Outcome& outcome, const QByteArray& told)
{
    for (const QByteArray& line : told.split('\n')) {
        if (!line.isEmpty())
            outcome.lines.append(QJsonDocument::fromJson(line).object());
    }
}

Outcome run(const QStringList& arguments, const QProcessEnvironment& environment,
    std::size_t addressSpaceBytes, int openFiles)
{
    constexpr int patienceMs = 300000 * slowness;
    QProcess process;
    process.setProcessEnvironment(environment);
    if (addressSpaceBytes > 0 || openFiles > 0) {
        process.setChildProcessModifier([addressSpaceBytes, openFiles] {
            const rlimit space{addressSpaceBytes, addressSpaceBytes};
            const rlimit files{rlim_t(openFiles), rlim_t(openFiles)};
            if (addressSpaceBytes > 0)
                setrlimit(RLIMIT_AS, &space);
            if (openFiles > 0)
                setrlimit(RLIMIT_NOFILE, &files);
        });
    }
    process.start(QStringLiteral(BURIN_PROGRAM), arguments);
    const bool ended = process.waitForFinished(patienceMs);
    Outcome outcome = outcomeOf(process);
    if (!ended)
        outcome.status = Outcome::hung;
    readLines(outcome, outcome.output);
    return outcome;
}

} // namespace

Outcome burin(const QStringList& arguments, const Surroundings& around)
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (auto each = around.variables.begin(); each != around.variables.end(); ++each)
        environment.insert(each.key(), each.value());
    return run(arguments, environment, around.addressSpaceBytes, around.openFiles);
}

Outcome burin(const QStringList& arguments, const QProcessEnvironment& environment)
{
    return run(arguments, environment, 0, 0);
}

Outcome burinKilled(
    const QStringList& arguments, const QProcessEnvironment& environment, int afterMs)
{
    QProcess process;
    process.setProcessEnvironment(environment);
    QElapsedTimer clock;
    clock.start();
    process.start(QStringLiteral(BURIN_PROGRAM), arguments);
    if (!process.waitForStarted())
        qFatal("burin does not start");
    process.waitForFinished(std::max(1, afterMs - int(clock.elapsed())));
    process.kill();
    process.waitForFinished(60000);
    Outcome outcome = outcomeOf(process);
    readLines(outcome, outcome.output.left(outcome.output.lastIndexOf('\n') + 1));
    return outcome;
}

} // namespace test
