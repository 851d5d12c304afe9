// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/sculpt/LaserTool.h"

#include "core/edits/EditJson.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/engine/HalfSpaces.h"
#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "ui/tools/sculpt/CarveBrushTool.h"
#include "ui/tools/sculpt/PeelTool.h"
#include "ui/tools/sculpt/ScissorsTool.h"
#include "ui/views/ViewGrid.h"

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QJsonArray>
#include <QWheelEvent>
#include <QtTest>

#include <limits>
#include <memory>

namespace laserToolUiTest {

namespace {

/// The real window with the small head, seen from the front; its surface is a ball of 16 mm.
class PressFixture : public test::WindowFixture {
public:
    PressFixture()
        : test::WindowFixture(test::smallHead::volume())
        , view(window.views().volume())
    {
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        workspace.setVolumeDisplay(display);
        workspace.setDrillSettings({3.0, 6.0, false});
        view.lookFrom({0.0, -1.0, 0.0});
    }
    [[nodiscard]] QPointF at(double rightMm, double upMm) const
    {
        return QPointF(view.width(), view.height()) / 2.0
            + QPointF(rightMm, -upMm) / view.context().mmPerPixel();
    }
    /// @return whether it was told
    void draw(const QPointF& from, const QPointF& to)
    {
        test::Pen pen(view);
        pen.press(from, 1.0, 70000);
        pen.move((from + to) / 2.0, 1.0, 70010);
        pen.release(to, 70020);
        QVERIFY(session().settle());
    }

    ui::VolumeView& view;
};

const core::Edit& lastEdit(PressFixture& fixture)
{
    return fixture.session().history().rows().back().edit;
}

std::unique_ptr<ui::Tool> toolNamed(const QByteArray& name, ui::Workspace& workspace)
{
    if (name == "laser")
        return std::make_unique<ui::LaserTool>(workspace);
    if (name == "peel")
        return std::make_unique<ui::PeelTool>(workspace);
    if (name == "scissors")
        return std::make_unique<ui::ScissorsTool>(workspace);
    if (name == "carve brush")
        return std::make_unique<ui::CarveBrushTool>(workspace);
    if (name == "drill along the normal") {
        ui::Workspace::DrillSettings settings = workspace.drillSettings();
        settings.sweep = ui::Workspace::Sweep::Normal;
        workspace.setDrillSettings(settings);
    }
    return std::make_unique<ui::DrillTool>(workspace);
}

} // namespace

/// The laser, the ways a drill can go in, what is shown before a press, and what goes wrong with
/// pens, for every tool that carves.
class LaserToolUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aStrokeIsTheEditOfARecipe_data() { test::addMouseAndPen(); }
    void aStrokeIsTheEditOfARecipe()
    {
        QFETCH(const test::DrawnBy, by);
        PressFixture fixture;
        ui::LaserTool tool(fixture.workspace);
        fixture.workspace.setActiveTool(&tool);
        const auto scene = std::get<gpu::VolumeScene>(fixture.view.context().scene);
        test::drawStroke(by, fixture.view, {fixture.at(0, 0), fixture.at(2, 1), fixture.at(4, 2)});
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(1));
        QVERIFY(fixture.carvedVoxels() > 20);
        const auto& row = fixture.session().history().rows().back();
        QVERIFY(row.name.startsWith(QStringLiteral("Laser 15.0 mm, ")));
        const test::StrokeFacts laser = test::factsOfStroke(row.edit);
        QCOMPARE(laser.depthMm, 15.0);
        QCOMPARE(laser.mask.radiusMm, 3.0);
        QVERIFY(laser.byTime && !laser.restore && !laser.hidden);
        QVERIFY(glm::distance(laser.view.targetLps, scene.targetLps) < 1e-2);
        const QByteArray hash = fixture.session().stateHash();
        test::WorkspaceFixture recipe;
        recipe.apply(row.edit);
        QCOMPARE(recipe.session().stateHash(), hash);
    }

    /// What was carved before, where the stroke goes along again.
    void controlAndTheEraserEndRestore_data() { test::addWhatInverts(); }
    void controlAndTheEraserEndRestore()
    {
        QFETCH(const test::DrawnBy, by);
        PressFixture fixture;
        ui::LaserTool tool(fixture.workspace);
        fixture.workspace.setActiveTool(&tool);
        const std::vector<QPointF> way{fixture.at(0, 0), fixture.at(4, 2)};
        test::drawStroke(test::DrawnBy::Pen, fixture.view, way);
        QVERIFY(fixture.session().settle());
        const std::int64_t carved = fixture.carvedVoxels();
        test::drawStroke(by, fixture.view, way, test::invertingKeys(by));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(2));
        QVERIFY(test::factsOfStroke(lastEdit(fixture)).restore);
        const QString name = fixture.session().history().rows().back().name;
        QVERIFY2(name.startsWith(QStringLiteral("Restore laser ")), qPrintable(name));
        QVERIFY2(fixture.carvedVoxels() < carved,
            qPrintable(QStringLiteral("%1 of %2").arg(fixture.carvedVoxels()).arg(carved)));
        test::WorkspaceFixture recipe;
        for (const core::HistoryRow& row : fixture.session().history().rows())
            recipe.apply(row.edit);
        QCOMPARE(recipe.session().stateHash(), fixture.session().stateHash());
    }

    void itsDepthIsItsOwn()
    {
        PressFixture fixture;
        ui::LaserTool tool(fixture.workspace);
        fixture.workspace.setActiveTool(&tool);
        const auto wheel = [&fixture](Qt::KeyboardModifiers modifiers) {
            const QPointF at = fixture.at(0, 0);
            QWheelEvent event(at, fixture.view.mapToGlobal(at), {}, {0, 120}, Qt::NoButton,
                modifiers, Qt::NoScrollPhase, false);
            QApplication::sendEvent(&fixture.view, &event);
        };
        wheel(Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(fixture.workspace.drillSettings().laserDepthMm, 16.0);
        QCOMPARE(fixture.workspace.drillSettings().depthMm, 6.0);
        wheel(Qt::ShiftModifier);
        QCOMPARE(fixture.workspace.drillSettings().radiusMm, 3.5); // the tip is the drill's
        wheel(Qt::ControlModifier);
        QCOMPARE(fixture.workspace.drillSettings().rotationDegrees, 5.0);
        for (int i = 0; i < 40; ++i)
            tool.turn(1);
        QCOMPARE(fixture.workspace.drillSettings().rotationDegrees, -155.0);
        const auto* sweep = fixture.window.findChild<QComboBox*>(QStringLiteral("drillSweep"));
        QVERIFY(sweep && sweep->isHidden()); // a laser knows one way only
    }

    void aDrillGoesInAsItIsTold_data()
    {
        using Sweep = ui::Workspace::Sweep;
        QTest::addColumn<int>("sweep");
        QTest::addColumn<glm::dvec3>("expected");
        // Seen from the front, 8 mm to the viewer's right: that is the patient's left, +x.
        QTest::addRow("normal") << int(Sweep::Normal) << glm::dvec3(-0.5, 0.866, 0.0);
        QTest::addRow("left to right") << int(Sweep::LeftRight) << glm::dvec3(-1.0, 0.0, 0.0);
        QTest::addRow("front to back") << int(Sweep::FrontBack) << glm::dvec3(0.0, 1.0, 0.0);
        QTest::addRow("pen") << int(Sweep::Pen) << glm::dvec3(-0.5, 0.866, 0.0);
    }
    void aDrillGoesInAsItIsTold()
    {
        QFETCH(int, sweep);
        QFETCH(glm::dvec3, expected);
        PressFixture fixture;
        ui::DrillTool tool(fixture.workspace);
        fixture.workspace.setActiveTool(&tool);
        ui::Workspace::DrillSettings settings = fixture.workspace.drillSettings();
        settings.sweep = ui::Workspace::Sweep(sweep);
        fixture.workspace.setDrillSettings(settings);
        ui::PointerSample sample;
        sample.position = fixture.at(8, 0);
        sample.tiltDegrees = {30.0, 0.0};
        const ui::ViewContext context = fixture.view.context();
        tool.press(sample, context);
        sample.position = fixture.at(8, 2);
        sample.timeSeconds = 0.1;
        tool.drag(sample, context);
        tool.release(sample, context); // whether the answer was there or not
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(1));
        const test::StrokeFacts edit = test::factsOfStroke(lastEdit(fixture));
        const glm::dvec3 way = glm::normalize(edit.view.targetLps - edit.view.eyeLps);
        const bool eitherSide = ui::Workspace::Sweep(sweep) == ui::Workspace::Sweep::LeftRight;
        const double cosine = glm::dot(way, expected);
        QVERIFY2((eitherSide ? std::abs(cosine) : cosine) > 0.985,
            qPrintable(QStringLiteral("%1 %2 %3").arg(way.x).arg(way.y).arg(way.z)));
        // At the place under the pen, and only from there on.
        QVERIFY(std::abs(glm::length(edit.view.targetLps) - 16.0) < 1.6);
        QVERIFY(std::abs(edit.view.targetLps.x - 8.0) < 1.0);
        QCOMPARE(edit.hidden->size(), std::size_t(1));
        QVERIFY(std::hypot(edit.samples.front().xMm, edit.samples.front().yMm) < 1.0);
        QVERIFY(std::abs(edit.samples.back().yMm - edit.samples.front().yMm - 2.0) < 0.2);
        // A recipe says the same.
        const QByteArray hash = fixture.session().stateHash();
        test::WorkspaceFixture recipe;
        recipe.apply(lastEdit(fixture));
        QCOMPARE(recipe.session().stateHash(), hash);
    }

    void aDrillWithoutAPlaceIsNoStep()
    {
        PressFixture fixture;
        const auto tool = toolNamed("drill along the normal", fixture.workspace);
        fixture.workspace.setActiveTool(tool.get());
        fixture.draw(fixture.at(25, 25), fixture.at(27, 25));
        QCOMPARE(fixture.rows(), std::size_t(0));
        QVERIFY(!fixture.session().transactionOpen());
        // Cancelled at once, whether the place was known or not.
        const ui::ViewContext context = fixture.view.context();
        ui::PointerSample sample;
        sample.position = fixture.at(0, 0);
        tool->press(sample, context);
        tool->cancel();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(0));
        // And the next one works.
        fixture.draw(fixture.at(0, 0), fixture.at(1, 0));
        QCOMPARE(fixture.rows(), std::size_t(1));
    }

    void theFootprintShowsBeforeThePress_data()
    {
        QTest::addColumn<QByteArray>("name");
        for (const char* name : {"drill", "drill along the normal", "laser"})
            QTest::addRow("%s", name) << QByteArray(name);
    }
    void theFootprintShowsBeforeThePress()
    {
        QFETCH(QByteArray, name);
        PressFixture fixture;
        const auto tool = toolNamed(name, fixture.workspace);
        fixture.workspace.setActiveTool(tool.get());
        QTRY_COMPARE(fixture.view.quality(), gpu::Frame::Quality::Refined); // it is told
        test::Pen pen(fixture.view);
        const auto picture = [&](const QPointF& at) {
            pen.hover(at, 60000);
            fixture.session().poll();
            QCoreApplication::processEvents();
            return fixture.view.grab().toImage();
        };
        const auto tinted = [](const QImage& with, const QImage& without) {
            int count = 0;
            for (int y = 0; y < with.height(); ++y)
                for (int x = 0; x < with.width(); ++x)
                    count += with.pixel(x, y) != without.pixel(x, y) ? 1 : 0;
            return count;
        };
        const QImage beside = picture(fixture.at(0, 24)); // over air
        const QImage on = picture(fixture.at(6, 0));
        // The mouse may leave another view when the pen is here already.
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&fixture.window.views().axial(), &leave);
        QCOMPARE(fixture.view.grab().toImage(), on);
        fixture.workspace.setActiveTool(nullptr);
        const QImage none = fixture.view.grab().toImage();
        const double radiusPixels = 3.0 / fixture.view.context().mmPerPixel();
        if (const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS"); !folder.isEmpty()) {
            QDir().mkpath(folder);
            on.save(QDir(folder).filePath(
                QStringLiteral("footprint-%1.png").arg(QString::fromLatin1(name))));
        }
        // Over the head the mask is filled, over air it is an outline.
        QVERIFY(tinted(on, none) > tinted(beside, none) + int(radiusPixels * radiusPixels));
        QCOMPARE(fixture.rows(), std::size_t(0));
        QVERIFY(!fixture.session().transactionOpen());
    }

    void cutsBeginOnWhatIsSeen_data()
    {
        QTest::addColumn<QByteArray>("name");
        for (const char* name : {"drill", "laser", "peel", "scissors", "carve brush"})
            QTest::addRow("%s", name) << QByteArray(name);
    }
    /// The front half of the head is hidden: it is cut through the middle, and before it nothing.
    void cutsBeginOnWhatIsSeen()
    {
        QFETCH(QByteArray, name);
        PressFixture fixture;
        core::ClipRegion clip = core::wholeVolume(fixture.workspace.volume()->geometry);
        clip.box.on = true;
        clip.box.minimum.y = 19.5; // the front is where y is small
        fixture.workspace.setClip(clip);
        const auto tool = toolNamed(name, fixture.workspace);
        fixture.workspace.setActiveTool(tool.get());
        QCoreApplication::processEvents();
        test::Pen pen(fixture.view);
        // The cut head shows its shell, 13 to 16 mm from the middle.
        pen.press(fixture.at(10, 0), 1.0, 70000);
        for (const QPointF& place : {fixture.at(18, -1), fixture.at(18, 5), fixture.at(12, 6)})
            pen.move(place, 1.0, 70100);
        pen.release(fixture.at(10, 4), 70200);
        if (name == "peel")
            tool->putAway();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(1));
        const core::ClipHalfSpaces expected =
            core::clipHalfSpaces(clip, fixture.workspace.volume()->geometry);
        const QJsonObject edit = core::editToJson(fixture.session().history().rows().back().edit);
        const auto sides = std::size_t(edit[QStringLiteral("hidden")].toArray().size());
        QCOMPARE(sides, expected->size());
        reference::DenseFields fields = fixture.engine.fields();
        const reference::DenseArray<std::uint8_t> cut = fields.coverage(1);
        int seen = 0;
        for (int z = 0; z < 40; ++z) {
            for (int y = 0; y < 40; ++y) {
                for (int x = 0; x < 40; ++x) {
                    if (y < 20)
                        QVERIFY(cut.at({x, y, z}) == 0);
                    else
                        seen += cut.at({x, y, z}) >= 128 ? 1 : 0;
                }
            }
        }
        QVERIFY(seen > 20);
    }

    void troubleWithPensLeavesNoStrayStep_data()
    {
        QTest::addColumn<QByteArray>("name");
        for (const char* name :
            {"drill", "drill along the normal", "laser", "peel", "scissors", "carve brush"})
            QTest::addRow("%s", name) << QByteArray(name);
    }
    void troubleWithPensLeavesNoStrayStep()
    {
        QFETCH(QByteArray, name);
        PressFixture fixture;
        const auto tool = toolNamed(name, fixture.workspace);
        fixture.workspace.setActiveTool(tool.get());
        QVERIFY(fixture.session().settle());
        const QByteArray before = fixture.session().stateHash();
        const auto begin = [&fixture](test::Pen& pen, double pressure) {
            pen.press(fixture.at(-6, -4), pressure, 10);
            pen.move(fixture.at(6, -4), pressure, 20);
            pen.move(fixture.at(4, 6), pressure, 30);
        };
        const auto isAsBefore = [&] {
            tool->putAway();
            const bool settled = bool(fixture.session().settle());
            return settled && fixture.rows() == 0 && !fixture.session().transactionOpen()
                && fixture.session().stateHash() == before;
        };
        // Another window takes the focus in the middle of a stroke.
        {
            test::Pen pen(fixture.view);
            begin(pen, 1.0);
            QEvent deactivated(QEvent::WindowDeactivate);
            QCoreApplication::sendEvent(&fixture.view, &deactivated);
            pen.move(fixture.at(0, 8), 1.0, 40);
            pen.release(fixture.at(0, 8), 50);
            QVERIFY(isAsBefore());
        }
        // All of it beside the head.
        {
            test::Pen pen(fixture.view);
            pen.press(fixture.at(24, 24), 1.0, 10);
            pen.move(fixture.at(27, 24), 1.0, 20);
            pen.move(fixture.at(25, 27), 1.0, 30);
            pen.release(fixture.at(25, 27), 40);
            QVERIFY(isAsBefore());
        }
        // A driver that knows no pressure: where pressure is the depth, nothing is pressed.
        if (name.startsWith("drill") || name == "laser") {
            test::Pen pen(fixture.view);
            begin(pen, std::numeric_limits<double>::quiet_NaN());
            pen.release(fixture.at(4, 6), 40);
            QVERIFY(isAsBefore());
        }
        // Lifted so fast that no release was told: what was drawn counts, once.
        {
            test::Pen pen(fixture.view);
            begin(pen, 1.0);
            QEvent left(QEvent::TabletLeaveProximity);
            QCoreApplication::sendEvent(qApp, &left);
            pen.release(fixture.at(4, 6), 40);
            if (name == "peel")
                tool->putAway();
            QVERIFY(fixture.session().settle());
            QCOMPARE(fixture.rows(), std::size_t(1));
            QVERIFY(!fixture.session().transactionOpen());
            QVERIFY(fixture.session().undo());
            QVERIFY(fixture.session().settle());
            QCOMPARE(fixture.session().stateHash(), before);
        }
    }
};

BURIN_WINDOW_TEST(LaserToolUiTest)

} // namespace laserToolUiTest

#include "LaserToolUiTest.moc"
