// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionPreview.h"
#include "core/session/EditSession.h"
#include "core/session/SessionKeyframes.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SessionFiles.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace sessionPreviewTest {

using namespace core;
using Condition = SessionPreview::Condition;

/// What a session file says about itself at a glance, without being changed by the look.
class SessionPreviewTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void tellsWhatItIs()
    {
        LoadedVolume volume = test::smallStudy();
        volume.volume.identity.seriesDescription = QStringLiteral("Bone 1.0");
        volume.volume.identity.modality = QStringLiteral("CT");
        volume.volume.identity.studyDate = QStringLiteral("2026-11-20");
        volume.volume.identity.patientName = QStringLiteral("SECRET^NAME");
        reference::ReferenceEngine engine;
        const QString file = path("a.burin");
        auto session = *EditSession::create(engine, volume, {.file = file});
        for (int i = 0; i < 5; ++i)
            QVERIFY(session->apply(test::drillAt(2.0 * i - 4.0)));
        QVERIFY(session->settle());
        QVERIFY(session->undo());
        session->setOrigin([at = QDateTime::currentDateTimeUtc()]() mutable {
            at = at.addSecs(1);
            return RowOrigin{.at = at, .author = {}, .program = {}};
        });
        session->keyframes().add(5, "older");
        session->keyframes().add(3, "newest");
        QVERIFY(session->settle());

        // As it lies there after a crash.
        const QString crashed = path("crashed.burin");
        for (const char* suffix : {"", "-wal"})
            QVERIFY(QFile::copy(file + QLatin1String(suffix), crashed + QLatin1String(suffix)));
        QCOMPARE(previewSession(file)->condition, Condition::InUse);
        session.reset();

        const QByteArray before = test::fingerprint(file) + test::fingerprint(crashed)
            + test::fingerprint(crashed + QStringLiteral("-wal"));
        const QStringList files = QDir(m_folder.path()).entryList(QDir::Files);
        for (const QString& each : {file, crashed}) {
            const Result<SessionPreview> preview = previewSession(each);
            QVERIFY(preview);
            QCOMPARE(preview->file, each);
            QCOMPARE(preview->condition, each == file ? Condition::Closed : Condition::Unfinished);
            QCOMPARE(preview->steps, std::int64_t(5));
            QCOMPARE(preview->thumbnail, QByteArray("newest"));
            QCOMPARE(preview->source.seriesDescription, QStringLiteral("Bone 1.0"));
            QCOMPARE(preview->source.modality, QStringLiteral("CT"));
            QCOMPARE(preview->source.studyDate, QStringLiteral("2026-11-20"));
            QVERIFY(preview->lastChange.secsTo(QDateTime::currentDateTime()) < 3600);
        }
        QCOMPARE(test::fingerprint(file) + test::fingerprint(crashed)
                + test::fingerprint(crashed + QStringLiteral("-wal")),
            before);
        QCOMPARE(QDir(m_folder.path()).entryList(QDir::Files), files);
        QFile whole(file);
        QVERIFY(whole.open(QIODevice::ReadOnly));
        QVERIFY(!whole.readAll().contains("SECRET"));

        const test::OtherWindow window(file);
        QCOMPARE(previewSession(file)->condition, Condition::InUse);
    }

    void whatIsNoSessionIsNotOffered()
    {
        QVERIFY(!previewSession(path("none.burin")));
        QFile text(path("text.burin"));
        QVERIFY(text.open(QIODevice::WriteOnly));
        text.write(QByteArray(5000, 'x'));
        text.close();
        QCOMPARE(previewSession(path("text.burin")).error().code, ErrorCode::UnsupportedFormat);
        QFile empty(path("empty.burin"));
        QVERIFY(empty.open(QIODevice::WriteOnly));
        empty.close();
        QVERIFY(!previewSession(path("empty.burin")));
    }
};

BURIN_TEST(SessionPreviewTest)

} // namespace sessionPreviewTest

#include "SessionPreviewTest.moc"
