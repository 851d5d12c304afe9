// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/ToolMask.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "ui/tools/sculpt/DrillOptions.h"
#include "ui/tools/sculpt/LaserTool.h"
#include "ui/tools/sculpt/ToolMaskPresetMenu.h"
#include "ui/tools/sculpt/ToolMaskPresets.h"
#include "ui/views/ViewGrid.h"

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QSettings>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

#include <cmath>

namespace freehandMaskUiTest {

namespace {

using Curve = std::vector<glm::dvec2>; ///< millimetres right of and above the view's middle
using Kind = core::ToolMask::Kind;

/// An L: neither its middle nor its area is that of anything round or square around it.
const Curve corner{{-8.0, 6.0}, {-8.0, -6.0}, {4.0, -6.0}, {4.0, -2.0}, {-4.0, -2.0}, {-4.0, 6.0}};
constexpr double cornerAreaMm2 = 12.0 * 12.0 - 8.0 * 8.0;
constexpr glm::dvec2 cornerMiddle{-2.0, 0.0};

double areaOf(const Curve& curve)
{
    double twice = 0.0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const glm::dvec2& a = curve[i];
        const glm::dvec2& b = curve[(i + 1) % curve.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return std::abs(twice) / 2.0;
}

double distanceTo(const Curve& curve, const glm::dvec2& point)
{
    double least = 1e9;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const glm::dvec2 from = curve[i];
        const glm::dvec2 way = curve[(i + 1) % curve.size()] - from;
        const double along = std::clamp(glm::dot(point - from, way) / glm::dot(way, way), 0.0, 1.0);
        least = std::min(least, glm::length(point - from - along * way));
    }
    return least;
}

/// The real window with the small head, the drill in hand and its options in the bar.
class FreehandFixture : public test::WindowFixture {
public:
    FreehandFixture()
        : test::WindowFixture(test::smallHead::volume())
        , drill(workspace)
        , laser(workspace)
        , view(window.views().volume())
        , said(&workspace, &ui::Workspace::said)
    {
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        workspace.setVolumeDisplay(display);
        workspace.setDrillSettings({3.0, 6.0, false});
        workspace.setActiveTool(&drill);
        view.lookFrom({0.0, -1.0, 0.0});
    }
    [[nodiscard]] const ui::Workspace::DrillSettings& settings() const
    {
        return workspace.drillSettings();
    }
    [[nodiscard]] QComboBox& shape() const
    {
        return *window.findChild<ui::DrillOptions*>()->findChild<QComboBox*>(
            QStringLiteral("drillShape"));
    }
    [[nodiscard]] QToolButton& button() const
    {
        return *window.findChild<ui::DrillOptions*>()->findChild<QToolButton*>(
            QStringLiteral("drillOutline"));
    }
    [[nodiscard]] double mmPerPixel() const { return view.context().mmPerPixel(); }
    [[nodiscard]] QPointF at(const glm::dvec2& mm) const
    {
        return QPointF(view.width(), view.height()) / 2.0 + QPointF(mm.x, -mm.y) / mmPerPixel();
    }
    /// As a pen draws it: a reading every few pixels, the last side left to be closed.
    void draw(const Curve& curve, test::Pen& pen)
    {
        pen.press(at(curve.front()), 0.5, m_milliseconds += 8);
        for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
            for (int step = 1; step <= 10; ++step)
                pen.move(
                    at(glm::mix(curve[i], curve[i + 1], step / 10.0)), 0.5, m_milliseconds += 8);
        }
        pen.release(at(curve.back()), m_milliseconds += 8);
    }
    void draw(const Curve& curve)
    {
        test::Pen pen(view);
        draw(curve, pen);
    }
    /// @return the mask that the press was recorded with
    core::ToolMask press(test::Pen& pen)
    {
        pen.press(at({0.0, 0.0}), 1.0, m_milliseconds += 8);
        pen.release(at({0.0, 0.0}), m_milliseconds += 8);
        if (!session().settle() || rows() == 0)
            return {};
        return test::factsOfStroke(session().history().rows().back().edit).mask;
    }
    core::ToolMask press()
    {
        test::Pen pen(view);
        return press(pen);
    }
    void choose(const QString& name) { shape().setCurrentText(name); }

    ui::DrillTool drill;
    ui::LaserTool laser;
    ui::VolumeView& view;
    QSignalSpy said;

private:
    quint64 m_milliseconds = 90000;
};

/// Whether a mask is the corner, so many times as large.
void compareWithCorner(const core::ToolMask& mask, double factor, double toleranceMm)
{
    QVERIFY(mask.polygonMm);
    Curve expected;
    for (const glm::dvec2& point : corner)
        expected.push_back((point - cornerMiddle) * factor);
    for (const glm::dvec2& point : *mask.polygonMm)
        QVERIFY(distanceTo(expected, point) < toleranceMm);
    const double area = cornerAreaMm2 * factor * factor;
    QVERIFY2(std::abs(areaOf(*mask.polygonMm) - area) < 0.05 * area,
        qPrintable(QString::number(areaOf(*mask.polygonMm))));
}

} // namespace

/// A mask of drill and laser that is drawn by hand.
class FreehandMaskUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        QSettings().remove(QStringLiteral("drill"));
    }

    void theNextDragDrawsTheMask()
    {
        FreehandFixture fixture;
        QVERIFY(!fixture.button().isVisible());
        fixture.shape().setFocus();
        QTest::keyClick(&fixture.shape(), Qt::Key_End);
        QCOMPARE(fixture.shape().currentText(), QStringLiteral("Freehand"));
        QVERIFY(fixture.button().isVisible() && fixture.button().isChecked());
        QVERIFY(fixture.said.back()[0].toString().startsWith(QStringLiteral("Draw the mask")));
        fixture.draw(corner);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(0)); // no stroke
        QVERIFY(!fixture.button().isChecked() && !fixture.button().icon().isNull());
        const double pixel = fixture.mmPerPixel();
        QVERIFY(std::abs(fixture.settings().radiusMm - 6.0) < pixel);
        compareWithCorner(fixture.press(), 1.0, 1.5 * pixel);
        QCOMPARE(fixture.rows(), std::size_t(1));

        // The curve stays the mask; the radius scales it, by every way that there is to it.
        fixture.workspace.setActiveTool(&fixture.laser);
        auto* radius = fixture.window.findChild<ui::DrillOptions*>()->findChild<QDoubleSpinBox*>(
            QStringLiteral("drillRadius"));
        radius->setValue(9.0);
        compareWithCorner(fixture.press(), 1.5, 2.5 * pixel);
        fixture.laser.changeRadius(-100);
        QCOMPARE(fixture.settings().radiusMm, ui::DrillOptions::minimumRadiusMm);
        fixture.workspace.setActiveTool(nullptr);
    }

    void itTurnsAsOthersDo()
    {
        FreehandFixture fixture;
        fixture.choose(QStringLiteral("Freehand"));
        fixture.draw(corner);
        const core::ToolMask before = fixture.press();
        fixture.drill.turn(18); // by 5° each
        const core::ToolMask after = fixture.press();
        QVERIFY(before.polygonMm && after.polygonMm);
        QCOMPARE(after.polygonMm->size(), before.polygonMm->size());
        for (std::size_t i = 0; i < after.polygonMm->size(); ++i) {
            const glm::dvec2 was = (*before.polygonMm)[i];
            QVERIFY(glm::length((*after.polygonMm)[i] - glm::dvec2(-was.y, was.x)) < 0.002);
        }
        // A new one stands as it is drawn.
        QTest::mouseClick(&fixture.button(), Qt::LeftButton);
        fixture.draw(corner);
        QCOMPARE(fixture.settings().rotationDegrees, 0.0);
        fixture.workspace.setActiveTool(nullptr);
    }

    /// A pen turns and foreshortens masks by the way it leans; the same pen presses what it drew.
    void aLeaningPenPressesWhatItDrew()
    {
        FreehandFixture fixture;
        ui::Workspace::DrillSettings settings = fixture.settings();
        settings.foreshortened = true;
        fixture.workspace.setDrillSettings(settings);
        fixture.choose(QStringLiteral("Freehand"));
        test::Pen pen(fixture.view);
        pen.hold({25.0, 35.0});
        fixture.draw(corner, pen);
        core::ToolMask mask = fixture.press(pen);
        QVERIFY(mask.polygonMm);
        // Its middle is that of the outline as a pen held upright would press it.
        glm::dvec2 low(1e9);
        glm::dvec2 high(-1e9);
        for (const glm::dvec2& point : *mask.polygonMm) {
            low = glm::min(low, point);
            high = glm::max(high, point);
        }
        for (glm::dvec2& point : *mask.polygonMm)
            point -= (low + high) / 2.0;
        compareWithCorner(mask, 1.0, 2.5 * fixture.mmPerPixel());
        fixture.workspace.setActiveTool(nullptr);
    }

    void tinyOnesAreRefusedKindly()
    {
        FreehandFixture fixture;
        fixture.choose(QStringLiteral("Freehand"));
        const double pixel = fixture.mmPerPixel();
        for (const Curve& tiny : {Curve{{0, 0}, {0, 0}}, Curve{{0, 0}, {2 * pixel, 2 * pixel}},
                 Curve{{0, 0}, {9, 9}, {3, 3}}}) { // a line, there and back
            fixture.draw(tiny);
            QVERIFY(fixture.said.back()[0].toString().contains(QStringLiteral("too small")));
            QVERIFY(fixture.settings().outline.empty());
            QVERIFY(fixture.button().isChecked());
        }
        // Crossing itself is no reason.
        fixture.draw({{-6, -4}, {6, 4}, {6, -4}, {-6, 4}});
        QVERIFY(!fixture.settings().outline.empty());
        QVERIFY(fixture.press().polygonMm);
        QCOMPARE(fixture.rows(), std::size_t(1));
        // Larger than masks are: it comes down to the largest.
        QTest::mouseClick(&fixture.button(), Qt::LeftButton);
        fixture.view.lookFrom({0.0, -1.0, 0.0});
        fixture.draw({{-90, -40}, {90, -40}, {90, 40}, {-90, 40}});
        QCOMPARE(fixture.settings().radiusMm, ui::DrillOptions::maximumRadiusMm);
        QVERIFY(fixture.said.back()[0].toString().contains(QStringLiteral("smaller")));
        fixture.workspace.setActiveTool(nullptr);
    }

    void escapeCancels()
    {
        FreehandFixture fixture;
        fixture.choose(QStringLiteral("Square"));
        fixture.choose(QStringLiteral("Freehand"));
        QVERIFY(fixture.drill.drawing().isWanted());
        // Before anything is drawn: back to the shape that was.
        QTest::keyClick(&fixture.view, Qt::Key_Escape);
        QCOMPARE(fixture.shape().currentText(), QStringLiteral("Square"));
        QVERIFY(!fixture.drill.drawing().isWanted());
        // While it is drawn.
        fixture.choose(QStringLiteral("Freehand"));
        test::Pen pen(fixture.view);
        pen.press(fixture.at({-5, -5}), 0.5, 70000);
        pen.move(fixture.at({5, -5}), 0.5, 70008);
        pen.move(fixture.at({5, 5}), 0.5, 70016);
        QTest::keyClick(&fixture.view, Qt::Key_Escape);
        pen.release(fixture.at({5, 5}), 70024);
        QCOMPARE(fixture.shape().currentText(), QStringLiteral("Square"));
        // There is one already: it stays.
        fixture.choose(QStringLiteral("Freehand"));
        fixture.draw(corner);
        const ui::ToolMaskOutline drawn = fixture.settings().outline;
        QTest::mouseClick(&fixture.button(), Qt::LeftButton);
        QVERIFY(fixture.drill.drawing().isWanted());
        QTest::keyClick(&fixture.view, Qt::Key_Escape);
        QVERIFY(!fixture.drill.drawing().isWanted() && !fixture.button().isChecked());
        QVERIFY(fixture.settings().freehand && fixture.settings().outline == drawn);
        // And it waits behind other shapes.
        fixture.choose(QStringLiteral("Circle"));
        QVERIFY(!fixture.press().polygonMm);
        fixture.choose(QStringLiteral("Freehand"));
        QVERIFY(!fixture.drill.drawing().isWanted());
        QVERIFY(fixture.press().polygonMm);
        fixture.workspace.setActiveTool(nullptr);
    }

    void presetsKeepIt()
    {
        FreehandFixture fixture;
        auto* masks = fixture.window.findChild<ui::ToolMaskPresetMenu*>();
        fixture.choose(QStringLiteral("Ellipse"));
        masks->save(QStringLiteral("Oval"));
        fixture.choose(QStringLiteral("Freehand"));
        fixture.draw(corner);
        masks->save(QStringLiteral("Corner"));
        const ui::Workspace::DrillSettings kept = fixture.settings();
        QCOMPARE(ui::toolMaskPresets().size(), std::size_t(2));
        fixture.workspace.setDrillSettings(ui::withPreset(kept, ui::toolMaskPresets()[1]));
        QVERIFY(!fixture.settings().freehand && fixture.settings().shape == Kind::Ellipse);
        QCOMPARE(fixture.shape().currentText(), QStringLiteral("Ellipse"));
        ui::Workspace::DrillSettings none = fixture.settings();
        none.outline.clear();
        fixture.workspace.setDrillSettings(none);
        fixture.workspace.setDrillSettings(ui::withPreset(none, ui::toolMaskPresets()[0]));
        QVERIFY(fixture.settings().freehand && fixture.settings().outline == kept.outline);
        QCOMPARE(fixture.settings().radiusMm, kept.radiusMm);
        QVERIFY(!fixture.drill.drawing().isWanted());

        QSettings().setValue(QStringLiteral("drill/masks"),
            QByteArray("[{\"name\":\"a\",\"shape\":0,\"radiusMm\":3,\"heightRatio\":1,"
                       "\"rotationDegrees\":0,\"outline\":[[0,0],[7,0],[0,7]]}]"));
        QVERIFY(ui::toolMaskPresets().empty());
        fixture.workspace.setActiveTool(nullptr);
    }

    void looks()
    {
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (folder.isEmpty())
            QSKIP("BURIN_SCREENSHOTS names no folder");
        FreehandFixture fixture;
        fixture.window.resize(1280, 720);
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        fixture.choose(QStringLiteral("Freehand"));
        test::Pen pen(fixture.view);
        pen.hover(fixture.at({0, 0}), 60000);
        QVERIFY(fixture.session().settle()); // what the tip lies on is asked for
        const auto keep = [&](const char* name) {
            QVERIFY(fixture.window.grab().save(QDir(folder).filePath(QLatin1String(name))));
        };
        keep("freehand-wanted.png");
        fixture.draw(corner);
        pen.hover(fixture.at({2, 2}), 95000);
        QVERIFY(fixture.session().settle());
        keep("freehand-mask.png");
        fixture.workspace.setActiveTool(nullptr);
    }
};

BURIN_WINDOW_TEST(FreehandMaskUiTest)

} // namespace freehandMaskUiTest

#include "FreehandMaskUiTest.moc"
