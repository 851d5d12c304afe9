// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/PrivateFolder.h"
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

namespace privateFolderTest {

namespace {

/// Who may do what, as chmod says it.
int modeOf(const QString& path)
{
    struct stat status { };
    return ::stat(QFile::encodeName(path).constData(), &status) == 0 ? int(status.st_mode & 07777)
                                                                     : -1;
}

} // namespace

/// What tells who was treated is its owner's alone, from the moment it is there.
class PrivateFolderTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

private Q_SLOTS:
    void foldersAreMadePrivate()
    {
        const QString path = m_folder.filePath(QStringLiteral("state/burin/sessions"));
        QVERIFY(core::makePrivateFolder(path));
        QCOMPARE(modeOf(path), 0700);
        // Those above are others' too.
        QVERIFY((modeOf(m_folder.filePath(QStringLiteral("state"))) & 0500) == 0500);
    }

    void foldersBecomePrivate()
    {
        const QString path = m_folder.filePath(QStringLiteral("open"));
        QVERIFY(QDir().mkpath(path));
        QCOMPARE(::chmod(QFile::encodeName(path).constData(), 0755), 0);
        QVERIFY(core::makePrivateFolder(path));
        QCOMPARE(modeOf(path), 0700);
    }

    void filesAreMadePrivateAndKeepWhatTheyHold()
    {
        const QString path = m_folder.filePath(QStringLiteral("burin.conf"));
        QVERIFY(core::makePrivateFile(path));
        QCOMPARE(modeOf(path), 0600);
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("kept") == 4);
        file.close();
        QCOMPARE(::chmod(QFile::encodeName(path).constData(), 0644), 0);
        QVERIFY(core::makePrivateFile(path));
        QCOMPARE(modeOf(path), 0600);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("kept"));
    }

    void whatCannotBeIsTold()
    {
        QFile file(m_folder.filePath(QStringLiteral("file")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.close();
        QVERIFY(!core::makePrivateFolder(file.fileName() + QStringLiteral("/below")));
        QVERIFY(!core::makePrivateFile(file.fileName() + QStringLiteral("/below")));
    }
};

BURIN_TEST(PrivateFolderTest)

} // namespace privateFolderTest

#include "PrivateFolderTest.moc"
