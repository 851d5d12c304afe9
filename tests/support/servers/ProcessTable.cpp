// SPDX-License-Identifier: Apache-2.0
#include "tests/support/servers/ProcessTable.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QThread>

#include <csignal>

namespace test {

namespace {

QByteArray contentOf(qint64 pid, const char* file)
{
    QFile content(QStringLiteral("/proc/%1/%2").arg(pid).arg(QLatin1String(file)));
    return content.open(QIODevice::ReadOnly) ? content.readAll() : QByteArray();
}

/// State and parent, which follow the program's name in parentheses.
QList<QByteArray> statusOf(qint64 pid)
{
    const QByteArray text = contentOf(pid, "stat");
    return text.mid(text.lastIndexOf(')') + 2).split(' ');
}

} // namespace

std::vector<RunningProcess> runningProcesses()
{
    std::vector<RunningProcess> found;
    const QStringList names = QDir(QStringLiteral("/proc")).entryList(QDir::Dirs);
    for (const QString& name : names) {
        bool isNumber = false;
        const qint64 pid = name.toLongLong(&isNumber);
        QByteArray line = isNumber ? contentOf(pid, "cmdline") : QByteArray();
        const QList<QByteArray> status = line.isEmpty() ? QList<QByteArray>() : statusOf(pid);
        if (status.size() < 2)
            continue;
        if (line.endsWith('\0'))
            line.chop(1);
        found.push_back({.pid = pid,
            .parent = status[1].toLongLong(),
            .words = QString::fromUtf8(line).split(QChar::Null)});
    }
    return found;
}

bool holdProcess(qint64 pid)
{
    constexpr int patienceMs = 10000;
    if (::kill(pid_t(pid), SIGSTOP) != 0)
        return false;
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < patienceMs) {
        const QByteArray state = statusOf(pid).first();
        if (state == "T")
            return true;
        if (state.isEmpty() || state == "Z" || state == "X")
            return false;
        QThread::msleep(1);
    }
    return false;
}

} // namespace test
