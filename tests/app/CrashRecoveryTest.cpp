// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"
#include "core/edits/EditQuantise.h"
#include "core/nifti/NiftiWriter.h"
#include "core/session/EditSession.h"
#include "core/study/StudyLoader.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/EngineCases.h"
#include "tests/support/SmallStudy.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <map>

using namespace core;

/// kill -9 in the middle of `burin run`: what was acknowledged is there, and nothing is torn.
class CrashRecoveryTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void nothingAcknowledgedIsLost_data();
    void nothingAcknowledgedIsLost();

private:
    /// What a run of `burin` printed about rows: hash by row.
    using Acknowledged = std::map<RowId, QByteArray>;
    [[nodiscard]] static Acknowledged rowsIn(const QByteArray& output);
    [[nodiscard]] QStringList runArguments(const QString& session) const;

    QTemporaryDir m_folder;
    QString m_study;
    QString m_recipe;
    std::vector<Edit> m_edits;
    Acknowledged m_expected; ///< of a run that nobody disturbed
    qint64 m_firstRowMs = 0; ///< until its first row
    qint64 m_durationMs = 0;
};

CrashRecoveryTest::Acknowledged CrashRecoveryTest::rowsIn(const QByteArray& output)
{
    Acknowledged rows;
    // A line that was cut off by the end acknowledges nothing.
    for (const QByteArray& line : output.left(output.lastIndexOf('\n') + 1).split('\n')) {
        const QJsonObject object = QJsonDocument::fromJson(line).object();
        if (object[QStringLiteral("row")].isDouble())
            rows[RowId(object[QStringLiteral("row")].toInteger())] =
                object[QStringLiteral("hash")].toString().toLatin1();
    }
    return rows;
}

QStringList CrashRecoveryTest::runArguments(const QString& session) const
{
    return {QStringLiteral("run"), m_recipe, QStringLiteral("--study"), m_study,
        QStringLiteral("--session"), session};
}

void CrashRecoveryTest::initTestCase()
{
    QVERIFY(m_folder.isValid());
    const LoadedVolume small = test::smallStudy();
    std::vector<std::int16_t> values;
    for (const std::uint16_t code : small.codes)
        values.push_back(std::int16_t(small.volume.encoding.value(code)));
    m_study = m_folder.filePath(QStringLiteral("small.nii.gz"));
    QVERIFY(writeNifti(
        m_study, {.geometry = small.volume.geometry, .voxels = values, .description = {}}));

    m_edits = {test::addSegment("Brain"), test::addSegment("Skull"), test::seedInBrain(1),
        test::seedInBone(2)};
    for (int i = 0; i < 30; ++i) {
        m_edits.push_back(test::drillAt(-12.0 + 0.8 * i));
        if (i % 3 == 0)
            m_edits.push_back(test::growBrain(1));
        if (i % 3 == 1)
            m_edits.push_back(test::growBone(2));
    }
    QJsonArray edits;
    for (Edit& edit : m_edits) {
        edit = quantised(edit);
        edits.push_back(editToJson(edit));
    }
    m_recipe = m_folder.filePath(QStringLiteral("recipe.json"));
    QFile recipe(m_recipe);
    QVERIFY(recipe.open(QIODevice::WriteOnly));
    recipe.write(QJsonDocument(QJsonObject{{QStringLiteral("edits"), edits}}).toJson());
    recipe.close();

    QProcess burin;
    QElapsedTimer clock;
    clock.start();
    burin.start(QStringLiteral(BURIN_PROGRAM),
        runArguments(m_folder.filePath(QStringLiteral("whole.burin"))));
    QVERIFY(burin.waitForReadyRead(120000));
    m_firstRowMs = clock.elapsed();
    QVERIFY(burin.waitForFinished(300000));
    m_durationMs = clock.elapsed();
    QVERIFY2(burin.exitCode() == 0, burin.readAllStandardError().constData());
    m_expected = rowsIn(burin.readAllStandardOutput());
    QVERIFY(m_expected.size() > 30);
}

void CrashRecoveryTest::nothingAcknowledgedIsLost_data()
{
    QTest::addColumn<int>("afterRows");
    QTest::addColumn<int>("thenMicroseconds");
    QTest::addRow("before anything") << 0 << 0;
    test::Random random(std::uint32_t(QDateTime::currentMSecsSinceEpoch()));
    const int last = int(m_expected.size()) - 2;
    for (int i = 0; i < (test::longRun() ? 60 : 7); ++i) {
        // From the start on, or from a row on: within about what two rows take.
        const int rows = test::randomInt(random, 0, last);
        const auto perRow =
            int((m_durationMs - m_firstRowMs) * 1000 / qint64(m_expected.size())) + 1;
        const int micro = rows == 0 ? test::randomInt(random, 0, int(m_firstRowMs) * 1000)
                                    : test::randomInt(random, 0, 2 * perRow);
        QTest::addRow("%d: after %d rows, %d µs", i, rows, micro) << rows << micro;
    }
}

void CrashRecoveryTest::nothingAcknowledgedIsLost()
{
    QFETCH(int, afterRows);
    QFETCH(int, thenMicroseconds);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("crashed.burin"));
    QProcess burin;
    burin.start(QStringLiteral(BURIN_PROGRAM), runArguments(file));
    QVERIFY(burin.waitForStarted());
    QByteArray output;
    while (int(rowsIn(output).size()) < afterRows) {
        QVERIFY2(burin.waitForReadyRead(60000), burin.readAllStandardError().constData());
        output += burin.readAllStandardOutput();
    }
    QTest::qSleep(thenMicroseconds / 1000);
    burin.kill();
    QVERIFY(burin.waitForFinished(30000));
    output += burin.readAllStandardOutput();
    const Acknowledged acknowledged = rowsIn(output);
    for (const auto& [row, hash] : acknowledged)
        QCOMPARE(hash, m_expected.at(row));

    // Nothing was promised before the first row: there may be no session yet.
    if (!QFileInfo::exists(file)) {
        QVERIFY(acknowledged.empty());
        return;
    }
    Result<LoadedVolume> volume = loadVolume(m_study);
    QVERIFY(volume);
    reference::ReferenceEngine oracle;
    {
        auto session = EditSession::open(oracle, *volume, file);
        if (!session && acknowledged.empty())
            return; // killed while the file was being made
        QVERIFY2(session,
            session ? "" : qPrintable(session.error().arguments.join(QStringLiteral(": "))));
        QVERIFY((*session)->settle());
        const std::vector<HistoryRow>& rows = (*session)->history().rows();
        QVERIFY2(rows.size() >= acknowledged.size(),
            qPrintable(QStringLiteral("%1 of %2 rows are there")
                           .arg(rows.size())
                           .arg(acknowledged.size())));
        // Edits go one by one, so no more than one more had begun.
        QVERIFY(rows.size() <= acknowledged.size() + 1);
        for (const HistoryRow& row : rows)
            QCOMPARE(row.stateHash, m_expected.at(row.id));
        QCOMPARE((*session)->history().position(), RowId(rows.size()));

        // And it goes on from there as if nothing had been.
        std::size_t done = 0;
        std::size_t next = 0;
        for (; next < m_edits.size() && done < rows.size(); ++next)
            done += editToJson(rows[done].edit) == editToJson(m_edits[next]) ? 1 : 0;
        QCOMPARE(done, rows.size());
        for (; next < m_edits.size(); ++next)
            QVERIFY((*session)->apply(m_edits[next]));
        QVERIFY((*session)->settle());
        QCOMPARE((*session)->history().rows().size(), m_expected.size());
        QCOMPARE((*session)->stateHash(), m_expected.rbegin()->second);
    }
    QProcess verify;
    verify.start(QStringLiteral(BURIN_PROGRAM),
        {QStringLiteral("replay"), file, QStringLiteral("--verify")});
    QVERIFY(verify.waitForFinished(120000));
    QVERIFY2(verify.exitCode() == 0, verify.readAllStandardError().constData());
}

QTEST_GUILESS_MAIN(CrashRecoveryTest)
#include "CrashRecoveryTest.moc"
