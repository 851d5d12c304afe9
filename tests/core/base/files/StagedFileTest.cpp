// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/StagedFile.h"
#include "core/base/files/FileInUse.h"
#include "core/base/files/ReadableFile.h"
#include "core/base/files/SystemFile.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cerrno>
#include <cstdio>
#include <optional>

#include <sys/stat.h>
#include <unistd.h>

namespace stagedFileTest {

using namespace core;

/// The one door for files that are written: what it refuses, and that nothing is lost on the way.
class StagedFileTest : public QObject {
    Q_OBJECT

    std::optional<QTemporaryDir> m_folder;

    QString path(const char* name) const { return m_folder->filePath(QString::fromUtf8(name)); }
    QString write(const char* name, const QByteArray& content) const
    {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("cannot write %s", name);
        return file.fileName();
    }
    static QByteArray read(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(cannot be read)");
    }
    static void fill(const StagedFile& staged, const QByteArray& content)
    {
        QFile file(staged.path());
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("cannot write");
    }
    QStringList names() const
    {
        return QDir(m_folder->path())
            .entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
    }
    QString whyNot(const QString& target, bool replace) const
    {
        const auto staged = StagedFile::create(target, replace);
        return staged ? QString() : staged.error().arguments.value(1);
    }

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        m_folder.emplace();
    }

    void appearsOnlyWhole()
    {
        {
            auto staged = StagedFile::create(path("a.txt"), false);
            QVERIFY(staged);
            fill(*staged, "half");
            QVERIFY(!QFile::exists(path("a.txt")));
        }
        QCOMPARE(names(), QStringList());
        auto staged = StagedFile::create(path("a.txt"), false);
        fill(*staged, "whole");
        QVERIFY(staged->commit());
        QCOMPARE(read(path("a.txt")), QByteArray("whole"));
        QCOMPARE(names(), QStringList{QStringLiteral("a.txt")});
    }

    void whatIsReplacedComesBack()
    {
        write("a.txt", "old");
        {
            auto staged = StagedFile::create(path("a.txt"), true);
            fill(*staged, "new");
            QVERIFY(staged->commit());
            QCOMPARE(read(path("a.txt")), QByteArray("new"));
            staged->takeBack();
            QCOMPARE(read(path("a.txt")), QByteArray("old"));
        }
        QCOMPARE(read(path("a.txt")), QByteArray("old"));
        {
            auto staged = StagedFile::create(path("a.txt"), true);
            fill(*staged, "new");
            QVERIFY(staged->commit());
        }
        QCOMPARE(read(path("a.txt")), QByteArray("new"));
        QCOMPARE(names(), QStringList{QStringLiteral("a.txt")});
        {
            auto staged = StagedFile::create(path("b.txt"), false);
            QVERIFY(staged->commit());
            staged->takeBack();
        }
        QCOMPARE(names(), QStringList{QStringLiteral("a.txt")});
    }

    /// Another program put something in the place of the new file before it is taken back.
    void whatTookItsPlaceStays()
    {
        write("a.txt", "old");
        QString left;
        {
            auto staged = StagedFile::create(path("a.txt"), true);
            fill(*staged, "new");
            QVERIFY(staged->commit());
            write("theirs.txt", "theirs");
            QVERIFY(std::rename(qPrintable(path("theirs.txt")), qPrintable(path("a.txt"))) == 0);
            left = staged->takeBack();
        }
        QCOMPARE(read(path("a.txt")), QByteArray("theirs"));
        // What was replaced is told of, and stays where it is.
        QCOMPARE(read(left), QByteArray("old"));
        QVERIFY(QFile::remove(left));
        {
            auto staged = StagedFile::create(path("b.txt"), false);
            fill(*staged, "new");
            QVERIFY(staged->commit());
            write("theirs.txt", "theirs");
            QVERIFY(std::rename(qPrintable(path("theirs.txt")), qPrintable(path("b.txt"))) == 0);
            QCOMPARE(staged->takeBack(), QString());
        }
        QCOMPARE(read(path("b.txt")), QByteArray("theirs"));
        QCOMPARE(names(), (QStringList{QStringLiteral("a.txt"), QStringLiteral("b.txt")}));
    }

    void onlyAFreeNameIsTaken()
    {
        write("a.txt", "a");
        write("b.txt", "b");
        const auto refused = [this](const char* from, const char* to) {
            return renameToFreeName(path(from), path(to)) ? 0 : errno;
        };
        QCOMPARE(refused("a.txt", "b.txt"), EEXIST);
        QVERIFY(renameToFreeName(path("a.txt"), path("c.txt")));
        QCOMPARE(read(path("b.txt")), QByteArray("b"));
        QCOMPARE(read(path("c.txt")), QByteArray("a"));
        QCOMPARE(refused("a.txt", "d.txt"), ENOENT);
    }

    /// There is no other copy of it.
    void whatWasTakenOverStays()
    {
        write("a.txt", "old");
        write("b.txt", "the only one");
        {
            const StagedFile staged = StagedFile::adopt(path("b.txt"), path("a.txt"));
        }
        QCOMPARE(read(path("b.txt")), QByteArray("the only one"));
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("folder")));
        {
            StagedFile refused = StagedFile::adopt(path("b.txt"), path("folder"));
            QVERIFY(!refused.commit());
        }
        {
            StagedFile undone = StagedFile::adopt(path("b.txt"), path("a.txt"));
            QVERIFY(undone.commit());
            QCOMPARE(undone.takeBack(), QString());
        }
        QCOMPARE(read(path("a.txt")), QByteArray("old"));
        QCOMPARE(read(path("b.txt")), QByteArray("the only one"));
        {
            StagedFile placed = StagedFile::adopt(path("b.txt"), path("a.txt"));
            QVERIFY(placed.commit());
        }
        QCOMPARE(read(path("a.txt")), QByteArray("the only one"));
        QCOMPARE(names(), (QStringList{QStringLiteral("a.txt"), QStringLiteral("folder")}));
    }

    void whatCameMeanwhileStays()
    {
        {
            write("taken.txt", "somebody else's");
            StagedFile only =
                StagedFile::adopt(write("only.txt", "the only one"), path("taken.txt"), false);
            QCOMPARE(only.commit().error().code, ErrorCode::FileExists);
        }
        QCOMPARE(read(path("taken.txt")), QByteArray("somebody else's"));
        QCOMPARE(read(path("only.txt")), QByteArray("the only one"));
        auto staged = StagedFile::create(path("a.txt"), false);
        write("a.txt", "somebody else's");
        const Result<void> placed = staged->commit();
        QVERIFY(!placed);
        QCOMPARE(placed.error().code, ErrorCode::FileExists);
        QCOMPARE(read(path("a.txt")), QByteArray("somebody else's"));
        // What may be replaced may have become a link meanwhile.
        auto over = StagedFile::create(path("a.txt"), true);
        QVERIFY(QFile::rename(path("a.txt"), path("b.txt")));
        QVERIFY(QFile::link(path("b.txt"), path("a.txt")));
        QVERIFY(!over->commit());
        QCOMPARE(read(path("b.txt")), QByteArray("somebody else's"));
    }

    void onlyPlainFilesAreReplaced()
    {
        QVERIFY(::mkfifo(QFile::encodeName(path("pipe")).constData(), 0600) == 0);
        write("notes.txt", "precious");
        QVERIFY(QFile::link(path("notes.txt"), path("link")));
        QVERIFY(QFile::link(path("nowhere"), path("dangling")));
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("folder")));
        const bool device =
            ::mknod(QFile::encodeName(path("device")).constData(), S_IFCHR | 0600, 0x103) == 0;
        for (const bool replace : {false, true}) {
            QVERIFY(whyNot(path("pipe"), replace).contains(QStringLiteral("no plain file")));
            QVERIFY(whyNot(path("link"), replace).contains(QStringLiteral("a link")));
            QVERIFY(whyNot(path("dangling"), replace).contains(QStringLiteral("a link")));
            QVERIFY(whyNot(path("folder"), replace).contains(QStringLiteral("a folder")));
            QVERIFY(whyNot(path("folder/"), replace).contains(QStringLiteral("a folder")));
            QVERIFY(whyNot(path("none/a"), replace).contains(QStringLiteral("does not exist")));
            QVERIFY(!whyNot(path("notes.txt/a"), replace).isEmpty());
            QVERIFY(whyNot(path("a") + QChar::Null + u'b', replace).contains(u"NUL"));
            QVERIFY(whyNot(path("bad\xff\xfe"), replace).contains(QStringLiteral("UTF-8")));
            if (device)
                QVERIFY(whyNot(path("device"), replace).contains(QStringLiteral("no plain file")));
        }
        QCOMPARE(read(path("notes.txt")), QByteArray("precious"));
        QCOMPARE(names().size(), device ? 6 : 5);
    }

    void whatIsInUseIsNotReplaced()
    {
        const QString slice = write("IM1.dcm", "voxels");
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("real")));
        QVERIFY(QFile::link(path("real"), path("linked")));
        QVERIFY(::link(QFile::encodeName(slice).constData(),
                    QFile::encodeName(path("hard.dcm")).constData())
            == 0);
        write("real/recipe.json", "{}");
        {
            const FileInUse study({slice, path("missing")}, FileInUse::As::Study);
            const FileInUse twice({slice}, FileInUse::As::Study);
            const FileInUse recipe({path("real/recipe.json")}, FileInUse::As::Recipe);
            QCOMPARE(whyNot(slice, true), FileInUse::text(FileInUse::As::Study));
            QCOMPARE(whyNot(path("hard.dcm"), true), FileInUse::text(FileInUse::As::Study));
            QCOMPARE(whyNot(path("real/../IM1.dcm"), true), FileInUse::text(FileInUse::As::Study));
            QCOMPARE(
                whyNot(path("linked/recipe.json"), true), FileInUse::text(FileInUse::As::Recipe));
            QCOMPARE(whyNot(path("IM2.dcm"), true), QString());
        }
        QCOMPARE(whyNot(slice, true), QString());
        // One use of two that has ended leaves the other.
        auto first = std::make_unique<FileInUse>(QStringList{slice}, FileInUse::As::Study);
        const FileInUse second({slice}, FileInUse::As::Study);
        first.reset();
        QCOMPARE(whyNot(slice, true), FileInUse::text(FileInUse::As::Study));
    }

    void namesOfOneFileAreOne()
    {
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("real")));
        QVERIFY(QFile::link(path("real"), path("linked")));
        QVERIFY(FileIdentity::of(path("real/new.csv")) == FileIdentity::of(path("linked/new.csv")));
        QVERIFY(FileIdentity::of(path("real/new.csv")) != FileIdentity::of(path("real/old.csv")));
        QVERIFY(!FileIdentity::of(path("none/new.csv")));
    }

    void whatHasNoEndIsNotRead()
    {
        QVERIFY(::mkfifo(QFile::encodeName(path("pipe")).constData(), 0600) == 0);
        QVERIFY(!checkReadsToAnEnd(path("pipe")));
        QVERIFY(!checkReadsToAnEnd(QStringLiteral("/dev/zero")));
        QVERIFY(checkReadsToAnEnd(write("a.txt", "")));
        QVERIFY(checkReadsToAnEnd(m_folder->path()));
        QVERIFY(checkReadsToAnEnd(path("not there")));
    }
};

BURIN_TEST(StagedFileTest)

} // namespace stagedFileTest

#include "StagedFileTest.moc"
