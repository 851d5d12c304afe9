// SPDX-License-Identifier: Apache-2.0
#include "core/pacs/retrieve/DownloadFolder.h"

#include "core/base/files/FolderCache.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/VerifyResult.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace downloadFolderTest {

using core::DownloadFolder;
using core::ErrorCode;

/// Where downloads are gathered: who may, what becomes of what others left there, and why not.
class DownloadFolderTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    QString at(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    QString target() const { return at("got"); }
    static void write(const QString& path, const QByteArray& bytes)
    {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes), bytes.size());
    }
    static QByteArray read(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        m_folder = std::make_unique<QTemporaryDir>();
    }

    /// Who comes second leaves the first one's folder alone, empty as that may be as yet.
    void whoIsRefusedTouchesNothing()
    {
        auto first = DownloadFolder::open(target());
        VERIFY_DONE(first);
        const QByteArray note = read(at(".got.burin-download/.download"));
        QVERIFY(!note.isEmpty());
        QVERIFY(!DownloadFolder::open(target()));
        QCOMPARE(read(at(".got.burin-download/.download")), note);
        write(first->partPathOf(QStringLiteral("1.2")), "an object");
        const auto accepted =
            first->accept(first->partPathOf(QStringLiteral("1.2")), QStringLiteral("1.2"));
        VERIFY_DONE(accepted);
        // What is there is not on the disk, whoever looked in meanwhile.
        QVERIFY(!DownloadFolder::open(target()));
        QCOMPARE(read(at(".got.burin-download/.download")), note);
        const auto finished = first->finish();
        VERIFY_DONE(finished);
        QCOMPARE(read(at("got/1.2.dcm")), QByteArray("an object"));
    }

    /// A kill between the making of a lock and the writing of who holds it leaves an empty one.
    void aLockWithoutANameIsNobodys()
    {
        write(at(".got.burin-download.lock"), {});
        {
            const auto opened = DownloadFolder::open(target());
            VERIFY_DONE(opened);
        }
        QVERIFY(
            QDir(m_folder->path()).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
        // Nor does such a mark keep what is in a cache.
        const core::FolderCache cache(at("cache"));
        QVERIFY(cache.prepare());
        QVERIFY(QDir().mkpath(cache.placeOf(QStringLiteral("a"))));
        write(at("cache/a.open-1-1"), {});
        QVERIFY(!cache.isHeld(cache.placeOf(QStringLiteral("a"))));
        QVERIFY(!QFile::exists(at("cache/a.open-1-1")));
    }

    /// A kill after the last step leaves a lock beside what is whole.
    void aLockBesideWhatIsWholeGoes()
    {
        const QString lock = at(".got.burin-download.lock");
        DownloadFolder::removeLockLeftOver(target()); // there is none
        write(lock, {});
        DownloadFolder::removeLockLeftOver(target());
        QVERIFY(!QFile::exists(lock));
        const auto other = DownloadFolder::open(target());
        VERIFY_DONE(other);
        DownloadFolder::removeLockLeftOver(target());
        QVERIFY(QFile::exists(lock)); // another download holds it
    }

    void whyItCannotBeLockedIsSaid()
    {
        // The folder that it is gathered in has a name that is short enough, its lock has not.
        constexpr int letters = 236;
        const auto opened = DownloadFolder::open(m_folder->filePath(QString(letters, u'x')));
        VERIFY_ERROR(opened, ErrorCode::FileUnwritable);
        QCOMPARE(opened.error().arguments.value(1), QStringLiteral("File name too long"));
        QVERIFY(
            QDir(m_folder->path()).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
    }

    /// What was brought to the disk is believed by its note: a note that stays would be believed of
    /// what comes after it.
    void withoutANoteNothingIsGathered()
    {
        QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral(".got.burin-download/.download")));
        const auto opened = DownloadFolder::open(target());
        VERIFY_ERROR(opened, ErrorCode::FileUnwritable);
        QVERIFY2(opened.error().arguments.value(1).contains(QLatin1String("directory")),
            qPrintable(opened.error().arguments.value(1)));
    }
};

BURIN_TEST(DownloadFolderTest)

} // namespace downloadFolderTest

#include "DownloadFolderTest.moc"
