// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "core/session/SessionKeyframes.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SessionFiles.h"
#include "ui/frame/SessionOffers.h"
#include "ui/frame/StartPage.h"

#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>

namespace sessionOffersUiTest {

using Condition = core::SessionPreview::Condition;

namespace {

constexpr int patience = 60000; ///< ms; only a hang takes that long

QDateTime at(const char* text)
{
    return QDateTime::fromString(QLatin1String(text), Qt::ISODate);
}

} // namespace

/// Which sessions the start page offers, in which words, and what becomes of those discarded.
class SessionOffersUiTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_folder;

    QString path(const QString& name) const { return m_folder->filePath(name); }

    /// A closed session, or one as a crash leaves it; changed last @p hoursAgo.
    void write(const char* description, int steps, int hoursAgo, bool crashed = false) const
    {
        const int number =
            int(QDir(m_folder->path()).entryList({QStringLiteral("*.burin")}).size());
        const QString file = path(QStringLiteral("%1.burin").arg(number));
        core::LoadedVolume volume = test::smallStudy();
        volume.volume.identity.seriesDescription = QString::fromUtf8(description);
        volume.volume.identity.studyDate = QStringLiteral("2026-11-%1").arg(10 + number);
        volume.volume.identity.patientName = QStringLiteral("SECRET^NAME");
        reference::ReferenceEngine engine;
        {
            const auto session =
                *core::EditSession::create(engine, volume, {.file = path(QStringLiteral("work"))});
            for (int i = 0; i < steps; ++i)
                QVERIFY(session->apply(test::newSegment(QString::number(i), 0)));
            QVERIFY(session->settle());
            if (crashed) {
                QVERIFY(QFile::copy(path(QStringLiteral("work")), file));
                QVERIFY(
                    QFile::copy(path(QStringLiteral("work-wal")), file + QStringLiteral("-wal")));
            }
        }
        if (crashed)
            QVERIFY(QFile::remove(path(QStringLiteral("work"))));
        else
            QVERIFY(QFile::rename(path(QStringLiteral("work")), file));
        const QDateTime time = QDateTime::currentDateTime().addSecs(-3600 * hoursAgo);
        for (const QString& part : {file, file + QStringLiteral("-wal")}) {
            QFile opened(part);
            if (opened.exists()) {
                QVERIFY(opened.open(QIODevice::ReadWrite));
                QVERIFY(opened.setFileTime(time, QFileDevice::FileModificationTime));
            }
        }
    }

    QByteArray fingerprints() const
    {
        QByteArray all;
        for (const QString& name : QDir(m_folder->path()).entryList(QDir::Files))
            all += name.toUtf8() + test::fingerprint(path(name));
        return all;
    }

    static QStringList words(const QWidget& offers)
    {
        QStringList list;
        for (const QLabel* label : offers.findChildren<QLabel*>()) {
            if (label->isVisible())
                list += label->text();
        }
        return list;
    }

    static QList<QPushButton*> buttons(const QWidget& offers, const char* text)
    {
        QList<QPushButton*> list;
        for (QPushButton* button : offers.findChildren<QPushButton*>()) {
            if (button->isVisible() && button->text() == QString::fromUtf8(text))
                list += button;
        }
        return list;
    }

    static void answer(const char* button, QString& question)
    {
        QTimer::singleShot(200, qApp, [button, &question] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            question = box->text() + QLatin1Char(' ') + box->informativeText();
            for (QAbstractButton* each : box->buttons()) {
                if (each->text() == QLatin1String(button))
                    return each->click();
            }
        });
    }

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        m_folder = std::make_unique<QTemporaryDir>();
    }

    void saysHowFarItIs_data()
    {
        QTest::addColumn<qint64>("steps");
        QTest::addColumn<bool>("unfinished");
        QTest::addColumn<QString>("changed");
        QTest::addColumn<QString>("words");
        QTest::newRow("today") << qint64(41) << true << QStringLiteral("2026-11-21T14:02:30")
                               << QStringLiteral("recovered: 41 steps, last at 14:02");
        QTest::newRow("closed") << qint64(1) << false << QStringLiteral("2026-11-21T09:00:00")
                                << QStringLiteral("continue: 1 step, last at 09:00");
        QTest::newRow("not today")
            << qint64(2) << true << QStringLiteral("2026-11-20T23:59:00")
            << QStringLiteral("recovered: 2 steps, last on 2026-11-20 at 23:59");
    }
    void saysHowFarItIs()
    {
        QFETCH(qint64, steps);
        QFETCH(bool, unfinished);
        QFETCH(QString, changed);
        core::SessionPreview preview;
        preview.steps = steps;
        preview.condition = unfinished ? Condition::Unfinished : Condition::Closed;
        preview.lastChange = QDateTime::fromString(changed, Qt::ISODate);
        QTEST(ui::SessionOffers::stateText(preview, at("2026-11-21T18:00:00")), "words");
    }

    void saysWhatItWasMadeOn()
    {
        core::SessionPreview preview;
        preview.source.path = QStringLiteral("/data/case/ct.nii.gz");
        QCOMPARE(ui::SessionOffers::studyText(preview), QStringLiteral("ct.nii.gz"));
        preview.source.modality = QStringLiteral("CT");
        preview.source.seriesDescription = QStringLiteral("Bone 1.0");
        preview.source.studyDate = QStringLiteral("2026-11-20");
        QCOMPARE(
            ui::SessionOffers::studyText(preview), QStringLiteral("Bone 1.0 · CT · 2026-11-20"));
    }

    void offersTheNewestFirst()
    {
        write("Oldest", 3, 50);
        write("Crashed", 4, 1, true);
        write("Without a step", 0, 0);
        write("Newest", 2, 0);
        write("In use", 5, 0);
        QFile text(path(QStringLiteral("text.burin")));
        QVERIFY(text.open(QIODevice::WriteOnly));
        text.write(QByteArray(5000, 'x'));
        text.close();
        const test::OtherWindow other(path(QStringLiteral("4.burin")));
        const QByteArray before = fingerprints();

        ui::SessionOffers offers;
        offers.resize(500, 400);
        QSignalSpy changed(&offers, &ui::SessionOffers::changed);
        offers.showFolder(m_folder->path());
        QVERIFY(changed.wait(patience));
        QCOMPARE(offers.count(), 3);
        QVERIFY(offers.isVisible());
        const QStringList said = words(offers);
        QVERIFY(said.at(1).startsWith(QStringLiteral("Newest · CT · 2026-11-13")));
        QVERIFY(said.at(2).startsWith(QStringLiteral("continue: 2 steps")));
        QVERIFY(said.at(3).startsWith(QStringLiteral("Crashed")));
        QVERIFY(said.at(4).startsWith(QStringLiteral("recovered: 4 steps")));
        QVERIFY(said.at(5).startsWith(QStringLiteral("Oldest")));
        QVERIFY(said.at(6).contains(QStringLiteral("last on ")));
        QVERIFY(!said.join(u' ').contains(QStringLiteral("SECRET")));
        QCOMPARE(fingerprints(), before);

        QSignalSpy asked(&offers, &ui::SessionOffers::openRequested);
        buttons(offers, "Open").at(1)->click();
        QCOMPARE(asked.value(0).value(0).toString(), path(QStringLiteral("1.burin")));
    }

    void showsTheNewestPicture()
    {
        QImage image(256, 170, QImage::Format_RGB888);
        image.fill(QColor(10, 200, 30));
        QByteArray png;
        QBuffer buffer(&png);
        QVERIFY(buffer.open(QIODevice::WriteOnly) && image.save(&buffer, "PNG"));
        write("Without", 2, 3);
        {
            reference::ReferenceEngine engine;
            const auto session = *core::EditSession::create(
                engine, test::smallStudy(), {.file = path(QStringLiteral("with.burin"))});
            QVERIFY(session->apply(test::addSegment("A")));
            session->keyframes().add(1, png);
            QVERIFY(session->settle());
        }
        ui::SessionOffers offers;
        QSignalSpy changed(&offers, &ui::SessionOffers::changed);
        offers.showFolder(m_folder->path());
        QVERIFY(changed.wait(patience));
        QCOMPARE(offers.count(), 2);
        const auto shown = offers.findChildren<QLabel*>(QStringLiteral("sessionThumbnail"));
        QCOMPARE(shown.size(), 1);
        const QImage small = shown.first()->pixmap().toImage();
        QCOMPARE(small.pixelColor(small.rect().center()), QColor(10, 200, 30));
    }

    void discardsAfterAQuestion()
    {
        write("One", 3, 2, true);
        write("Two", 4, 1);
        ui::SessionOffers offers;
        QSignalSpy changed(&offers, &ui::SessionOffers::changed);
        offers.showFolder(m_folder->path());
        QVERIFY(changed.wait(patience));
        const QByteArray before = fingerprints();
        QString question;
        answer("Keep", question);
        buttons(offers, "Discard …").at(1)->click();
        QVERIFY2(
            question.contains(QStringLiteral("Discard the session of One")), qPrintable(question));
        QVERIFY(question.contains(QStringLiteral("3 steps")));
        QCOMPARE(fingerprints(), before);
        answer("Discard", question);
        buttons(offers, "Discard …").at(1)->click();
        QVERIFY(changed.wait(patience));
        QCOMPARE(offers.count(), 1);
        QCOMPARE(
            QDir(m_folder->path()).entryList(QDir::Files), QStringList{QStringLiteral("1.burin")});
    }

    /// Another window has gone on with it, and closed it, since it was listed.
    void whatWentOnMeanwhileIsNotDiscarded()
    {
        write("One", 3, 2);
        ui::SessionOffers offers;
        QSignalSpy changed(&offers, &ui::SessionOffers::changed);
        offers.showFolder(m_folder->path());
        QVERIFY(changed.wait(patience));
        QFile session(path(QStringLiteral("0.burin")));
        QVERIFY(session.open(QIODevice::ReadWrite));
        QVERIFY(
            session.setFileTime(QDateTime::currentDateTime(), QFileDevice::FileModificationTime));
        session.close();
        QString question;
        answer("Discard", question);
        buttons(offers, "Discard …").at(0)->click();
        // It is listed as it is now.
        QVERIFY(changed.wait(patience));
        QVERIFY(!question.isEmpty());
        QCOMPARE(offers.count(), 1);
        QVERIFY(session.exists());
        QTRY_COMPARE(buttons(offers, "Discard …").size(), 1); // its layout shows it
        answer("Discard", question);
        buttons(offers, "Discard …").at(0)->click();
        QVERIFY(changed.wait(patience));
        QCOMPARE(offers.count(), 0);
        QVERIFY(!session.exists());
    }

    void manyUnfoldOnRequest()
    {
        for (int i = 0; i < ui::SessionOffers::shownAtFirst + 2; ++i)
            write("Many", i + 1, i);
        ui::SessionOffers offers;
        QSignalSpy changed(&offers, &ui::SessionOffers::changed);
        offers.showFolder(m_folder->path());
        QVERIFY(changed.wait(patience));
        QCOMPARE(buttons(offers, "Open").size(), ui::SessionOffers::shownAtFirst);
        auto* more = offers.findChild<QToolButton*>();
        QCOMPARE(more->text(), QStringLiteral("Show 2 more"));
        more->click();
        QTRY_COMPARE(buttons(offers, "Open").size(), ui::SessionOffers::shownAtFirst + 2);
        offers.showFolder(QString());
        QVERIFY(changed.wait(patience));
        QVERIFY(!offers.isVisible());
    }

    void theStartPageHoldsThem_data()
    {
        QTest::addColumn<int>("sessions");
        QTest::addColumn<QSize>("size");
        for (const int sessions : {0, 1, 6}) {
            for (const QSize& size : {QSize(1280, 720), QSize(1920, 1080), QSize(900, 700)})
                QTest::addRow("%d in %dx%d", sessions, size.width(), size.height())
                    << sessions << size;
        }
    }
    void theStartPageHoldsThem()
    {
        QFETCH(int, sessions);
        QFETCH(QSize, size);
        const char* const names[]{"Head, bone 1.0", "CTA Kopf-Hals 0.6 Bv40 Q3 (iodine)",
            "T1 MPRAGE sagittal", "Abdomen portal venous", "Lung 1.0 Br64", ""};
        for (int i = 0; i < sessions; ++i)
            write(names[i], 1 + 40 * i, 13 * i, i % 3 == 0);
        test::WindowFixture window(test::headFirstSupine(), size);
        window.workspace.setSession(nullptr);
        auto& offers = *window.window.findChild<ui::SessionOffers*>();
        QSignalSpy changed(&offers, &ui::SessionOffers::changed);
        window.window.offerSessionsIn(m_folder->path());
        QVERIFY(changed.wait(patience));
        QCOMPARE(offers.count(), sessions);
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        const auto& page = *window.window.findChild<ui::StartPage*>();
        for (const QPushButton* button : page.findChildren<QPushButton*>()) {
            if (button->isVisible())
                QVERIFY(
                    page.rect().contains(QRect(button->mapTo(&page, QPoint()), button->size())));
        }
        // At usual sizes nothing has to be scrolled for.
        if (size.width() > 1000)
            QCOMPARE(page.height(), page.parentWidget()->height());
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (folder.isEmpty())
            return;
        const QPixmap picture = window.window.grab();
        QVERIFY(picture.save(QDir(folder).filePath(
            QStringLiteral("start-%1-%2.png").arg(sessions).arg(size.width()))));
        if (sessions == 6 && size.width() == 1280) // the one that the manual shows
            QVERIFY(picture.save(QDir(folder).filePath(QStringLiteral("recovery.png"))));
    }
};

BURIN_WINDOW_TEST(SessionOffersUiTest)

} // namespace sessionOffersUiTest

#include "SessionOffersUiTest.moc"
