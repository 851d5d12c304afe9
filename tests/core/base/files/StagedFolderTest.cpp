// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/StagedFolder.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <optional>

namespace stagedFolderTest {

using namespace core;

/// The door for folders that are written: whole or not there, and nothing in its way is touched.
class StagedFolderTest : public QObject {
    Q_OBJECT

    std::optional<QTemporaryDir> m_folder;

    QString path(const char* name) const { return m_folder->filePath(QString::fromUtf8(name)); }
    static void write(const QString& file)
    {
        QFile out(file);
        if (!out.open(QIODevice::WriteOnly) || out.write("x") != 1)
            qFatal("cannot write %s", qPrintable(file));
    }
    QStringList names() const
    {
        return QDir(m_folder->path())
            .entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
    }

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        m_folder.emplace();
    }

    void itAppearsWhole()
    {
        {
            auto staged = StagedFolder::create(path("a"));
            QVERIFY(staged);
            write(staged->path() + QStringLiteral("/1"));
            QVERIFY(!QFile::exists(path("a")));
            QVERIFY(staged->commit());
        }
        QCOMPARE(names(), QStringList{QStringLiteral("a")});
        QVERIFY(QFile::exists(path("a/1")));
    }

    void whatIsNotWholeLeavesNothing()
    {
        {
            const auto staged = StagedFolder::create(path("a"));
            QVERIFY(staged);
            write(staged->path() + QStringLiteral("/1"));
        }
        QCOMPARE(names(), QStringList());
    }

    void whatIsReplacedKeepsItsNameUntilThen()
    {
        QVERIFY(QDir().mkpath(path("a")) && QDir().mkpath(path("b")));
        write(path("a/old"));
        write(path("b/new"));
        {
            auto nothing = StagedFolder::adopt(path("nowhere"), path("a"), true);
            const auto placed = nothing.commit();
            QVERIFY(!placed);
            QCOMPARE(placed.error().code, ErrorCode::FileUnwritable);
        }
        QVERIFY(QFile::exists(path("a/old")));
        {
            auto staged = StagedFolder::adopt(path("b"), path("a"), true);
            QVERIFY(staged.commit());
            QVERIFY(QFile::exists(path("a/new")));
        }
        QCOMPARE(names(), QStringList{QStringLiteral("a")});
        QCOMPARE(QDir(path("a")).entryList(QDir::Files), QStringList{QStringLiteral("new")});
        // Where nothing is to be replaced it takes a free name, as any other.
        QVERIFY(QDir().mkpath(path("c")));
        write(path("c/new"));
        QVERIFY(StagedFolder::adopt(path("c"), path("d"), true).commit());
        QVERIFY(QFile::exists(path("d/new")));
    }

    /// Whatever came there meanwhile: a link is no folder, and what it leads to is somebody's.
    void aLinkIsNotReplaced()
    {
        QVERIFY(QDir().mkpath(path("theirs")) && QDir().mkpath(path("new")));
        write(path("theirs/file"));
        write(path("new/file"));
        QVERIFY(QFile::link(path("theirs"), path("link")));
        {
            auto staged = StagedFolder::adopt(path("new"), path("link"), true);
            const auto placed = staged.commit();
            QVERIFY(!placed);
            QCOMPARE(placed.error().code, ErrorCode::FileExists);
        }
        QVERIFY(QFileInfo(path("link")).isSymLink());
        QVERIFY(QFile::exists(path("theirs/file")));
        QVERIFY(!QFile::exists(path("new")));
        // Nor where a link has taken the place of the new folder.
        {
            const auto staged = StagedFolder::adopt(path("link"), path("other"));
        }
        QVERIFY(QFile::exists(path("theirs/file")));
    }

    void aFileThatIsReplacedIsGone()
    {
        QVERIFY(QDir().mkpath(path("new")));
        write(path("new/file"));
        write(path("old"));
        {
            auto staged = StagedFolder::adopt(path("new"), path("old"), true);
            QVERIFY(staged.commit());
        }
        QVERIFY(QFile::exists(path("old/file")));
        QCOMPARE(names(), QStringList{QStringLiteral("old")});
    }

    void onlyAnEmptyFolderGivesWay()
    {
        QVERIFY(QDir().mkpath(path("empty")) && QDir().mkpath(path("full")));
        write(path("full/mine"));
        write(path("file"));
        QVERIFY(QFile::link(path("empty"), path("link")));
        QVERIFY(QFile::link(path("nowhere"), path("dangling")));
        for (const char* name : {"full", "file", "link", "dangling"}) {
            const auto staged = StagedFolder::create(path(name));
            QVERIFY2(!staged, name);
            QCOMPARE(staged.error().code, ErrorCode::FileExists);
        }
        QVERIFY(!StagedFolder::create(path("no/such/folder")));
        auto staged = StagedFolder::create(path("empty"));
        QVERIFY(staged);
        // Filled by somebody else meanwhile.
        write(path("empty/theirs"));
        const auto placed = staged->commit();
        QVERIFY(!placed);
        QCOMPARE(placed.error().code, ErrorCode::FileExists);
        QVERIFY(QFile::exists(path("empty/theirs")));
    }
};

BURIN_TEST(StagedFolderTest)

} // namespace stagedFolderTest

#include "StagedFolderTest.moc"
