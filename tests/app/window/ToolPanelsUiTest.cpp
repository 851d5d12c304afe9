// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/fixtures/CutTexts.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/base/Actions.h"
#include "ui/frame/Panel.h"
#include "ui/frame/ToolColumn.h"
#include "ui/input/Tool.h"
#include "ui/window/OptionBar.h"
#include "ui/workspace/Workspace.h"

#include <QAction>
#include <QProcess>
#include <QTest>
#include <QToolButton>

namespace toolPanelsUiTest {

/// The panel of a tool opens when the user takes the tool, and only then; tools and panels go into
/// a small window.
class ToolPanelsUiTest : public QObject {
    Q_OBJECT

private:
    [[nodiscard]] static double scale()
    {
        const QByteArray asked = qgetenv("QT_SCALE_FACTOR");
        return asked.isEmpty() ? 1.0 : asked.toDouble();
    }

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aToolThatIsTakenOpensItsPanel_data()
    {
        QTest::addColumn<QString>("tool");
        QTest::addColumn<QString>("panel");
        QTest::newRow("clip") << "tool.clip"
                              << "panel.ClippingPanel";
        QTest::newRow("seed") << "tool.seed"
                              << "panel.GrowthPanel";
        QTest::newRow("contour") << "tool.contour"
                                 << "panel.ContourPanel";
        QTest::newRow("refine") << "tool.refine"
                                << "panel.RefinePanel";
        QTest::newRow("chunks") << "tool.chunks"
                                << "panel.ChunksPanel";
        QTest::newRow("measure") << "tool.ruler"
                                 << "panel.MeasurementsPanel";
    }
    void aToolThatIsTakenOpensItsPanel()
    {
        QFETCH(QString, tool);
        QFETCH(QString, panel);
        test::ApplicationFixture fixture;
        fixture.open(fixture.path("case/ct"));
        ui::Actions& actions = fixture.window().actionTable();
        if (actions[panel].isChecked())
            actions[panel].trigger();
        QVERIFY(!actions[panel].isChecked());

        actions[tool].trigger();
        QVERIFY(fixture.workspace().activeTool());
        QVERIFY(actions[panel].isChecked());

        // As a study that is opened again brings its tool back: a closed panel stays closed.
        ui::Tool* taken = fixture.workspace().activeTool();
        fixture.workspace().setActiveTool(nullptr);
        actions[panel].trigger();
        fixture.workspace().setActiveTool(taken);
        QVERIFY(!actions[panel].isChecked());
        fixture.workspace().setActiveTool(nullptr);
    }

    /// With all tools there are, each is within reach in a small window.
    void allToolsFitASmallWindow()
    {
        test::ApplicationFixture fixture;
        fixture.open(fixture.path("case/ct"));
        ui::MainWindow& window = fixture.window();
        window.resize(1280, 720);
        QTRY_COMPARE(window.size(), QSize(1280, 720));
        const auto* column = window.findChild<ui::ToolColumn*>();
        QVERIFY(column);
        const QList<QToolButton*> buttons = column->findChildren<QToolButton*>();
        QVERIFY(buttons.size() > 20);
        for (const QToolButton* button : buttons) {
            QTRY_VERIFY2(
                column->rect().contains(button->geometry()), qPrintable(button->toolTip()));
            QVERIFY2(
                button->height() >= button->iconSize().height(), qPrintable(button->toolTip()));
        }
    }

    /// Whichever tool is in hand, with the options it has at first and its panel.
    void nothingIsCutInASmallWindow()
    {
        test::ApplicationFixture fixture;
        fixture.open(fixture.path("case/ct"));
        fixture.edit(test::newSegment(QStringLiteral("Left ventricle with its muscles"), 0x4a9bff));
        fixture.edit(test::paintAt(1, {test::pointsInBrain().back()}, 4.0));
        fixture.workspace().setActiveSegment(1);
        ui::MainWindow& window = fixture.window();
        QCOMPARE(window.devicePixelRatioF(), scale());
        window.resize(1280, 720);
        QTRY_COMPARE(window.size(), QSize(1280, 720));
        const QList<ui::Tool*> tools = window.findChildren<ui::Tool*>();
        QVERIFY(tools.size() > 20);
        for (ui::Tool* tool : tools) {
            const QByteArray id = "tool." + tool->iconName().toLatin1();
            window.actionTable()[QLatin1String(id)].trigger();
            QCOMPARE(fixture.workspace().activeTool(), tool);
            QTRY_COMPARE(window.size(), QSize(1280, 720));
            QVERIFY2(window.minimumSizeHint().width() <= 1280, id.constData());
            QVERIFY2(window.minimumSizeHint().height() <= 720, id.constData());
            const auto* bar = window.findChild<ui::OptionBar*>();
            QTRY_VERIFY2(test::crowdedParts(*bar).isEmpty(),
                qPrintable(id + test::crowdedParts(*bar).join(QLatin1Char('\n')).toUtf8()));
            for (const auto* panel : window.findChildren<ui::Panel*>()) {
                QTRY_VERIFY2(!panel->isVisible() || test::crowdedParts(*panel).isEmpty(),
                    qPrintable(id + test::crowdedParts(*panel).join(QLatin1Char('\n')).toUtf8()));
            }
            QTRY_VERIFY2(test::cutTexts(window).isEmpty(),
                qPrintable(id + test::cutTexts(window).join(QLatin1Char('\n')).toUtf8()));
            test::look(window.grab(),
                QStringLiteral("%1x %2.png").arg(scale()).arg(tool->name()).toUtf8().constData());
        }
    }

    /// The same where a logical pixel is two by two on the screen: this program once more, since a
    /// program has one scale.
    void nothingIsCutAtScaleTwo()
    {
        if (scale() != 1.0)
            QSKIP("it is being asked");
        QProcess again;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("QT_SCALE_FACTOR"), QStringLiteral("2"));
        again.setProcessEnvironment(environment);
        again.setProcessChannelMode(QProcess::MergedChannels);
        again.start(QCoreApplication::applicationFilePath(),
            {QStringLiteral("ToolPanelsUiTest"), QStringLiteral("allToolsFitASmallWindow"),
                QStringLiteral("nothingIsCutInASmallWindow")});
        QVERIFY(again.waitForFinished(test::ApplicationFixture::patience));
        const QByteArray said = again.readAll();
        QVERIFY2(again.exitCode() == 0 && said.contains("nothingIsCutInASmallWindow()"),
            said.constData());
    }
};

BURIN_WINDOW_TEST(ToolPanelsUiTest)

} // namespace toolPanelsUiTest

#include "ToolPanelsUiTest.moc"
