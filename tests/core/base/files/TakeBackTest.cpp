// SPDX-License-Identifier: Apache-2.0
#include "core/base/files/StagedFile.h"
#include "tests/support/faults/FileShim.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTest>

#include <cerrno>
#include <cstdio>

namespace takeBackTest {

using namespace core;

namespace {

constexpr const char* takenBack = "BURIN_TAKEN_BACK";

} // namespace

/// What works on the disk that fails: it replaces a file and takes that back. It tells on stdout
/// whether it was placed, and where what was replaced is.
class FileTakenBack : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void isReplacedAndTakenBack()
    {
        const QString target = qEnvironmentVariable(takenBack);
        if (target.isEmpty())
            QSKIP("TakeBackTest starts it");
        auto staged = StagedFile::create(target, true);
        QVERIFY(staged);
        {
            QFile file(staged->path());
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write("new") == 3);
        }
        if (!staged->commit()) {
            std::printf("REFUSED\n");
            return;
        }
        std::printf("PLACED %s\n", test::bytesOf(target).constData());
        std::printf("LEFT %s\n", qPrintable(staged->takeBack()));
    }
};

/// A file gets its name back also on file systems that cannot exchange two names.
class TakeBackTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatWasReplacedIsThere_data()
    {
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("last");
        QTest::addColumn<bool>("placed");
        QTest::addColumn<bool>("back");
        QTest::newRow("names are exchanged") << 0 << 0 << true << true;
        QTest::newRow("not when it is placed") << 1 << 1 << true << true;
        QTest::newRow("not when it is taken back") << 2 << 2 << true << true;
        // Where files have no second names, either.
        QTest::newRow("nor linked when it is placed") << 1 << 2 << true << true;
        QTest::newRow("nor linked when it is taken back") << 2 << 3 << true << true;
        // Where nothing is renamed at all.
        QTest::newRow("it is not placed") << 1 << 3 << false << true;
        QTest::newRow("it is not taken back") << 2 << 4 << true << false;
    }
    void whatWasReplacedIsThere()
    {
        QFETCH(const int, first);
        QFETCH(const int, last);
        QFETCH(const bool, placed);
        QFETCH(const bool, back);
        const test::WatchedHome home;
        const QString folder = home.path(QStringLiteral("as"));
        const QString target = QDir(folder).filePath(QStringLiteral("a.txt"));
        QVERIFY(QDir().mkpath(folder));
        {
            QFile old(target);
            QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
        }
        QProcessEnvironment environment = home.environment(
            {.under = folder, .calls = "rename", .first = first, .last = last, .error = EINVAL});
        environment.insert(QLatin1String(takenBack), target);
        QProcess process;
        process.setProcessEnvironment(environment);
        process.start(QCoreApplication::applicationFilePath(), {QStringLiteral("FileTakenBack")});
        QVERIFY(process.waitForFinished());
        const QByteArray output = process.readAllStandardOutput();
        QVERIFY2(process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0,
            output.constData());
        QCOMPARE(output.contains("PLACED new\n"), placed);
        QCOMPARE(output.contains("REFUSED\n"), !placed);
        int failed = 0;
        for (const test::FileEvent& event : home.events())
            failed += event.what == "fails" ? 1 : 0;
        QCOMPARE(failed, first == 0 ? 0 : last - first + 1);
        QStringList names = QDir(folder).entryList(QDir::Files | QDir::Hidden);
        if (back) {
            QCOMPARE(names, QStringList{QStringLiteral("a.txt")});
            QCOMPARE(test::bytesOf(target), QByteArray("old"));
            return;
        }
        // The name leads to the new one, and the old one is where it is told to be.
        const qsizetype at = output.indexOf("LEFT ") + 5;
        const QByteArray left = output.mid(at, output.indexOf('\n', at) - at);
        QCOMPARE(test::bytesOf(QFile::decodeName(left)), QByteArray("old"));
        QCOMPARE(test::bytesOf(target), QByteArray("new"));
        QCOMPARE(names.size(), 2);
    }
};

BURIN_TEST(FileTakenBack)
BURIN_TEST(TakeBackTest)

} // namespace takeBackTest

#include "TakeBackTest.moc"
