// SPDX-License-Identifier: Apache-2.0
#include "app/Application.h"
#include "core/session/EditSession.h"
#include "tests/support/FailingLog.h"
#include "ui/MainWindow.h"
#include "ui/PanelSection.h"
#include "ui/Workspace.h"
#include "ui/models/HistoryModel.h"
#include "ui/panels/HistoryTimeline.h"
#include "ui/panels/KeyframePopup.h"
#include "ui/panels/Panel.h"
#include "ui/views/ViewGrid.h"
#include "ui/views/VolumeView.h"

#include <QApplication>
#include <QDir>
#include <QListView>
#include <QPainter>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

namespace {

constexpr int patience = 300000; ///< ms; only a hang takes that long

} // namespace

/// The manual's pictures of the history, in the real window on the demonstration study. It takes a
/// minute, so it only runs where somebody wants them: BURIN_SCREENSHOTS names the folder.
class ManualPicturesUiTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    std::unique_ptr<app::Application> m_application;

    [[nodiscard]] ui::MainWindow& window() { return m_application->window(); }
    [[nodiscard]] core::EditSession& session() { return *m_application->workspace().session(); }
    [[nodiscard]] ui::HistoryTimeline& timeline()
    {
        return *window().findChild<ui::HistoryTimeline*>();
    }
    [[nodiscard]] static bool wait(const std::function<bool()>& condition)
    {
        return QTest::qWaitFor(condition, patience);
    }
    [[nodiscard]] bool waitUntilDrawn()
    {
        QTest::qWait(2500); // a busy machine needs that long to know that its pictures are old
        return wait([this] { return session().idle() && window().views().refined(); });
    }
    void apply(const core::Edit& edit)
    {
        QVERIFY(session().apply(edit));
        QVERIFY(waitUntilDrawn());
    }
    /// A stroke from where the 3D view looks, in parts of its height right of and above the middle.
    [[nodiscard]] core::DrillStroke drill(
        const glm::dvec2& from, const glm::dvec2& to, double radiusMm, double depthMm)
    {
        const ui::Camera& camera = window().views().volume().camera();
        core::DrillStroke stroke;
        stroke.view = {.eyeLps = camera.eyeLps(),
            .targetLps = camera.targetLps,
            .up = camera.up,
            .heightMm = camera.heightMm};
        stroke.mask.radiusMm = radiusMm;
        stroke.depthMm = depthMm;
        stroke.surfaceThreshold = m_application->workspace().volumeDisplay().surfaceThreshold;
        const glm::dvec2 start = from * camera.heightMm;
        const glm::dvec2 end = to * camera.heightMm;
        stroke.samples = {{start.x, start.y, 1.0, 0.0}, {end.x, end.y, 1.0, 0.4}};
        return stroke;
    }
    void foldAllBut(const std::vector<QString>& titles)
    {
        for (ui::PanelSection* section : window().findChildren<ui::PanelSection*>())
            section->setFolded(
                std::find(titles.begin(), titles.end(), section->panel().title()) == titles.end());
    }
    void unfoldBranches()
    {
        QAbstractItemModel& model =
            *window().findChild<QListView*>(QStringLiteral("historyList"))->model();
        for (int row = 0; row < model.rowCount(); ++row)
            model.setData(model.index(row, 0), false, ui::HistoryModel::FoldedRole);
    }
    void point(int step)
    {
        const QPointF at(timeline().xOf(step), timeline().height() - 8);
        QMouseEvent event(QEvent::MouseMove, at, timeline().mapToGlobal(at), Qt::NoButton,
            Qt::NoButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&timeline(), &event);
    }
    /// The window, with what floats over it.
    void keep(const char* name)
    {
        QTest::qWait(300);
        QPixmap picture = window().grab();
        if (const QWidget& popup = timeline().popup(); popup.isVisible()) {
            QPainter painter(&picture);
            painter.drawPixmap(window().mapFromGlobal(popup.mapToGlobal(QPoint())),
                const_cast<QWidget&>(popup).grab());
        }
        QVERIFY(picture.save(
            QDir(qEnvironmentVariable("BURIN_SCREENSHOTS")).filePath(QLatin1String(name))));
    }

private Q_SLOTS:
    void initTestCase()
    {
        if (!qEnvironmentVariableIsSet("BURIN_SCREENSHOTS"))
            QSKIP("BURIN_SCREENSHOTS names no folder for pictures");
        qputenv("XDG_STATE_HOME", m_folder.filePath(QStringLiteral("state")).toUtf8());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
            m_folder.filePath(QStringLiteral("settings")));
        QCoreApplication::setApplicationName(QStringLiteral("burin"));
        QCoreApplication::setOrganizationName(QStringLiteral("burin"));
    }
    void init() { test::failOnUnexpectedMessages(); }

    void historyWithBranchesAndTimeline()
    {
        m_application = std::move(*app::Application::create());
        window().resize(1280, 800);
        window().show();
        m_application->openDemonstration();
        QVERIFY(wait([this] { return m_application->workspace().session() != nullptr; }));
        QVERIFY(waitUntilDrawn());
        foldAllBut({QStringLiteral("Segments"), QStringLiteral("History")});

        apply(drill({-0.10, 0.21}, {0.10, 0.21}, 14, 12));
        apply(drill({-0.08, 0.21}, {0.08, 0.21}, 9, 24));
        apply(core::AddSegment{.name = QStringLiteral("Brain"), .rgb = 0x4AA3FF});
        apply(
            core::SeedStroke{.segment = 1, .pointsLps = {{-16.0, 0.5, 20.5}, {-14.0, 0.5, 20.5}}});
        const core::RowId seeded = session().history().position();
        apply(core::GrowSteps{.criteria = {.lower = -20, .upper = 120}, .steps = 30});
        apply(core::GrowSteps{.criteria = {.lower = -20, .upper = 160}, .steps = 25});
        QVERIFY(session().goTo(seeded));
        QVERIFY(waitUntilDrawn());
        apply(core::GrowSteps{.criteria = {.lower = 0, .upper = 90}, .steps = 88});
        apply(core::ChangeSegment{.segment = 1, .name = QStringLiteral("Cerebrum")});
        apply(drill({0.22, 0.0}, {0.24, -0.04}, 9, 14));
        apply(core::RevertRows{{session().history().position()}});
        const core::RowId last = session().history().position();
        apply(core::AddSegment{.name = QStringLiteral("Ventricles"), .rgb = 0xE07A5F});
        QVERIFY(session().goTo(last));
        QVERIFY(waitUntilDrawn());
        unfoldBranches();
        keep("history.png");

        point(6);
        point(2);
        QVERIFY(wait([this] { return !timeline().popup().picture().isNull(); }));
        keep("timeline.png");
    }
};

QTEST_MAIN(ManualPicturesUiTest)
#include "ManualPicturesUiTest.moc"
