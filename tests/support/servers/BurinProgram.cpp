// SPDX-License-Identifier: Apache-2.0
#include "tests/support/servers/BurinProgram.h"

#include <QJsonDocument>
#include <QProcess>
#include <QProcessEnvironment>

#include <sys/resource.h>

namespace test {

namespace {

Outcome run(const QStringList& arguments, const QProcessEnvironment& environment,
    std::size_t addressSpaceBytes, int openFiles)
{
    constexpr int patienceMs = 300000;
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
    Outcome outcome;
    outcome.status = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
    if (!ended)
        outcome.status = Outcome::hung;
    outcome.complaint = QString::fromUtf8(process.readAllStandardError());
    outcome.output = process.readAllStandardOutput();
    for (const QByteArray& line : outcome.output.split('\n')) {
        if (!line.isEmpty())
            outcome.lines.append(QJsonDocument::fromJson(line).object());
    }
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

} // namespace test
