// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/view/UndoHereTool.h"

#include "core/edits/kinds/history/RevertRows.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/views/ViewGrid.h"

#include <QSignalSpy>
#include <QtTest>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace undoHereToolUiTest {

namespace {

using Voxels = std::set<std::array<int, 3>>;

/// The small head with a segment of two dabs beside each other in the middle slice.
class Fixture : public test::WindowFixture {
public:
    Fixture()
        : test::WindowFixture(test::smallHead::volume())
        , tool(workspace)
        , slice(window.views().axial())
        , view(window.views().volume())
    {
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        workspace.setVolumeDisplay(display);
        workspace.setCrosshairLps(place({20.0, 20.0, 20.0}));
        workspace.setActiveTool(&tool);
        view.lookFrom({0.0, -1.0, 0.0});
        apply(test::newSegment(QStringLiteral("Dabs")));
        apply(test::paintAt(1, {place(left)}, 2.0));
        one = voxels();
        apply(test::paintAt(1, {place(right)}, 3.0));
        both = voxels();
    }
    void settle()
    {
        // What an answer asks for is asked after it came.
        for (int i = 0; i < 4; ++i) {
            session().poll();
            if (!session().settle())
                qFatal("not settled");
        }
    }
    void draw(test::DrawnBy by, ui::ImageView& where, const std::vector<QPointF>& way)
    {
        test::drawStroke(by, where, way);
        settle();
    }
    [[nodiscard]] QString lastRow() { return session().history().rows().back().name; }
    /// The rows that the last one takes back; none: it takes back nothing.
    [[nodiscard]] std::vector<core::RowId> takenBack()
    {
        const auto* revert = session().history().rows().back().edit.as<core::RevertRows>();
        return revert ? revert->rows : std::vector<core::RowId>();
    }
    /// How many voxels are carved.
    [[nodiscard]] std::ptrdiff_t carved()
    {
        reference::DenseFields fields = engine.fields();
        const std::vector<std::uint8_t> values = fields.coverage(1).values;
        return std::count_if(
            values.begin(), values.end(), [](std::uint8_t value) { return value >= 128; });
    }

    static constexpr glm::dvec3 left{12.0, 20.0, 20.0};
    static constexpr glm::dvec3 right{28.0, 20.0, 20.0};

    ui::UndoHereTool tool;
    ui::SliceView& slice;
    ui::VolumeView& view;
    Voxels one; ///< of the first dab
    Voxels both;
};

} // namespace

class UndoHereToolUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// The earlier of two steps goes, the later one stays.
    void aClickTakesBackTheStepThere_data() { test::addMouseAndPen(); }
    void aClickTakesBackTheStepThere()
    {
        QFETCH(const test::DrawnBy, by);
        Fixture fixture;
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const QByteArray before = fixture.session().stateHash();
        fixture.draw(by, fixture.slice, {fixture.pixel(fixture.slice, fixture.left)});
        QCOMPARE(fixture.rows(), std::size_t(4));
        QCOMPARE(fixture.takenBack(), std::vector<core::RowId>{2});
        QCOMPARE(fixture.lastRow(),
            QStringLiteral("Undo only 'Paint 'Dabs' 2.0 mm', %1 voxels").arg(fixture.one.size()));
        QVERIFY(!said.empty());
        QCOMPARE(said.back().front().toString(),
            QStringLiteral("Undoing only %1; Ctrl+Z brings it back")
                .arg(fixture.session().history().row(2).name));
        Voxels expected = fixture.both;
        for (const std::array<int, 3>& voxel : fixture.one)
            expected.erase(voxel);
        QVERIFY(fixture.voxels() == expected);
        QVERIFY(test::isWhatARecipeComesTo(fixture.session()));
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), before);
    }

    void aRectangleSaysHowFar_data() { test::addMouseAndPen(); }
    void aRectangleSaysHowFar()
    {
        QFETCH(const test::DrawnBy, by);
        Fixture fixture;
        // Around the right dab, which a click in its corner would not reach.
        const auto at = [&fixture](const glm::dvec3& index) {
            return fixture.pixel(fixture.slice, index);
        };
        const glm::dvec3 corner(36.0, 30.0, 20.0);
        for (int i = 0; i < 4; ++i)
            fixture.tool.changeRadius(-1); // 1 mm
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.draw(by, fixture.slice, {at(corner)});
        QCOMPARE(fixture.rows(), std::size_t(3));
        QCOMPARE(said.back().front().toString(), QStringLiteral("There is no step to undo here"));
        fixture.draw(
            by, fixture.slice, {at(corner), at({30.0, 25.0, 20.0}), at({24.0, 15.0, 20.0})});
        QCOMPARE(fixture.rows(), std::size_t(4));
        QCOMPARE(fixture.takenBack(), std::vector<core::RowId>{3});
        QVERIFY(fixture.voxels() == fixture.one);
        QVERIFY(test::isWhatARecipeComesTo(fixture.session()));
        // The next one around both finds what is left.
        fixture.draw(
            by, fixture.slice, {at(corner), at({20.0, 20.0, 20.0}), at({6.0, 12.0, 20.0})});
        QCOMPARE(fixture.rows(), std::size_t(5));
        QVERIFY(fixture.voxels().empty());
    }

    void inThreeDimensionsItIsWhatIsSeen_data() { test::addMouseAndPen(); }
    void inThreeDimensionsItIsWhatIsSeen()
    {
        QFETCH(const test::DrawnBy, by);
        Fixture fixture;
        fixture.apply(test::carveAt({{0.0, -16.0, 0.0}}, 4.0));
        const std::ptrdiff_t dent = fixture.carved();
        fixture.apply(test::carveAt({{0.0, 0.0, 24.0}}, 6.0)); // on top
        const std::ptrdiff_t both = fixture.carved();
        QVERIFY(dent > 20 && both > dent);
        const QPointF middle(fixture.view.width() / 2.0, fixture.view.height() / 2.0);
        fixture.draw(by, fixture.view, {middle});
        QCOMPARE(fixture.rows(), std::size_t(6));
        QCOMPARE(fixture.takenBack(), std::vector<core::RowId>{4});
        QCOMPARE(fixture.carved(), both - dent);
        QVERIFY(fixture.voxels() == fixture.both);
        QVERIFY(test::isWhatARecipeComesTo(fixture.session()));
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.draw(by, fixture.view, {QPointF(6.0, 6.0)});
        QCOMPARE(fixture.rows(), std::size_t(6));
        QCOMPARE(said.back().front().toString(), QStringLiteral("Nothing is seen there"));
    }

    void escapeLeavesAllAsItIs()
    {
        Fixture fixture;
        const QPointF at = fixture.pixel(fixture.slice, fixture.left);
        test::Pen pen(fixture.slice);
        pen.press(at, 1.0, 1000);
        QTest::keyClick(&fixture.slice, Qt::Key_Escape);
        pen.release(at, 1010);
        fixture.settle();
        QCOMPARE(fixture.rows(), std::size_t(3));
        QVERIFY(fixture.voxels() == fixture.both);
    }
};

BURIN_WINDOW_TEST(UndoHereToolUiTest)

} // namespace undoHereToolUiTest

#include "UndoHereToolUiTest.moc"
