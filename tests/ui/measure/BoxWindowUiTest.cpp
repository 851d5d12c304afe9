// SPDX-License-Identifier: Apache-2.0
#include "ui/measure/BoxWindow.h"

#include "core/session/EditSession.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/Actions.h"
#include "ui/input/Tool.h"
#include "ui/views/ViewGrid.h"

#include <QApplication>
#include <QTest>

#include <vector>

namespace boxWindowUiTest {

namespace {

/// Works everywhere and counts its presses.
class CountingTool : public ui::Tool {
public:
    [[nodiscard]] QString name() const override { return QStringLiteral("Counting"); }
    [[nodiscard]] QString iconName() const override { return QStringLiteral("drill"); }
    [[nodiscard]] QString hint() const override { return QStringLiteral("press"); }
    [[nodiscard]] bool worksIn(const ui::ViewContext&) const override { return true; }
    void press(const ui::PointerSample&, const ui::ViewContext&) override { ++presses; }
    void drag(const ui::PointerSample&, const ui::ViewContext&) override { }
    void release(const ui::PointerSample&, const ui::ViewContext&) override { }
    void cancel() override { }

    int presses = 0;
};

/// The window with the plain CT, whose values tell the column.
class Fixture : public test::WindowFixture {
public:
    Fixture()
        : WindowFixture(test::headFirstSupine())
    {
        workspace.setWindowLevel(before);
        QObject::connect(&workspace, &ui::Workspace::said, &listener,
            [this](const QString& sentence) { said = sentence; });
    }
    /// A pixel of a view, by columns, rows and slices of the volume.
    [[nodiscard]] QPoint at(const ui::SliceView& view, const glm::dvec3& index) const
    {
        return view.context().toPixel(workspace.volume()->geometry.toWorld(index)).toPoint();
    }
    void drag(ui::SliceView& view, Qt::MouseButton button, Qt::KeyboardModifiers keys,
        const QPoint& from, const QPoint& to, bool release = true)
    {
        QTest::mousePress(&view, button, keys, from);
        for (const QPointF& place : {QPointF(from + to) / 2.0, QPointF(to)}) {
            QMouseEvent move(
                QEvent::MouseMove, place, view.mapToGlobal(place), Qt::NoButton, button, keys);
            QApplication::sendEvent(&view, &move);
        }
        if (!release)
            return;
        QTest::mouseRelease(&view, button, keys, to);
        settle();
    }
    /// With the left button, or with a pen.
    void draw(test::DrawnBy by, ui::SliceView& view, const QPoint& from, const QPoint& to)
    {
        test::drawStroke(by, view, {from, QPointF(from + to) / 2.0, to});
        settle();
    }
    /// Until what was drawn is read.
    void settle()
    {
        const bool read = QTest::qWaitFor(
            [this] {
                workspace.session()->poll();
                return !window.views().readsBox();
            },
            60000);
        if (!read)
            qFatal("the box is not read");
    }
    /// The window from the value of one column to that of another.
    [[nodiscard]] core::WindowLevel between(int black, int white) const
    {
        const core::VoxelEncoding& encoding = workspace.volume()->encoding;
        const double low = encoding.value(1000 + black);
        const double high = encoding.value(1000 + white);
        return {0.5 * (low + high), high - low};
    }

    const core::WindowLevel before{11.0, 222.0};
    QString said;
    QObject listener; ///< goes before what it writes
};

} // namespace

class BoxWindowUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theValuesInTheBoxSetTheGreyScale();
    void fewExtremeValuesDecideNothing();
    void itWorksWithAToolAndOnATurnedSlice();
    void theLeftButtonDrawsOneBoxAfterTheMenu_data() { test::addMouseAndPen(); }
    void theLeftButtonDrawsOneBoxAfterTheMenu();
    void nothingHappensWhereThereIsNothingToSee();
    void itCanBeGivenUp();
};

void BoxWindowUiTest::theValuesInTheBoxSetTheGreyScale()
{
    Fixture fixture;
    ui::SliceView& axial = fixture.window.views().axial();
    // Columns 10 … 29 of rows 13 … 33: each column is a twentieth, more than 2 %.
    fixture.drag(axial, Qt::RightButton, Qt::ControlModifier, fixture.at(axial, {9.6, 12.6, 20.0}),
        fixture.at(axial, {29.4, 33.4, 20.0}));
    QCOMPARE(fixture.workspace.windowLevel(), fixture.between(10, 29));
    // From the last corner to the first, on another plane.
    ui::SliceView& coronal = fixture.window.views().coronal();
    fixture.drag(coronal, Qt::RightButton, Qt::ControlModifier,
        fixture.at(coronal, {50.4, 24.0, 10.4}), fixture.at(coronal, {40.6, 24.0, 30.4}));
    QCOMPARE(fixture.workspace.windowLevel(), fixture.between(41, 50));
}

void BoxWindowUiTest::fewExtremeValuesDecideNothing()
{
    Fixture fixture;
    ui::SliceView& axial = fixture.window.views().axial();
    // Columns 2 … 61: sixty, each 1.67 %. The second one brings the share above 2 %, and 98 % are
    // reached with the last but one.
    fixture.drag(axial, Qt::RightButton, Qt::ControlModifier, fixture.at(axial, {1.6, 12.6, 20.0}),
        fixture.at(axial, {61.4, 33.4, 20.0}));
    QCOMPARE(fixture.workspace.windowLevel(), fixture.between(3, 60));
}

void BoxWindowUiTest::itWorksWithAToolAndOnATurnedSlice()
{
    Fixture fixture;
    CountingTool tool;
    fixture.workspace.setActiveTool(&tool);
    ui::SliceView& axial = fixture.window.views().axial();
    int column = 5;
    for (const bool mirrored : {false, true}) {
        for (int quarters = 0; quarters < 4; ++quarters) {
            axial.setTurn({mirrored, quarters});
            fixture.drag(axial, Qt::RightButton, Qt::ControlModifier,
                fixture.at(axial, {column - 0.4, 10.6, 20.0}),
                fixture.at(axial, {column + 9.4, 20.4, 20.0}));
            QCOMPARE(fixture.workspace.windowLevel(), fixture.between(column, column + 9));
            column += 3;
        }
    }
    QCOMPARE(tool.presses, 0);
    fixture.workspace.setActiveTool(nullptr);
}

void BoxWindowUiTest::theLeftButtonDrawsOneBoxAfterTheMenu()
{
    QFETCH(const test::DrawnBy, by);
    Fixture fixture;
    CountingTool tool;
    fixture.workspace.setActiveTool(&tool);
    ui::SliceView& axial = fixture.window.views().axial();
    QAction& action = fixture.window.actionTable()[QStringLiteral("window.box")];
    action.trigger();
    QVERIFY(action.isChecked());
    QVERIFY(!fixture.said.isEmpty());
    const QPoint from = fixture.at(axial, {19.6, 12.6, 20.0});
    const QPoint to = fixture.at(axial, {29.4, 33.4, 20.0});
    fixture.draw(by, axial, from, to);
    QCOMPARE(fixture.workspace.windowLevel(), fixture.between(20, 29));
    QCOMPARE(tool.presses, 0);
    // Then the button is the tool's again.
    QVERIFY(!action.isChecked());
    fixture.draw(by, axial, from, to);
    QCOMPARE(tool.presses, 1);
    QCOMPARE(fixture.workspace.windowLevel(), fixture.between(20, 29));
    fixture.workspace.setActiveTool(nullptr);
}

void BoxWindowUiTest::nothingHappensWhereThereIsNothingToSee()
{
    Fixture fixture;
    // A sagittal slice of one column.
    ui::SliceView& sagittal = fixture.window.views().sagittal();
    fixture.drag(sagittal, Qt::RightButton, Qt::ControlModifier,
        fixture.at(sagittal, {31.0, 10.0, 10.0}), fixture.at(sagittal, {31.0, 30.0, 30.0}));
    QCOMPARE(fixture.workspace.windowLevel(), fixture.before);
    QVERIFY(fixture.said.contains(QLatin1String("the same")));
    // Beside the volume, which leaves a margin.
    fixture.drag(sagittal, Qt::RightButton, Qt::ControlModifier, QPoint(2, 2), QPoint(14, 14));
    QCOMPARE(fixture.workspace.windowLevel(), fixture.before);
    QVERIFY(fixture.said.contains(QLatin1String("No voxel")));
    // A line is no box.
    fixture.said.clear();
    ui::SliceView& axial = fixture.window.views().axial();
    const QPoint from = axial.rect().center();
    fixture.drag(axial, Qt::RightButton, Qt::ControlModifier, from, from + QPoint(60, 0));
    QCOMPARE(fixture.workspace.windowLevel(), fixture.before);
    QVERIFY(fixture.said.isEmpty());
}

void BoxWindowUiTest::itCanBeGivenUp()
{
    Fixture fixture;
    ui::SliceView& axial = fixture.window.views().axial();
    const QPoint from = fixture.at(axial, {9.6, 12.6, 20.0});
    const QPoint to = fixture.at(axial, {29.4, 33.4, 20.0});
    const double scale = axial.context().mmPerPixel();
    QTest::mouseMove(&axial, to); // what lies under the pointer is marked
    fixture.settle();
    const QImage without = axial.grab().toImage();
    fixture.drag(axial, Qt::RightButton, Qt::ControlModifier, from, to, false);
    QVERIFY(axial.grab().toImage() != without); // the box is seen
    QTest::keyClick(&axial, Qt::Key_Escape);
    QTest::mouseRelease(&axial, Qt::RightButton, Qt::ControlModifier, to);
    fixture.settle();
    QCOMPARE(fixture.workspace.windowLevel(), fixture.before);
    QCOMPARE(axial.grab().toImage(), without);
    QCOMPARE(axial.context().mmPerPixel(), scale); // it was no zoom either

    // What was chosen in the menu is given up by Esc, by a click, and by choosing it again.
    QAction& action = fixture.window.actionTable()[QStringLiteral("window.box")];
    const glm::dvec3 crosshair = fixture.workspace.crosshairLps();
    action.trigger();
    QTest::keyClick(&axial, Qt::Key_Escape);
    QVERIFY(!action.isChecked());
    action.trigger();
    QTest::mouseClick(&axial, Qt::LeftButton, {}, from);
    QVERIFY(!action.isChecked());
    QVERIFY(fixture.workspace.crosshairLps() == crosshair);
    action.trigger();
    action.trigger();
    QVERIFY(!action.isChecked());
}

BURIN_WINDOW_TEST(BoxWindowUiTest)

} // namespace boxWindowUiTest

#include "BoxWindowUiTest.moc"
