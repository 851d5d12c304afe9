// SPDX-License-Identifier: Apache-2.0
#include "core/archive/UnpackedArchive.h"
#include "core/archive/ArchiveReader.h"
#include "core/base/files/FolderCache.h"
#include "core/study/StudyLoader.h"
#include "tests/support/faults/FileShim.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SmallSeries.h"
#include "tests/support/servers/Python.h"

#include <QDir>
#include <QDirIterator>
#include <QTemporaryDir>
#include <QTest>

#include <cerrno>

namespace unpackedArchiveTest {

namespace {

QStringList filesIn(const QString& folder)
{
    QStringList names;
    QDirIterator files(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (files.hasNext())
        names += QDir(folder).relativeFilePath(files.next());
    names.sort();
    return names;
}

} // namespace

/// Studies in zip and tar files; archives that want to do harm.
class UnpackedArchiveTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        test::SmallSeries series;
        series.size = {11, 7, 6};
        series.placeEvenly({-40.25, -31.5, 812.125}, {0, 0, 2.5});
        const core::Volume written = series.write(path("images"));
        const auto loaded = core::loadVolume(written.sourcePath);
        QVERIFY(loaded);
        m_volume = loaded->volume;
        QDir(m_folder.path()).mkpath(QStringLiteral("archives"));
        const test::ScriptOutput made =
            test::runScript(QStringLiteral("make_archives.py"), {path("images"), path("archives")});
        QVERIFY2(made.exitCode == 0, qPrintable(made.errors));
    }
    void init()
    {
        m_cache = std::make_unique<QTemporaryDir>();
        core::setArchiveCacheFolder(m_cache->path());
    }
    void cleanup() { core::setArchiveCacheFolder({}); }

    void studiesOpen_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("zip") << QStringLiteral("study.zip");
        QTest::newRow("tar") << QStringLiteral("study.tar.gz");
    }

    void studiesOpen()
    {
        QFETCH(QString, name);
        const auto loaded = core::loadVolume(archive(name));
        QVERIFY(loaded);
        QCOMPARE(loaded->volume.voxelsSha256, m_volume.voxelsSha256);
        QCOMPARE(loaded->volume.sourcePath, archive(name));
        // What it was made of is there for the check of an export.
        QVERIFY(QFile::exists(loaded->volume.sources.front().file));
        // The second time nothing is unpacked.
        const QDateTime written = QFileInfo(loaded->volume.sources.front().file).lastModified();
        const auto again = core::loadVolume(archive(name));
        QVERIFY(again);
        QCOMPARE(again->volume.sources.front().file, loaded->volume.sources.front().file);
        QCOMPARE(QFileInfo(again->volume.sources.front().file).lastModified(), written);
    }

    void namesStay()
    {
        const auto folder = core::unpackedArchive(archive(QStringLiteral("study.zip")), {});
        QVERIFY(folder);
        QVERIFY(QFile::exists(*folder + QStringLiteral("/Müller^Ünal/readme.txt")));
        QCOMPARE(filesIn(*folder).size(), 7);
    }

    void nothingLeadsElsewhere()
    {
        const auto folder = core::unpackedArchive(archive(QStringLiteral("climbs.zip")), {});
        QVERIFY(folder);
        const QStringList expected{QStringLiteral("a/b.txt"), QStringLiteral("abs.txt"),
            QStringLiteral("back.txt"), QStringLiteral("same"), QStringLiteral("same.2"),
            QStringLiteral("up.txt")};
        QCOMPARE(filesIn(*folder), expected);
        const auto links = core::unpackedArchive(archive(QStringLiteral("links.tar")), {});
        QVERIFY(links);
        QCOMPARE(filesIn(*links), QStringList{QStringLiteral("link/through.txt")});
        QVERIFY(!QFile::exists(path("archives/through.txt")));
    }

    void refused_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("reason");
        const auto row = [](const char* name, core::ErrorCode code, const char* reason) {
            QTest::newRow(name) << QString::fromLatin1(name) << int(code)
                                << QString::fromLatin1(reason);
        };
        row("bomb.zip", core::ErrorCode::UnsupportedFormat, "100 times");
        row("cut.zip", core::ErrorCode::FileUnreadable, "cut short");
        row("locked.zip", core::ErrorCode::FileUnreadable, "password");
        row("other.zip", core::ErrorCode::FileUnreadable, "damaged");
        row("links.tar", core::ErrorCode::UnsupportedFormat, "");
        row("empty.zip", core::ErrorCode::FolderEmpty, "");
    }

    void refused()
    {
        QFETCH(QString, name);
        QFETCH(int, code);
        QFETCH(QString, reason);
        const auto study = core::scanStudies(archive(name));
        QVERIFY(!study);
        QCOMPARE(int(study.error().code), code);
        // A file of it is named as lying in it.
        QVERIFY(study.error().arguments.value(0).startsWith(archive(name)));
        QVERIFY2(study.error().arguments.value(1).contains(reason),
            qPrintable(study.error().arguments.value(1)));
        // Nothing half unpacked stays behind, nor a folder without anything in it.
        if (name != QLatin1String("links.tar"))
            QVERIFY(QDir(m_cache->path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).isEmpty());
    }

    void cancelled()
    {
        core::Progress progress;
        progress.cancel();
        const auto study = core::Study::scan(archive(QStringLiteral("study.zip")), progress);
        QVERIFY(!study);
        QCOMPARE(study.error().code, core::ErrorCode::Cancelled);
        QVERIFY(QDir(m_cache->path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).isEmpty());
    }

    /// What this process uses stays; what nobody uses goes, the oldest first.
    void theCacheIsBounded()
    {
        const auto zip = core::unpackedArchive(archive(QStringLiteral("study.zip")), {});
        const auto tar = core::unpackedArchive(archive(QStringLiteral("study.tar.gz")), {}, 1);
        QVERIFY(zip && tar);
        QVERIFY(QDir(*zip).exists() && QDir(*tar).exists());
        // As if the process had ended.
        core::setArchiveCacheFolder(m_cache->path());
        const auto again = core::unpackedArchive(archive(QStringLiteral("study.tar.gz")), {}, 1);
        QVERIFY(again);
        QVERIFY(!QDir(*zip).exists());
        QVERIFY(QDir(*tar).exists());
    }

    /// A process that was killed while it made its lock left one in which it did not say who it is.
    void aLockWithoutANameIsNobodys()
    {
        const auto first = core::unpackedArchive(archive(QStringLiteral("study.zip")), {});
        QVERIFY(first);
        core::setArchiveCacheFolder(m_cache->path());
        QVERIFY(QDir(*first).removeRecursively());
        QFile lock(core::FolderCache::gatheringPlaceOf(*first) + QStringLiteral(".lock"));
        QVERIFY(lock.open(QIODevice::WriteOnly));
        lock.close();
        const auto again = core::unpackedArchive(archive(QStringLiteral("study.zip")), {});
        QVERIFY(again);
        QCOMPARE(*again, *first);
        QCOMPARE(filesIn(*again).size(), 7);
    }

    /// Nobody could tell later what was lost of it.
    void whatTheDiskRefusesIsNotKept()
    {
        const test::WatchedHome home;
        const QStringList words{QStringLiteral("info"), archive(QStringLiteral("study.zip"))};
        const test::Outcome refused = home.burin(words,
            {.under = home.path(QStringLiteral("cache")),
                .calls = "sync",
                .first = 1,
                .last = 1 << 30,
                .error = EIO});
        QVERIFY(refused.status > 0);
        QVERIFY2(refused.complaint.contains(words.last()), qPrintable(refused.complaint));
        const QDir cache(home.path(QStringLiteral("cache/burin/archives")));
        QVERIFY(cache.exists());
        const auto folders = QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot;
        QVERIFY(cache.entryList(folders).isEmpty());
        const test::Outcome again = home.burin(words);
        QVERIFY2(again.status == 0, qPrintable(again.complaint));
        QCOMPARE(cache.entryList(folders).size(), 1);
    }

    void aChangedArchiveIsAnother()
    {
        const QString copy = path("copy.zip");
        QVERIFY(QFile::copy(archive(QStringLiteral("climbs.zip")), copy));
        const auto before = core::unpackedArchive(copy, {});
        QVERIFY(before && QFile::remove(copy));
        QVERIFY(QFile::copy(archive(QStringLiteral("study.zip")), copy));
        const auto after = core::unpackedArchive(copy, {});
        QVERIFY(after);
        QVERIFY(*after != *before);
        QCOMPARE(filesIn(*after).size(), 7);
    }

    void volumesThatArePackedAreNoArchives()
    {
        for (const char* name : {"a.nii.gz", "a.nrrd", "a.dcm"}) {
            QFile file(path(name));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write("\x1f\x8b\x08 packed") > 0);
            file.close();
            QVERIFY(!core::isArchive(path(name)));
        }
        QVERIFY(!core::isArchive(m_folder.path()));
    }

private:
    [[nodiscard]] QString path(const char* name) const
    {
        return m_folder.filePath(QLatin1String(name));
    }
    [[nodiscard]] QString archive(const QString& name) const
    {
        return m_folder.filePath(QStringLiteral("archives/") + name);
    }

    QTemporaryDir m_folder;
    std::unique_ptr<QTemporaryDir> m_cache;
    core::Volume m_volume;
};

BURIN_TEST(UnpackedArchiveTest)

} // namespace unpackedArchiveTest

#include "UnpackedArchiveTest.moc"
