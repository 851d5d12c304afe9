// SPDX-License-Identifier: Apache-2.0
#include "app/end/EndNote.h"

#include "app/end/SuddenEnd.h"
#include "app/steps/SessionFiles.h"
#include "core/base/files/PrivateFolder.h"

#include <QCoreApplication>
#include <QDir>
#include <QObject>

#include <sys/file.h>

namespace app {

namespace {

QDir notes()
{
    const QString folder = QFileInfo(sessionFolder()).absolutePath() + QStringLiteral("/windows");
    core::makePrivateFolder(folder);
    return QDir(folder);
}

QString sentence(const QByteArray& why)
{
    const QString whole = QObject::tr("Every step that was done is in its session.");
    if (why == EndNote::outOfMemory)
        return QObject::tr("Burin ended by itself last time: there was not enough memory. %1")
            .arg(whole);
    if (why == EndNote::crashed)
        return QObject::tr("Burin crashed last time. %1").arg(whole);
    return QObject::tr("Burin was ended from outside last time. %1").arg(whole);
}

} // namespace

EndNote::EndNote()
    : m_file(notes().filePath(QString::number(QCoreApplication::applicationPid())))
{
    if (!m_file.open(QIODevice::WriteOnly | QIODevice::Unbuffered,
            QFileDevice::ReadOwner | QFileDevice::WriteOwner))
        return;
    ::flock(m_file.handle(), LOCK_EX | LOCK_NB);
    noteSuddenEndIn(m_file.handle());
}

EndNote::~EndNote()
{
    noteSuddenEndIn(-1);
    if (m_file.isOpen())
        m_file.remove();
}

QString EndNote::takeEarlier()
{
    QString told;
    const QDir folder = notes();
    for (const QString& name : folder.entryList(QDir::Files, QDir::Time | QDir::Reversed)) {
        QFile file(folder.filePath(name));
        // The system lets the lock of a process go, however that ended.
        if (!file.open(QIODevice::ReadOnly) || ::flock(file.handle(), LOCK_EX | LOCK_NB) != 0)
            continue;
        told = sentence(file.read(64));
        file.remove();
    }
    return told;
}

} // namespace app
