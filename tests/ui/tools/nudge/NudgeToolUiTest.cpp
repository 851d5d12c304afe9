// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/nudge/NudgeTool.h"

#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/views/MprPlanes.h"
#include "ui/views/ViewGrid.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace nudgeToolUiTest {

namespace {

using Labels = std::vector<std::uint8_t>;
using Way = std::vector<glm::dvec3>; ///< indices

constexpr int side = test::smallHead::side;

glm::ivec3 voxelAt(std::size_t offset)
{
    const int at = int(offset);
    return {at % side, at / side % side, at / (side * side)};
}

/// The real window with the small head, and the crosshair in its middle voxel (20, 20, 20).
class Fixture : public test::WindowFixture {
public:
    Fixture()
        : test::WindowFixture(test::smallHead::volume())
        , tool(workspace)
        , views(window.views())
    {
        workspace.setCrosshairLps(place({20.0, 20.0, 20.0}));
        workspace.setActiveTool(&tool);
        tool.setSettings({.radiusMm = 10.0, .fits = true});
    }
    /// A ball of 8 mm around the middle.
    void addLiver()
    {
        apply(test::newSegment(QStringLiteral("Liver")));
        apply(test::paintAt(1, {place({20.0, 20.0, 20.0})}, 8.0));
        workspace.setActiveSegment(1);
    }
    [[nodiscard]] const core::PaintStroke& lastEdit()
    {
        return session().history().rows().back().edit.get<core::PaintStroke>();
    }
    [[nodiscard]] Labels labels() { return *session().questions().labels(0); }
    /// Waits for what is found out beside the window.
    [[nodiscard]] bool comes(const std::function<bool()>& what)
    {
        for (int i = 0; i < 5000 && !what(); ++i) {
            session().poll();
            QTest::qWait(1);
        }
        return what();
    }
    [[nodiscard]] int labelNow(const glm::ivec3& voxel)
    {
        const auto label = std::make_shared<int>(-1);
        session().questions().probe(
            {voxel}, [label](const core::Result<std::vector<core::ProbedVoxel>>& probes) {
                if (probes)
                    *label = probes->front().label;
            });
        return comes([label] { return *label >= 0; }) ? *label : -1;
    }
    void mouse(ui::ImageView& view, QEvent::Type type, const glm::dvec3& index,
        Qt::KeyboardModifiers modifiers = {})
    {
        WindowFixture::mouse(view, type, pixel(view, index), modifiers);
    }
    void hover(ui::ImageView& view, const glm::dvec3& index, Qt::KeyboardModifiers modifiers = {})
    {
        WindowFixture::hover(view, pixel(view, index), modifiers);
    }
    void pushByMouse(ui::ImageView& view, const Way& way, Qt::KeyboardModifiers modifiers = {})
    {
        for (std::size_t i = 0; i < way.size(); ++i)
            mouse(view, i == 0 ? QEvent::MouseButtonPress : QEvent::MouseMove, way[i], modifiers);
        mouse(view, QEvent::MouseButtonRelease, way.back(), modifiers);
        waitForStroke();
    }
    /// Pressed now firmly, now gently.
    void pushByPen(ui::ImageView& view, const Way& way, test::Pen::End end = test::Pen::End::Tip)
    {
        test::Pen pen(view, end);
        pen.press(pixel(view, way.front()), 0.2, m_milliseconds += 8);
        for (std::size_t i = 1; i < way.size(); ++i)
            pen.move(pixel(view, way[i]), i % 2 == 1 ? 1.0 : 0.4, m_milliseconds += 8);
        pen.release(pixel(view, way.back()), m_milliseconds += 8);
        waitForStroke();
    }
    void waitForStroke()
    {
        QVERIFY(comes([this] { return !tool.isPushing(); }));
        QVERIFY(session().settle());
    }

    ui::NudgeTool tool;
    ui::ViewGrid& views;

private:
    quint64 m_milliseconds = 50000;
};

/// In the slice across an axis.
double distanceMm(glm::dvec3 a, glm::dvec3 b, int axis)
{
    a[axis] = b[axis] = 0.0;
    return glm::distance(a, b);
}

/// From the path, in the slice across an axis.
double awayFromPathMm(const std::vector<glm::dvec3>& pathLps, const glm::dvec3& at, int axis)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < pathLps.size(); ++i) {
        const glm::dvec3 from = pathLps[i == 0 ? 0 : i - 1];
        const glm::dvec3 along = pathLps[i] - from;
        const double squared = glm::dot(along, along);
        const double t =
            squared > 0.0 ? std::clamp(glm::dot(at - from, along) / squared, 0.0, 1.0) : 0.0;
        least = std::min(least, distanceMm(at, from + t * along, axis));
    }
    return least;
}

/// Compares a nudge in slice 20 across an axis with its rule, in real numbers; near the edge of the
/// disc rounding decides. @param mayChange whether other limits allow it
void compareWithRule(
    Fixture& fixture, const Labels& before, const Labels& after, int axis,
    const std::function<bool(std::size_t)>& mayChange = [](std::size_t) { return true; })
{
    const core::PaintStroke& edit = fixture.lastEdit();
    const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
    int moved = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const glm::ivec3 voxel = voxelAt(i);
        const double away =
            awayFromPathMm(edit.path.pointsLps, geometry.toWorld(glm::dvec3(voxel)), axis);
        if (std::abs(away - edit.path.radiusMm) < 0.005)
            continue;
        const bool isSwept = voxel[axis] == 20 && away < edit.path.radiusMm && mayChange(i);
        const int expected = isSwept ? (edit.erase ? 0 : 1) : before[i];
        if (after[i] != expected)
            QFAIL(qPrintable(QStringLiteral("%1, %2, %3").arg(voxel.x).arg(voxel.y).arg(voxel.z)));
        moved += expected != before[i];
    }
    QVERIFY(moved > 10);
}

/// How far it is from where a stroke began to the nearest voxel on the other side of the border.
double toBorderMm(Fixture& fixture, const Labels& before, int axis, bool inside)
{
    const glm::dvec3 start = fixture.lastEdit().path.pointsLps.front();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < before.size(); ++i) {
        const glm::ivec3 voxel = voxelAt(i);
        if (voxel[axis] == 20 && (before[i] == 1) != inside)
            least = std::min(least, distanceMm(fixture.place(glm::dvec3(voxel)), start, axis));
    }
    return least;
}

} // namespace

class NudgeToolUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// In each of the slices, with mouse and pen, from inside and from beside the segment.
    void itPushesTheBorder_data()
    {
        QTest::addColumn<int>("axis");
        QTest::addColumn<bool>("pen");
        QTest::addColumn<bool>("outwards");
        const char* const names[] = {"sagittal", "coronal", "axial"};
        for (int axis = 0; axis < 3; ++axis) {
            for (const bool pen : {false, true}) {
                for (const bool outwards : {false, true})
                    QTest::addRow("%s, %s, %s", names[axis], pen ? "pen" : "mouse",
                        outwards ? "outwards" : "inwards")
                        << axis << pen << outwards;
            }
        }
    }
    void itPushesTheBorder()
    {
        QFETCH(const int, axis);
        QFETCH(const bool, pen);
        QFETCH(const bool, outwards);
        Fixture fixture;
        fixture.addLiver();
        const std::array<ui::SliceView*, 3> views{
            &fixture.views.sagittal(), &fixture.views.coronal(), &fixture.views.axial()};
        ui::SliceView& view = *views.at(std::size_t(axis));
        Way way;
        for (const double along :
            outwards ? std::array{22.0, 26.0, 30.0} : std::array{33.0, 30.0, 26.0}) {
            glm::dvec3 index(20.0);
            index[axis == 0 ? 1 : 0] = along;
            way.push_back(index);
        }
        const Labels before = fixture.labels();
        const std::size_t rows = fixture.rows();
        if (pen)
            fixture.pushByPen(view, way);
        else
            fixture.pushByMouse(view, way);
        QCOMPARE(fixture.rows(), rows + 1);
        const core::PaintStroke edit = fixture.lastEdit();
        QVERIFY(edit.tool == core::PaintStroke::Tool::Nudge);
        QVERIFY(edit.path.shape == core::BrushPath::Shape::Disc);
        QCOMPARE(edit.segment, 1);
        QCOMPARE(edit.erase, !outwards);
        QVERIFY(!edit.path.pressures && !edit.edgeTolerance && !edit.overwriteUnlocked);
        QCOMPARE(edit.path.pointsLps.size(), way.size());
        // It began wholly on one side of the border, and no smaller than need be.
        const double border = toBorderMm(fixture, before, axis, outwards);
        QVERIFY(border < 10.0);
        QVERIFY2(edit.path.radiusMm < border && edit.path.radiusMm > border - 0.02,
            qPrintable(QStringLiteral("%1 of %2").arg(edit.path.radiusMm).arg(border)));
        const Labels after = fixture.labels();
        compareWithRule(fixture, before, after, axis);
        const QString name = fixture.session().history().rows().back().name;
        QVERIFY2(name.startsWith(outwards ? QStringLiteral("Nudge 'Liver' outwards ")
                                          : QStringLiteral("Nudge 'Liver' inwards ")),
            qPrintable(name));

        // The same stroke as a recipe comes to the same.
        test::WorkspaceFixture recipe;
        for (const core::HistoryRow& row : fixture.session().history().rows())
            recipe.apply(row.edit);
        QCOMPARE(recipe.session().stateHash(), fixture.session().stateHash());
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QVERIFY(fixture.labels() == before);
        QVERIFY(fixture.session().redo() && fixture.session().settle());
        QVERIFY(fixture.labels() == after);
    }

    /// Switched on, the disc is as large as the pen is pressed, up to the radius that it has
    /// otherwise; a mouse has that.
    void theRadiusFollowsThePressure()
    {
        Fixture fixture;
        fixture.addLiver();
        ui::SliceView& axial = fixture.views.axial();
        auto* button = fixture.window.findChild<QToolButton*>(QStringLiteral("radiusByPressure"));
        QVERIFY(button && !button->isChecked());
        button->click();
        QVERIFY(fixture.tool.settings().radiusByPressure);
        const std::size_t rows = fixture.rows();
        const Labels before = fixture.labels();
        const Way way{{22, 20, 20}, {28, 20, 20}, {28, 20, 20}, {28, 20, 20}};
        {
            test::Pen pen(axial);
            quint64 time = 90000;
            pen.press(fixture.pixel(axial, way[0]), 0.3, time);
            pen.move(fixture.pixel(axial, way[1]), 0.5, time += 8);
            pen.move(fixture.pixel(axial, way[2]), 0.9, time += 8); // it rests, and is pressed
            pen.move(fixture.pixel(axial, way[3]), 0.4, time += 8); // less changes nothing
            pen.release(fixture.pixel(axial, way[3]), time + 8);
        }
        fixture.waitForStroke();
        QCOMPARE(fixture.rows(), rows + 1);
        const core::PaintStroke edit = fixture.lastEdit();
        QVERIFY(edit.tool == core::PaintStroke::Tool::Nudge && edit.path.pressures);
        QCOMPARE(edit.path.pointsLps.size(), std::size_t(3));
        QCOMPARE(edit.path.pressures->size(), std::size_t(3));
        const double expected[] = {0.3, 0.5, 0.9};
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(std::abs((*edit.path.pressures)[i] - expected[i]) < 1e-4);
        // At full pressure it would just fit.
        const double border = toBorderMm(fixture, before, 2, true);
        QVERIFY(edit.path.radiusMm < border && edit.path.radiusMm > border - 0.02);
        const auto gained = [&before](const Labels& after) {
            return std::count(after.begin(), after.end(), 1)
                - std::count(before.begin(), before.end(), 1);
        };
        const std::ptrdiff_t pressed = gained(fixture.labels());
        QVERIFY(pressed > 10);
        test::WorkspaceFixture recipe;
        for (const core::HistoryRow& row : fixture.session().history().rows())
            recipe.apply(row.edit);
        QCOMPARE(recipe.session().stateHash(), fixture.session().stateHash());
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QVERIFY(fixture.labels() == before);
        // Inwards, with the eraser end, from the first touch on.
        fixture.pushByPen(axial, {{20, 20, 20}, {21, 20, 20}}, test::Pen::End::Eraser);
        QVERIFY(fixture.lastEdit().erase && fixture.lastEdit().path.pressures);
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        // A mouse knows no pressure.
        fixture.pushByMouse(axial, way);
        QVERIFY(!fixture.lastEdit().path.pressures);
        QCOMPARE(fixture.lastEdit().path.radiusMm, edit.path.radiusMm);
        QVERIFY2(gained(fixture.labels()) > pressed, qPrintable(QString::number(pressed)));
    }

    void controlAndTheEraserEndInvert()
    {
        Fixture fixture;
        fixture.addLiver();
        fixture.tool.setSettings({.radiusMm = 3.0, .fits = true});
        ui::SliceView& axial = fixture.views.axial();
        const Labels before = fixture.labels();
        fixture.pushByMouse(axial, {{20, 20, 20}, {21, 20, 20}}, Qt::ControlModifier);
        QVERIFY(fixture.lastEdit().erase);
        QCOMPARE(fixture.lastEdit().path.radiusMm, 3.0); // the border is farther away
        const Labels hollow = fixture.labels();
        compareWithRule(fixture, before, hollow, 2);
        fixture.pushByPen(axial, {{33, 20, 20}, {34, 20, 20}}, test::Pen::End::Eraser);
        QVERIFY(!fixture.lastEdit().erase);
        QCOMPARE(fixture.lastEdit().path.radiusMm, 3.0);
        compareWithRule(fixture, hollow, fixture.labels(), 2);
    }

    /// On a slice that is turned about the line from the feet to the head.
    void itWorksOnObliqueSlices()
    {
        Fixture fixture;
        fixture.addLiver();
        fixture.views.planes().turnOthers(ui::SliceOrientation::Axial, 0.6);
        QCoreApplication::processEvents();
        ui::SliceView& coronal = fixture.views.coronal();
        const Labels before = fixture.labels();
        const std::size_t rows = fixture.rows();
        fixture.pushByPen(coronal, {{20, 20, 20}});
        QCOMPARE(fixture.rows(), rows); // it has not touched the border
        fixture.pushByPen(coronal, {{20, 20, 20}, {20, 20, 26}});
        QCOMPARE(fixture.rows(), rows + 1);
        const core::PaintStroke edit = fixture.lastEdit();
        const double radiusMm = edit.path.radiusMm;
        QVERIFY2(radiusMm > 6.0 && radiusMm < 9.0, qPrintable(QString::number(radiusMm)));
        const glm::dvec3 normal = glm::normalize(*edit.path.normalLps);
        QVERIFY(std::abs(normal.x) > 0.3 && std::abs(normal.y) > 0.3);
        const Labels after = fixture.labels();
        const glm::dvec3 from = edit.path.pointsLps.front();
        const glm::dvec3 along = edit.path.pointsLps.back() - from;
        int moved = 0;
        for (std::size_t i = 0; i < after.size(); ++i) {
            if (after[i] == before[i])
                continue;
            QCOMPARE(int(after[i]), 1);
            const glm::dvec3 way = fixture.place(glm::dvec3(voxelAt(i))) - from;
            QVERIFY(std::abs(glm::dot(way, normal)) < 1.0); // one voxel thick
            const double share =
                std::clamp(glm::dot(way, along) / glm::dot(along, along), 0.0, 1.0);
            const glm::dvec3 aside = way - share * along;
            QVERIFY(glm::length(aside - normal * glm::dot(aside, normal)) < radiusMm + 0.005);
            ++moved;
        }
        QVERIFY(moved > 30);
        const auto offset = [](int x, int y, int z) {
            return std::size_t(x + side * (y + side * z));
        };
        QCOMPARE(int(before[offset(20, 20, 29)]), 0);
        QCOMPARE(int(after[offset(20, 20, 29)]), 1);
    }

    void withoutFittingItHasItsRadius()
    {
        Fixture fixture;
        fixture.addLiver();
        fixture.tool.setSettings({.radiusMm = 10.0, .fits = false});
        const Labels before = fixture.labels();
        fixture.pushByMouse(fixture.views.axial(), {{25, 20, 20}});
        QVERIFY(!fixture.lastEdit().erase);
        QCOMPARE(fixture.lastEdit().path.radiusMm, 10.0);
        compareWithRule(fixture, before, fixture.labels(), 2);
    }

    /// Nothing jumps where it is pressed, and what changes nothing leaves no step.
    void aTouchAloneChangesNothing()
    {
        Fixture fixture;
        fixture.addLiver();
        const Labels before = fixture.labels();
        const std::size_t rows = fixture.rows();
        for (const double column : {15.0, 22.4, 26.7, 29.3, 31.0})
            fixture.pushByMouse(fixture.views.axial(), {{column, 20.3, 20}});
        QCOMPARE(fixture.rows(), rows);
        QVERIFY(fixture.labels() == before);
    }

    void theCursorSaysWhichWay()
    {
        Fixture fixture;
        fixture.addLiver();
        ui::SliceView& axial = fixture.views.axial();
        fixture.hover(axial, {22, 20, 20});
        QVERIFY(fixture.comes([&] { return fixture.tool.start().has_value(); }));
        QVERIFY(fixture.tool.start()->isInside);
        QCOMPARE(fixture.tool.target(), QStringLiteral("pushes Liver outwards"));
        QVERIFY(fixture.tool.radiusMm() > 5.0 && fixture.tool.radiusMm() < 7.0);
        const QImage outwards = axial.grab().toImage();
        fixture.hover(axial, {22, 20, 20}, Qt::ControlModifier);
        QCOMPARE(fixture.tool.target(), QStringLiteral("pushes Liver inwards"));
        QVERIFY(axial.grab().toImage() != outwards);
        // The pointer goes on faster than that is found out; the last place counts.
        for (const double column : {24.0, 28.0, 32.0, 33.0})
            fixture.hover(axial, {column, 20, 20});
        QVERIFY(fixture.comes([&] {
            return fixture.tool.start() && !fixture.tool.start()->isInside
                && fixture.tool.radiusMm() > 4.5;
        }));
        QCOMPARE(fixture.tool.target(), QStringLiteral("pushes Liver inwards"));
        QVERIFY(fixture.tool.radiusMm() < 6.5);
        // What is taken back is seen at once.
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.comes([&] { return fixture.tool.radiusMm() == 10.0; }));
        fixture.apply(test::lockSegment(1));
        QCOMPARE(fixture.tool.target(), QStringLiteral("Liver is locked"));
    }

    void itShowsWhileThePenIsDownAndEscTakesItBack()
    {
        Fixture fixture;
        fixture.addLiver();
        ui::SliceView& axial = fixture.views.axial();
        const Labels before = fixture.labels();
        const std::size_t rows = fixture.rows();
        fixture.mouse(axial, QEvent::MouseButtonPress, {22, 20, 20});
        fixture.mouse(axial, QEvent::MouseMove, {25, 20, 20});
        QVERIFY(fixture.comes([&] { return fixture.session().transactionOpen(); }));
        QCOMPARE(fixture.tool.target(), QStringLiteral("pushes Liver outwards"));
        QCOMPARE(fixture.labelNow({29, 20, 20}), 1);
        QCOMPARE(fixture.labelNow({34, 20, 20}), 0);
        fixture.mouse(axial, QEvent::MouseMove, {30, 20, 20});
        QCOMPARE(fixture.labelNow({34, 20, 20}), 1);
        // It does not turn round where it comes to.
        QCOMPARE(fixture.tool.target(), QStringLiteral("pushes Liver outwards"));
        fixture.tool.cancel();
        fixture.mouse(axial, QEvent::MouseButtonRelease, {30, 20, 20});
        QVERIFY(fixture.session().settle());
        QVERIFY(!fixture.tool.isPushing());
        QCOMPARE(fixture.rows(), rows);
        QVERIFY(fixture.labels() == before);
        // Before it is known where it begins it is dropped as well.
        fixture.mouse(axial, QEvent::MouseButtonPress, {22, 20, 20});
        fixture.mouse(axial, QEvent::MouseMove, {30, 20, 20});
        fixture.tool.cancel();
        fixture.mouse(axial, QEvent::MouseButtonRelease, {30, 20, 20});
        QVERIFY(fixture.session().settle());
        QTest::qWait(5);
        QVERIFY(!fixture.session().transactionOpen());
        QCOMPARE(fixture.rows(), rows);
        QVERIFY(fixture.labels() == before);
        // Let go of before that is known, only undo drops it.
        for (const bool undone : {true, false}) {
            fixture.mouse(axial, QEvent::MouseButtonPress, {22, 20, 20});
            fixture.mouse(axial, QEvent::MouseMove, {30, 20, 20});
            fixture.mouse(axial, QEvent::MouseButtonRelease, {30, 20, 20});
            QVERIFY(fixture.tool.canTakeStepBack());
            if (undone)
                fixture.tool.takeStepBack();
            else
                fixture.tool.cancel();
            QVERIFY(fixture.comes([&] { return !fixture.tool.isPushing(); }));
            QVERIFY(fixture.session().settle());
            QCOMPARE(fixture.rows(), rows + (undone ? 0 : 1));
        }
    }

    void itKeepsToTheLimits()
    {
        Fixture fixture;
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.pushByMouse(fixture.views.axial(), {{20, 20, 20}});
        QCOMPARE(said.size(), 1);
        QCOMPARE(said.front().front().toString(), QStringLiteral("There is no segment to nudge"));
        QCOMPARE(fixture.rows(), std::size_t(0));
        fixture.addLiver();

        // Only soft tissue: brain and ventricle, neither bone nor air.
        fixture.workspace.setEditableSettings(
            {.on = true, .byValue = true, .lower = -100.0, .upper = 100.0});
        const Labels before = fixture.labels();
        fixture.pushByMouse(fixture.views.axial(), {{22, 20, 20}, {34, 20, 20}});
        QVERIFY(fixture.lastEdit().editable);
        const std::vector<std::uint16_t> codes = test::smallHead::volume().codes;
        compareWithRule(fixture, before, fixture.labels(), 2,
            [&](std::size_t i) { return std::abs(int(codes[i]) - 1024) <= 100; });

        // Another segment keeps its voxels, and a locked one is not nudged.
        fixture.workspace.setEditableSettings({});
        fixture.apply(test::newSegment(QStringLiteral("Bone")));
        fixture.apply(test::paintAt(2, {fixture.place({8.0, 20.0, 20.0})}, 3.0));
        fixture.workspace.setActiveSegment(1);
        const Labels beside = fixture.labels();
        fixture.pushByMouse(fixture.views.axial(), {{18, 20, 20}, {10, 20, 20}});
        compareWithRule(
            fixture, beside, fixture.labels(), 2, [&](std::size_t i) { return beside[i] != 2; });
        fixture.apply(test::lockSegment(1));
        const std::size_t rows = fixture.rows();
        const Labels locked = fixture.labels();
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        fixture.pushByMouse(fixture.views.axial(), {{18, 20, 20}, {4, 20, 20}});
        QCOMPARE(failed.size(), 1);
        QCOMPARE(fixture.rows(), rows);
        QVERIFY(fixture.labels() == locked);
    }

    void theOptionsAreInWords()
    {
        Fixture fixture;
        fixture.addLiver();
        auto* radius = fixture.window.findChild<QDoubleSpinBox*>(QStringLiteral("nudgeRadius"));
        auto* fits = fixture.window.findChild<QCheckBox*>(QStringLiteral("nudgeFits"));
        QVERIFY(radius && fits);
        QCOMPARE(radius->value(), 10.0);
        QVERIFY(fits->isChecked());
        radius->setValue(6.5);
        fits->click();
        QVERIFY(
            (fixture.tool.settings() == ui::NudgeTool::Settings{.radiusMm = 6.5, .fits = false}));
        fixture.window.findChild<QToolButton*>(QStringLiteral("radiusByPressure"))->click();
        fixture.tool.changeRadius(1);
        QCOMPARE(radius->value(), 7.0);
        ui::NudgeTool other(fixture.workspace);
        QVERIFY(!(other.settings() == fixture.tool.settings()));
        other.applySettings(fixture.tool.settingsJson());
        QVERIFY(other.settings() == fixture.tool.settings());
        other.applySettings({{QStringLiteral("radiusMm"), 5000.0}});
        QCOMPARE(other.settings().radiusMm, 7.0);
        QVERIFY(fixture.window.minimumSizeHint().width() <= 1280);
    }
};

BURIN_WINDOW_TEST(NudgeToolUiTest)

} // namespace nudgeToolUiTest

#include "NudgeToolUiTest.moc"
