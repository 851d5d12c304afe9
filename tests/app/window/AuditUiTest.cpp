// SPDX-License-Identifier: Apache-2.0
#include "app/window/Application.h"
#include "core/session/SessionKeyframes.h"
#include "core/session/SessionStorage.h"
#include "core/sessionfile/SessionFile.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/series/SyntheticSeries.h"
#include "ui/base/AuthorName.h"
#include "ui/dialogs/AuthorDialog.h"
#include "ui/panels/history/HistoryTimeline.h"
#include "ui/panels/history/KeyframePopup.h"
#include "ui/report/AuditPages.h"
#include "ui/report/AuditSaver.h"
#include "ui/views/ViewGrid.h"
#include "ui/views/VolumeView.h"
#include "ui/window/MainWindow.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QLineEdit>
#include <QPainter>
#include <QRegularExpression>
#include <QSemaphore>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

namespace auditUiTest {

namespace {

constexpr int patience = 300000; ///< ms; only a hang takes that long
constexpr int manualPixels = 900; ///< how wide the manual shows a page

/// A ball of bone in air.
QString writeBall(const QString& folder)
{
    test::SyntheticSeries series;
    series.size = {48, 48, 40};
    series.spacing = {2.0, 2.0};
    series.origin = {-47.0, -47.0, -48.75};
    series.step = {0.0, 0.0, 2.5};
    series.stored = [](const glm::ivec3& index) {
        const glm::dvec3 mm =
            (glm::dvec3(index) - glm::dvec3(23.5, 23.5, 19.5)) * glm::dvec3(2.0, 2.0, 2.5);
        return glm::length(mm) < 40.0 ? 1924 : 34;
    };
    test::writeSeries(series, folder);
    return folder;
}

QDir screenshots()
{
    return QDir(qEnvironmentVariable("BURIN_SCREENSHOTS"));
}

bool wantsScreenshots()
{
    return qEnvironmentVariableIsSet("BURIN_SCREENSHOTS");
}

/// Whether anything is to be seen in a picture.
bool showsSomething(const QImage& image)
{
    int least = 255;
    int most = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            least = std::min(least, image.pixelColor(x, y).lightness());
            most = std::max(most, image.pixelColor(x, y).lightness());
        }
    }
    return most - least > 60;
}

} // namespace

/// The audit trail in the real window: who, pictures of the real 3D view, the report of a session
/// that is open. With BURIN_SCREENSHOTS on the demonstration study, for the manual.
class AuditUiTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    std::unique_ptr<app::Application> m_application;

    [[nodiscard]] ui::MainWindow& window() { return m_application->window(); }
    [[nodiscard]] core::EditSession& session() { return *m_application->workspace().session(); }
    [[nodiscard]] ui::VolumeView& view() { return window().views().volume(); }
    [[nodiscard]] static bool wait(const std::function<bool()>& condition)
    {
        return QTest::qWaitFor(condition, patience);
    }
    [[nodiscard]] bool waitUntilDrawn()
    {
        return test::waitUntilDrawn(window(), m_application->workspace(), patience);
    }
    /// From where the 3D view looks, at a part of its height right of and above the middle.
    [[nodiscard]] core::Edit drill(double right, double up)
    {
        const ui::Camera& camera = view().camera();
        std::vector<core::PenSample> samples;
        for (int i = 0; i <= 6; ++i)
            samples.push_back({.xMm = (right + 0.01 * i) * camera.heightMm,
                .yMm = up * camera.heightMm,
                .pressure = 1.0,
                .tSeconds = 0.01 * i});
        return test::drillWith({.view = core::OrthographicView{.eyeLps = camera.eyeLps(),
                                    .targetLps = camera.targetLps,
                                    .up = camera.up,
                                    .heightMm = camera.heightMm},
            .radiusMm = camera.heightMm / 20.0,
            .depthMm = camera.heightMm / 10.0,
            .surfaceThreshold = m_application->workspace().volumeDisplay().surfaceThreshold,
            .samples = samples});
    }
    [[nodiscard]] bool apply(const core::Edit& edit)
    {
        return bool(session().apply(edit)) && waitUntilDrawn();
    }
    [[nodiscard]] QImage keyframe(core::RowId row)
    {
        QImage image;
        QSemaphore done;
        session().keyframes().fetch(row, [&](const QByteArray& png) {
            image.loadFromData(png, "PNG");
            done.release();
        });
        done.acquire();
        return image;
    }
    [[nodiscard]] ui::HistoryTimeline& timeline()
    {
        return *window().findChild<ui::HistoryTimeline*>();
    }
    void point(int step)
    {
        const QPointF at(timeline().xOf(step), timeline().height() - 8);
        QMouseEvent event(QEvent::MouseMove, at, timeline().mapToGlobal(at), Qt::NoButton,
            Qt::NoButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&timeline(), &event);
    }
    [[nodiscard]] QString save(const char* name)
    {
        auto* saver = window().findChild<ui::AuditSaver*>();
        QSignalSpy saved(saver, &ui::AuditSaver::saved);
        QSignalSpy failed(saver, &ui::AuditSaver::failed);
        const QString path = m_folder.filePath(QLatin1String(name));
        saver->save(path);
        static_cast<void>(wait([&] { return !saved.isEmpty() || !failed.isEmpty(); }));
        return saved.isEmpty() ? QString() : path;
    }
    void paintPages()
    {
        core::Result<core::AuditReport> report;
        session().storage().audit([&report](const auto& made) { report = made; });
        static_cast<void>(session().settle());
        const QSizeF a4(1240, 1754);
        const ui::AuditPages pages(ui::AuditTexts::of(*report), a4);
        for (int page = 0; page < pages.count(); ++page) {
            QImage image(a4.toSize(), QImage::Format_RGB32);
            image.fill(Qt::white);
            QPainter painter(&image);
            pages.paint(painter, page);
            painter.end();
            // The manual shows the last one: steps of every kind, and pictures below them.
            if (page + 1 == pages.count())
                image.scaledToWidth(manualPixels, Qt::SmoothTransformation)
                    .save(screenshots().filePath(QStringLiteral("audit-report.png")));
            else
                image.save(screenshots().filePath(QStringLiteral("report-%1.png").arg(page + 1)));
        }
    }

private Q_SLOTS:
    void initTestCase()
    {
        qputenv("XDG_STATE_HOME", m_folder.filePath(QStringLiteral("state")).toUtf8());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
            m_folder.filePath(QStringLiteral("settings")));
        QCoreApplication::setApplicationName(QStringLiteral("burin"));
        QCoreApplication::setOrganizationName(QStringLiteral("burin"));
        QCoreApplication::setApplicationVersion(QStringLiteral("9.8.7"));
    }
    void init() { test::failOnUnexpectedMessages(); }

    void whoWhatWhenAndAPicture()
    {
        QCOMPARE(ui::authorName(), QString()); // never the login
        m_application = std::move(*app::Application::create());
        window().resize(1280, 800);
        window().show();
        if (wantsScreenshots())
            m_application->openDemonstration();
        else
            window().opener().open(writeBall(m_folder.filePath(QStringLiteral("ct"))));
        QVERIFY(wait([this] { return m_application->workspace().session() != nullptr; }));
        QVERIFY(waitUntilDrawn());

        QVERIFY(apply(test::newSegment(QStringLiteral("Skull"), 0xE0C068)));
        ui::AuthorDialog dialog(&window());
        dialog.findChild<QLineEdit*>(QStringLiteral("authorName"))
            ->setText(QStringLiteral("Dr. M. Muster "));
        if (wantsScreenshots()) {
            dialog.show();
            QVERIFY(QTest::qWaitForWindowExposed(&dialog));
            dialog.grab().save(screenshots().filePath(QStringLiteral("author.png")));
        }
        dialog.accept();
        for (int i = 0; i < 10; ++i)
            QVERIFY(apply(drill(-0.2 + 0.04 * i, i % 2 ? 0.12 : -0.02)));
        const core::History& history = session().history();
        QCOMPARE(history.rows().size(), std::size_t(11));
        QCOMPARE(history.row(1).origin.author, QString());
        QCOMPARE(history.row(11).origin.author, QStringLiteral("Dr. M. Muster"));
        QCOMPARE(history.row(11).origin.program, QStringLiteral("burin 9.8.7"));
        QVERIFY(wait([this] { return session().keyframes().rows().size() == 2; }));
        QCOMPARE(session().keyframes().rows(), (std::vector<core::RowId>{1, 11}));
        const QImage first = keyframe(1);
        const QImage second = keyframe(11);
        QVERIFY(showsSomething(first) && showsSomething(second));
        QCOMPARE(first.size(), second.size());
        QVERIFY(first != second); // what was drilled is to be seen

        // An old future, a step undone alone, and one undone.
        QVERIFY(session().goTo(9));
        QVERIFY(waitUntilDrawn());
        QVERIFY(apply(test::renameSegment(1, QStringLiteral("Cranium"))));
        QVERIFY(apply(drill(0.05, -0.15)));
        QVERIFY(apply(test::revertRows({13})));
        QVERIFY(apply(test::newSegment(QStringLiteral("Brain"), 0x60A0E0)));
        QVERIFY(session().undo());
        QVERIFY(waitUntilDrawn());

        point(8);
        point(4);
        QVERIFY(wait([this] { return !timeline().popup().picture().isNull(); }));
        QVERIFY(timeline().popup().words().startsWith(QStringLiteral("Step 4: Drill")));
        QCOMPARE(timeline().popup().picture().size(), first.size());
        if (wantsScreenshots()) {
            // On the screen before that is looked at.
            auto* popup = window().findChild<ui::KeyframePopup*>();
            QVERIFY(QTest::qWaitForWindowExposed(popup));
            window().repaint();
            popup->repaint();
            QGuiApplication::sync();
            window().screen()->grabWindow(0).save(
                screenshots().filePath(QStringLiteral("timeline.png")));
            paintPages();
        }
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&timeline(), &leave);

        const QString html = save("audit.html");
        QVERIFY(!html.isEmpty());
        QFile file(html);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(file.readAll());
        for (const char* words :
            {"Dr. M. Muster", "some steps name nobody", "This history is whole",
                "15 of 15 steps are sealed", "taken back by step 14", "old future, behind step 9",
                "undone", "burin 9.8.7", "As they stand after step 14.", "no voxel"})
            QVERIFY2(text.contains(QLatin1String(words)), words);
        QCOMPARE(
            text.count(QStringLiteral("<img ")), qsizetype(session().keyframes().rows().size()));
        if (wantsScreenshots())
            QFile::copy(html, screenshots().filePath(QStringLiteral("audit.html")));
        const QString pdf = save("audit.pdf");
        QVERIFY(QFile(pdf).size() > 10000);
        QVERIFY(save("no/such/audit.pdf").isEmpty());
        QVERIFY(save("audit.doc").isEmpty());
        QVERIFY(!QFile::exists(m_folder.filePath(QStringLiteral("audit.doc"))));
    }

    void theEndOfTheSessionIsKept()
    {
        QVERIFY(m_application);
        QVERIFY(session().goTo(6));
        QVERIFY(waitUntilDrawn());
        window().closeStudy();
        const QDir sessions(m_folder.filePath(QStringLiteral("state/burin/sessions")));
        const QStringList files = sessions.entryList({QStringLiteral("*.burin")});
        QCOMPARE(files.size(), 1);
        const auto file = core::SessionFile::open(
            sessions.filePath(files.first()), core::SessionFile::Access::ReadOnly);
        QVERIFY(file);
        QCOMPARE((*file)->contents().keyframes.back().row, core::RowId(11));
        bool sixth = false;
        for (const core::Keyframe& keyframe : (*file)->contents().keyframes)
            sixth = sixth || keyframe.row == 6;
        QVERIFY(sixth);
    }

    void cleanupTestCase() { m_application.reset(); }
};

BURIN_WINDOW_TEST(AuditUiTest)

} // namespace auditUiTest

#include "AuditUiTest.moc"
