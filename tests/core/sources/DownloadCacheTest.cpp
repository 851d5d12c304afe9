// SPDX-License-Identifier: Apache-2.0
#include "core/sources/DownloadCache.h"

#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace downloadCacheTest {

namespace {

constexpr qint64 entryBytes = 10000;

} // namespace

/// What is kept of downloads: bounded, the longest unused goes first, nothing that is open.
class DownloadCacheTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void pathsTellNobody();
    void longestUnusedGoesFirst();
    void whatLinksLeadToStays();
    void openOnesStay();
    void deadHoldersDoNotCount();
    void brokenDownloadsGoWithAll();

private:
    /// An entry that was used so many days ago.
    QString add(const core::DownloadCache& cache, const char* uid, int daysAgo) const
    {
        const QString path = cache.pathOf(QStringLiteral("A@b:104"),
            {.studyUid = QStringLiteral("1.2"), .seriesUid = QLatin1String(uid)});
        QDir().mkpath(path);
        QFile file(path + QStringLiteral("/1.dcm"));
        if (!file.open(QIODevice::WriteOnly) || file.write(QByteArray(entryBytes, 'x')) < 0)
            return {};
        file.close();
        cache.touch(path);
        QFile mark(path + QStringLiteral(".used"));
        if (!mark.open(QIODevice::ReadWrite)
            || !mark.setFileTime(QDateTime::currentDateTimeUtc().addDays(-daysAgo),
                QFileDevice::FileModificationTime))
            return {};
        return path;
    }
};

void DownloadCacheTest::pathsTellNobody()
{
    const QTemporaryDir folder;
    const core::DownloadCache cache(folder.filePath(QStringLiteral("cache")));
    QVERIFY(cache.prepare().has_value());
    QCOMPARE(QFileInfo(folder.filePath(QStringLiteral("cache"))).permissions()
            & (QFile::ReadGroup | QFile::ReadOther),
        QFile::Permissions());
    const QString a = cache.pathOf(
        QStringLiteral("A@b:104"), {.studyUid = QStringLiteral("1.2"), .seriesUid = {}});
    const QString b = cache.pathOf(
        QStringLiteral("A@c:104"), {.studyUid = QStringLiteral("1.2"), .seriesUid = {}});
    const QString c = cache.pathOf(QStringLiteral("A@b:104"),
        {.studyUid = QStringLiteral("1"), .seriesUid = QStringLiteral(".2")});
    QVERIFY(a != b && a != c && b != c);
    QVERIFY(!a.contains(QLatin1String("1.2")));
    QCOMPARE(cache.entryOf(a + QStringLiteral("/x/y.dcm")), a);
    QCOMPARE(cache.entryOf(folder.filePath(QStringLiteral("cachet/x"))), QString());
    QCOMPARE(cache.entryOf(folder.filePath(QStringLiteral("cache"))), QString());
    QCOMPARE(cache.entryOf(folder.filePath(QStringLiteral("cache/../x"))), QString());
}

void DownloadCacheTest::longestUnusedGoesFirst()
{
    const QTemporaryDir folder;
    const core::DownloadCache cache(folder.path());
    const QString old = add(cache, "1", 3);
    const QString older = add(cache, "2", 5);
    const QString young = add(cache, "3", 1);
    QVERIFY(!old.isEmpty() && !older.isEmpty() && !young.isEmpty());
    QCOMPARE(cache.bytes(), 3 * entryBytes);
    QCOMPARE(cache.entries().size(), std::size_t(3));
    QCOMPARE(cache.entries().front().path, young);
    QCOMPARE(cache.shrinkTo(3 * entryBytes), 0);
    QCOMPARE(cache.shrinkTo(2 * entryBytes), 1);
    QVERIFY(!QFile::exists(older));
    // To be used makes young again.
    cache.touch(old);
    QCOMPARE(cache.shrinkTo(2 * entryBytes - 1), 1);
    QVERIFY(QFile::exists(old));
    QVERIFY(!QFile::exists(young));
    QCOMPARE(cache.clear(), 1);
    QCOMPARE(cache.bytes(), 0);
    QVERIFY(QDir(folder.path()).isEmpty());
}

/// A large copy that somebody has moved to another disk, with a link in its place.
void DownloadCacheTest::whatLinksLeadToStays()
{
    const QTemporaryDir folder;
    const QTemporaryDir other;
    const core::DownloadCache cache(folder.path());
    const QString moved = add(cache, "1", 5);
    const QString there = other.filePath(QStringLiteral("study"));
    QVERIFY(QDir().rename(moved, there));
    QVERIFY(QFile::link(there, moved));
    const QString gathering = folder.filePath(QStringLiteral(".study.burin-download"));
    QVERIFY(QFile::link(there, gathering));
    QVERIFY(!add(cache, "2", 3).isEmpty());
    QCOMPARE(cache.clear(), 1);
    QCOMPARE(QFileInfo(there + QStringLiteral("/1.dcm")).size(), entryBytes);
    QVERIFY(QFileInfo(moved).isSymLink() && QFileInfo(gathering).isSymLink());
}

void DownloadCacheTest::openOnesStay()
{
    const QTemporaryDir folder;
    const core::DownloadCache cache(folder.path());
    const QString older = add(cache, "1", 5);
    const QString old = add(cache, "2", 3);
    {
        const core::DownloadCache::Hold first = cache.hold(older);
        const core::DownloadCache::Hold second = cache.hold(older);
        QVERIFY(first && second);
        QVERIFY(cache.isHeld(older));
        QVERIFY(!cache.isHeld(old));
        // Used as of now, and open: the other goes even though all should.
        QCOMPARE(cache.clear(), 1);
        QVERIFY(QFile::exists(older));
        QVERIFY(!QFile::exists(old));
    }
    QVERIFY(!cache.isHeld(older));
    QVERIFY(!cache.hold(old));
    QCOMPARE(cache.clear(), 1);
    QVERIFY(QDir(folder.path()).isEmpty());
}

void DownloadCacheTest::deadHoldersDoNotCount()
{
    const QTemporaryDir folder;
    const core::DownloadCache cache(folder.path());
    const QString path = add(cache, "1", 5);
    // As a process leaves it that was killed: no process has that number.
    QFile mark(path + QStringLiteral(".open-99999999-1"));
    QVERIFY(mark.open(QIODevice::WriteOnly));
    mark.write(QByteArray("99999999\nburin\n") + QSysInfo::machineHostName().toUtf8() + "\n"
        + QSysInfo::machineUniqueId() + "\n" + QSysInfo::bootUniqueId() + "\n");
    mark.close();
    QCOMPARE(cache.clear(), 1);
    QVERIFY(!QFile::exists(path));
    QVERIFY(QDir(folder.path()).isEmpty());
}

void DownloadCacheTest::brokenDownloadsGoWithAll()
{
    const QTemporaryDir folder;
    const core::DownloadCache cache(folder.path());
    const QString path = folder.filePath(QStringLiteral(".abc.burin-download"));
    QVERIFY(QDir().mkpath(path));
    QCOMPARE(cache.shrinkTo(1), 0);
    QVERIFY(QFile::exists(path));
    QCOMPARE(cache.clear(), 0);
    QVERIFY(!QFile::exists(path));
}

BURIN_TEST(DownloadCacheTest)

} // namespace downloadCacheTest

#include "DownloadCacheTest.moc"
