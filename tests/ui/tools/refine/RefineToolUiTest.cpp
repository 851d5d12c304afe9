// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/edits/kinds/surface/ApplyTemplate.h"
#include "core/edits/kinds/surface/ChangeMarks.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/MarkSurface.h"
#include "core/edits/kinds/surface/PointDrag.h"
#include "core/edits/kinds/surface/SpherePush.h"
#include "core/edits/kinds/surface/SurfaceBarrier.h"
#include "core/edits/kinds/surface/WriteBack.h"
#include "core/refine/repair/SelfIntersections.h"
#include "core/session/SessionSurface.h"
#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/base/Actions.h"
#include "ui/menus/EditableButton.h"
#include "ui/panels/refine/RefineActions.h"
#include "ui/panels/refine/RefinePanel.h"
#include "ui/tools/refine/RefineTool.h"
#include "ui/views/ViewGrid.h"
#include "ui/widgets/FittingLabel.h"

#include <QCheckBox>
#include <QJsonDocument>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace refineToolUiTest {

namespace {

using Mode = ui::Refinement::Mode;
using core::SurfaceMark;

constexpr double radius = 10.0; // of the ball, voxels across the slices' plane

/// The real window with the small head and a ball as segment 1.
class RefineFixture : public test::WindowFixture {
public:
    RefineFixture()
        : test::WindowFixture(test::smallHead::volume())
        , tool(workspace)
        , panel(workspace)
        , slice(window.views().axial())
        , view(window.views().volume())
    {
        apply(test::ballMask(glm::ivec3(test::smallHead::side), radius));
        workspace.setActiveSegment(1);
        workspace.setActiveTool(&tool);
        view.lookFrom({0.0, -1.0, 0.0});
    }
    [[nodiscard]] ui::Refinement& refinement() { return workspace.refinement(); }
    void apply(const core::Edit& edit)
    {
        QVERIFY(session().apply(edit));
        settle();
    }
    /// Updates of the surface come in line with other events.
    void settle()
    {
        QVERIFY(session().settle());
        QCoreApplication::processEvents();
    }
    void lay() { apply(core::LaySurface{.segment = 1, .vertices = 800}); }
    void set(Mode mode, double radiusMm, SurfaceMark mark = SurfaceMark::Red)
    {
        refinement().setSettings({.mode = mode, .mark = mark, .radiusMm = radiusMm});
    }
    [[nodiscard]] std::size_t marked(SurfaceMark mark)
    {
        return refinement().mirror().markCounts()[std::size_t(mark)];
    }
    [[nodiscard]] const core::HistoryRow& lastRow()
    {
        return session().history().row(session().history().position());
    }
    [[nodiscard]] std::int64_t voxels() { return session().document().segment(1)->voxels; }

    /// While an edit stands open.
    void settleOpen()
    {
        QTRY_VERIFY_WITH_TIMEOUT(
            !refinement().isPreviewing() || apartFrom({15, 0, 0}) <= 1.5, 30000);
    }
    void markTheLeft()
    {
        apply(core::MarkSurface{.mark = SurfaceMark::Red,
            .path = {.radiusMm = 7.0, .pointsLps = {glm::dvec3(radius, 0.0, 0.0)}}});
    }
    /// How a lobe on the patient's left ought to run, on two slices that cross.
    void drawLobe()
    {
        set(Mode::Template, 5.0);
        const auto lobe = [](const glm::dvec3& side) {
            std::vector<glm::dvec3> line;
            for (int i = -8; i <= 8; ++i) {
                const double y = 0.75 * i;
                line.push_back(glm::dvec3(radius + 5.0 - 0.14 * y * y, 0.0, 0.0) + y * side);
            }
            return line;
        };
        const auto drawOn = [&](ui::SliceView& where, const glm::dvec3& side) {
            std::vector<QPointF> way;
            for (const glm::dvec3& place : lobe(side))
                way.push_back(at(where, place));
            test::Pen pen(where);
            quint64 time = 90000;
            pen.press(way.front(), 1.0, time);
            for (const QPointF& point : way)
                pen.move(point, 1.0, time += 12);
            pen.release(way.back(), time + 12);
        };
        drawOn(slice, {0.0, 1.0, 0.0});
        drawOn(window.views().coronal(), {0.0, 0.0, 1.0});
    }
    /// Of the nearest vertex as it is shown, mm.
    [[nodiscard]] double apartFrom(const glm::dvec3& placeLps)
    {
        const core::SurfaceMirror& mirror = refinement().mirror();
        return glm::distance(mirror.vertex(mirror.nearestVertex(placeLps)).positionLps, placeLps);
    }

    /// Where a place is in a view, logical pixels.
    template <class View> [[nodiscard]] static QPointF at(View& where, const glm::dvec3& lps)
    {
        return where.context().toPixel(lps);
    }

    ui::RefineTool tool;
    ui::RefinePanel panel;
    ui::SliceView& slice;
    ui::VolumeView& view;
};

/// A stroke through these places.
template <class View>
void draw(RefineFixture& fixture, View& view, const std::vector<QPointF>& way, bool lift = true)
{
    test::Pen pen(view);
    quint64 time = 70000;
    pen.press(way.front(), 1.0, time);
    for (const QPointF& point : way)
        pen.move(point, 1.0, time += 12);
    if (!lift)
        return;
    pen.release(way.back(), time + 12);
    fixture.settle();
}

QByteArray canonical(const core::Edit& edit)
{
    return QJsonDocument(core::editToJson(core::quantised(edit))).toJson(QJsonDocument::Compact);
}

} // namespace

/// The surface of a segment, repaired with the pen.
class RefineToolUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// What the option bar says of keys is of the mode, and whole as far as it is there.
    void keysAreThoseOfTheMode()
    {
        RefineFixture fixture;
        fixture.window.resize(1280, 720);
        fixture.workspace.setActiveTool(&fixture.tool);
        const auto* keys = fixture.window.findChild<ui::FittingLabel*>(QStringLiteral("toolKeys"));
        QVERIFY(keys);
        const QString separator = QStringLiteral(" · ");
        for (const Mode mode : {Mode::Mark, Mode::Sphere, Mode::Scrape, Mode::Drag, Mode::Template,
                 Mode::Attract, Mode::Smooth}) {
            fixture.set(mode, 6.0);
            QCoreApplication::processEvents();
            const bool sized = mode != Mode::Template;
            QCOMPARE(keys->text().contains(QStringLiteral("radius")), sized);
            QVERIFY(keys->text().contains(QStringLiteral("Esc")));
            QCOMPARE(keys->text().contains(QStringLiteral("Ctrl")),
                mode == Mode::Mark || mode == Mode::Sphere || mode == Mode::Scrape
                    || mode == Mode::Template);
            const QString shown = keys->shownText();
            qInfo("mode %d: %d pixels for %s: %s", int(mode), keys->width(),
                qUtf8Printable(keys->text()), qUtf8Printable(shown));
            QVERIFY2(shown.isEmpty() || shown == keys->text()
                    || keys->text().startsWith(shown + separator),
                qPrintable(shown));
        }
        // Where there is room for some of it, that is what is seen.
        ui::FittingLabel label(Qt::AlignLeft);
        label.setParts(separator);
        label.setText(QStringLiteral("[ ] radius · Ctrl unmarks · Esc cancels"));
        const auto advance = [&label](const char* text) {
            return label.fontMetrics().horizontalAdvance(QString::fromUtf8(text));
        };
        label.resize(advance("[ ] radius · Ctrl unmarks · Esc cancels") + 1, 20);
        QCOMPARE(label.shownText(), label.text());
        label.resize(advance("[ ] radius · Ctrl unmarks · Esc") + 1, 20);
        QCOMPARE(label.shownText(), QStringLiteral("[ ] radius · Ctrl unmarks"));
        label.resize(advance("[ ] radius"), 20);
        QCOMPARE(label.shownText(), QStringLiteral("[ ] radius"));
        label.resize(advance("[ ] radi"), 20);
        QCOMPARE(label.shownText(), QString());
    }

    /// Ctrl is promised only where it does something, and the words at the pointer tell what.
    void ctrlSaysWhatItDoes()
    {
        RefineFixture fixture;
        fixture.lay();
        fixture.workspace.setActiveTool(&fixture.tool);
        const auto targetOver = [&](ui::ImageView& view) {
            test::WindowFixture::hover(view, QPointF(view.rect().center()), Qt::ControlModifier);
            return fixture.tool.target();
        };
        const auto keysTell = [&fixture](const char* what) {
            return fixture.tool.keys().contains(QLatin1String(what));
        };
        fixture.set(Mode::Sphere, 6.0);
        for (ui::ImageView* view :
            std::initializer_list<ui::ImageView*>{&fixture.slice, &fixture.view})
            QCOMPARE(targetOver(*view), QStringLiteral("pushes Ball from the other side"));
        QVERIFY(keysTell("Ctrl pushes the other way"));
        fixture.set(Mode::Scrape, 6.0);
        QCOMPARE(targetOver(fixture.slice), QStringLiteral("fills Ball up to a plane"));
        QVERIFY(keysTell("Ctrl fills"));
        fixture.set(Mode::Smooth, 6.0);
        QCOMPARE(targetOver(fixture.slice), QStringLiteral("smooths Ball"));
        QVERIFY(!keysTell("Ctrl"));
    }

    void thePanelLaysAndWritesBack()
    {
        RefineFixture fixture;
        auto* lay = fixture.panel.findChild<QPushButton*>(QStringLiteral("laySurface"));
        fixture.panel.findChild<QSpinBox*>(QStringLiteral("surfaceVertices"))->setValue(1000);
        QVERIFY(lay->isEnabled());
        lay->click();
        fixture.settle();
        QVERIFY(fixture.session().document().surface);
        const std::size_t vertices = fixture.refinement().mirror().vertexCount();
        QVERIFY(vertices > 600 && vertices < 1600);
        QVERIFY(fixture.lastRow().name.startsWith(QStringLiteral("Surface of 'Ball', ")));
        auto* write = fixture.panel.findChild<QPushButton*>(QStringLiteral("writeBack"));
        const auto* state = fixture.panel.findChild<QLabel*>(QStringLiteral("surfaceState"));
        QVERIFY(!write->isEnabled());
        // By how much what it encloses is not what the segment holds.
        QVERIFY(state->text().startsWith(QStringLiteral("Surface of 'Ball', ")));
        QVERIFY2(state->text().endsWith(QStringLiteral("% off")), qPrintable(state->text()));

        fixture.set(Mode::Sphere, 6.0);
        const glm::dvec3 front(0.0, -radius, 0.0);
        draw(fixture, fixture.slice, {fixture.at(fixture.slice, front)});
        QVERIFY(write->isEnabled());
        QCOMPARE(fixture.panel.summary(), QStringLiteral("differs from the segment"));
        QVERIFY(state->text().contains(QStringLiteral("does not hold")));
        const std::int64_t before = fixture.voxels();
        write->click();
        fixture.settle();
        QVERIFY(fixture.voxels() != before);
        QVERIFY(
            fixture.lastRow().name.startsWith(QStringLiteral("Write surface back to 'Ball', ")));
        QVERIFY(!write->isEnabled());
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fixture.voxels(), before);
        QVERIFY(write->isEnabled());
        fixture.panel.findChild<QPushButton*>(QStringLiteral("dropSurface"))->click();
        fixture.settle();
        QVERIFY(fixture.refinement().mirror().empty());
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fixture.refinement().mirror().vertexCount(),
            fixture.session().surface().mesh()->vertexCount());
    }

    void theSphereIsAsLargeAsThePenIsPressed()
    {
        RefineFixture fixture;
        fixture.lay();
        fixture.set(Mode::Sphere, 6.0);
        auto* button = fixture.window.findChild<QToolButton*>(QStringLiteral("radiusByPressure"));
        QVERIFY(button);
        button->click();
        QVERIFY(fixture.refinement().settings().radiusByPressure);
        const QByteArray before = fixture.session().stateHash();
        const QPointF front = fixture.at(fixture.slice, {0.0, -radius, 0.0});
        const QPointF aside = fixture.at(fixture.slice, {2.0, -radius, 0.0});
        {
            test::Pen pen(fixture.slice);
            pen.press(front, 0.4, 70000);
            pen.move(aside, 0.7, 70012);
            pen.move(aside, 1.0, 70024); // it rests and is pressed harder
            pen.move(aside, 0.6, 70036); // less changes nothing
            pen.release(aside, 70048);
        }
        fixture.settle();
        const core::Edit pushed = fixture.lastRow().edit;
        const auto& path = pushed.get<core::SpherePush>().path;
        QVERIFY(path.pressures);
        QCOMPARE(path.pointsLps.size(), std::size_t(3));
        QCOMPARE(path.pressures->size(), std::size_t(3));
        QVERIFY(std::abs(path.pressures->front() - 0.4) < 1e-4);
        QCOMPARE(path.pressures->back(), 1.0);
        // As a recipe does it, to the bit; pressed fully it is another.
        const QByteArray after = fixture.session().stateHash();
        QVERIFY(after != before);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fixture.session().stateHash(), before);
        fixture.apply(pushed);
        QCOMPARE(fixture.session().stateHash(), after);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        core::SpherePush whole = pushed.get<core::SpherePush>();
        whole.path.pressures.reset();
        fixture.apply(whole);
        QVERIFY(fixture.session().stateHash() != after);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        // One that is not as long as the path is no path.
        whole.path.pressures = std::vector<double>{1.0};
        QVERIFY(!fixture.session().apply(whole));
    }

    void whatIsPaintedSinceIsTold()
    {
        RefineFixture fixture;
        fixture.apply(test::newSegment(QStringLiteral("Other"), 0x4080ff));
        fixture.lay();
        const auto differs = [&] { return fixture.session().document().surface->differs; };
        const auto painted = [](int segment, double x) {
            return test::paintAt(segment, {glm::dvec3(x, 0.0, 0.0)}, 3.0);
        };
        fixture.apply(painted(2, -16.0));
        QVERIFY(!differs());
        QVERIFY(fixture.refinement().caution().isEmpty());
        fixture.apply(painted(1, radius + 2.0));
        QVERIFY(differs());
        QCOMPARE(fixture.refinement().caution(), QStringLiteral("Ball differs from its surface"));
        QCOMPARE(fixture.panel.summary(), QStringLiteral("differs from the segment"));
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QVERIFY(!differs());
        QVERIFY(fixture.refinement().caution().isEmpty());
        // What it already holds is no change.
        fixture.apply(painted(1, 0.0));
        QVERIFY(!differs());
    }

    void theSurfaceBecomesABarrier()
    {
        RefineFixture fixture;
        QWidget host;
        ui::Actions actions(host);
        const QStringList names = ui::addRefineActions(actions, fixture.workspace);
        for (const char* id : {"refine.barrier", "refine.openBarrier"}) {
            QVERIFY(names.contains(QLatin1String(id)));
            actions.refresh();
            QVERIFY(!actions[QLatin1String(id)].isEnabled());
        }
        auto* barrierButton =
            fixture.panel.findChild<QPushButton*>(QStringLiteral("surfaceBarrier"));
        auto* open = fixture.panel.findChild<QPushButton*>(QStringLiteral("openSurfaceBarrier"));
        QVERIFY(!barrierButton->isVisibleTo(&fixture.panel));
        fixture.lay();
        QVERIFY(barrierButton->isVisibleTo(&fixture.panel) && barrierButton->isEnabled()
            && open->isEnabled());
        QVERIFY(!barrierButton->toolTip().isEmpty() && !open->toolTip().isEmpty());
        QVERIFY2(fixture.panel.minimumSizeHint().width() <= 280,
            qPrintable(QString::number(fixture.panel.minimumSizeHint().width())));
        fixture.apply(test::newSegment(QStringLiteral("Within"), 1));
        fixture.apply(test::seedAt(2, {glm::dvec3(0.0)}));
        const std::int64_t held = fixture.voxels();

        barrierButton->click();
        fixture.settle();
        QVERIFY(fixture.lastRow().edit.is<core::SurfaceBarrier>());
        QVERIFY(fixture.lastRow().name.startsWith(QStringLiteral("Barrier around surface, ")));
        QCOMPARE(fixture.voxels(), held);
        fixture.apply(test::growBy(
            {.lower = -3000, .upper = 3000, .connectivity = 26, .overwriteUnlocked = true}));
        const auto within = [&fixture] { return fixture.session().document().segment(2)->voxels; };
        const std::int64_t enclosed = within();
        QVERIFY(std::abs(double(enclosed - held)) < 0.01 * double(held)); // it was only laid

        actions.refresh();
        QVERIFY(actions[QStringLiteral("refine.barrier")].isEnabled());
        actions[QStringLiteral("refine.openBarrier")].trigger();
        fixture.settle();
        QCOMPARE(canonical(fixture.lastRow().edit), canonical(core::SurfaceBarrier{.erase = true}));
        fixture.apply(core::ResumeGrowth{});
        QVERIFY(within() > 2 * enclosed);
        // There is nothing left to open.
        const core::RowId row = fixture.lastRow().id;
        open->click();
        fixture.settle();
        QCOMPARE(fixture.lastRow().id, row);
    }

    void whatPassesThroughItselfIsLaidAnew()
    {
        RefineFixture fixture;
        QWidget host;
        ui::Actions actions(host);
        const auto id = QStringLiteral("refine.layCrossings");
        QVERIFY(ui::addRefineActions(actions, fixture.workspace).contains(id));
        actions.refresh();
        QVERIFY(!actions[id].isEnabled());
        fixture.lay();
        actions.refresh();
        QVERIFY(actions[id].isEnabled());
        const core::RowId laid = fixture.lastRow().id;
        actions[id].trigger();
        fixture.settle();
        QCOMPARE(fixture.lastRow().id, laid); // nothing crosses
        // By the rules of before a vertex may be drawn through the opposite wall.
        core::PointDrag through{.path = {.radiusMm = 4.0, .pointsLps = {}}};
        for (double x = radius - 1.0; x >= -radius - 12.0; x -= 2.0)
            through.path.pointsLps.push_back({x, 0.0, 0.0});
        fixture.apply(through);
        const core::VolumeGeometry geometry = test::smallHead::volume().volume.geometry;
        const auto crossings = [&] {
            return core::selfIntersections(*fixture.session().surface().mesh(), geometry).size();
        };
        QVERIFY2(crossings() > 0, qPrintable(fixture.lastRow().name));
        const core::RowId drawn = fixture.lastRow().id;
        fixture.refinement().writeBack();
        QVERIFY(!fixture.session().settle());
        QCOMPARE(fixture.lastRow().id, drawn);
        actions[id].trigger();
        fixture.settle();
        QCOMPARE(crossings(), std::size_t(0));
        QCOMPARE(canonical(fixture.lastRow().edit),
            canonical(core::LaySurface{.segment = 1, .onlyCrossings = true}));
        fixture.refinement().writeBack();
        fixture.settle();
        QVERIFY(fixture.lastRow().edit.is<core::WriteBack>());
        QVERIFY(fixture.refinement().caution().isEmpty());
    }

    /// What the surface was moved over is written where voxels may change; the panel says so.
    void writesBackWithinTheEditableRange()
    {
        RefineFixture fixture;
        fixture.panel.findChild<QSpinBox*>(QStringLiteral("surfaceVertices"))->setValue(1000);
        fixture.panel.findChild<QPushButton*>(QStringLiteral("laySurface"))->click();
        fixture.settle();
        fixture.set(Mode::Sphere, 6.0);
        draw(fixture, fixture.slice, {fixture.at(fixture.slice, {0.0, -radius, 0.0})});
        auto* write = fixture.panel.findChild<QPushButton*>(QStringLiteral("writeBack"));
        const auto* button = fixture.panel.findChild<ui::EditableButton*>();
        QVERIFY(write->isEnabled() && button && !button->isHidden());
        QVERIFY(button->toolTip().endsWith(QStringLiteral(": all voxels")));
        const core::RowId pushed = fixture.lastRow().id;
        const std::int64_t before = fixture.voxels();
        fixture.workspace.setEditableSettings(
            {.on = true, .byValue = true, .lower = 2000.0, .upper = 3000.0}); // none has these
        QVERIFY(button->toolTip().endsWith(QStringLiteral(": editable: only 2000 … 3000 HU")));
        write->click();
        fixture.settle();
        QCOMPARE(fixture.lastRow().id, pushed);
        QCOMPARE(fixture.voxels(), before);
        QVERIFY(write->isEnabled());
        fixture.workspace.setEditableSettings(
            {.on = true, .byValue = true, .lower = -1000.0, .upper = 3000.0}); // all
        write->click();
        fixture.settle();
        const auto* written = fixture.lastRow().edit.as<core::WriteBack>();
        QVERIFY(written && written->editable);
        QCOMPARE(written->editable->lower, std::optional(-1000.0));
        QVERIFY(fixture.voxels() != before);
        QVERIFY(write->isEnabled()); // a range, whatever it leaves out
        // It is switched off there, too.
        button->menu()->findChild<QCheckBox*>(QStringLiteral("editableOn"))->click();
        QVERIFY(!fixture.workspace.editableRange());
        QVERIFY(button->toolTip().endsWith(QStringLiteral(": all voxels")));
    }

    void marksOnASliceAreTheEditOfARecipe()
    {
        RefineFixture fixture;
        fixture.lay();
        fixture.set(Mode::Mark, 5.0);
        const glm::dvec3 from(radius, 0.0, 0.0);
        const glm::dvec3 to(radius * 0.8, radius * 0.6, 0.0);
        const std::vector<QPointF> way{
            fixture.at(fixture.slice, from), fixture.at(fixture.slice, to)};
        const ui::ViewContext context = fixture.slice.context();
        draw(fixture, fixture.slice, way);
        core::MarkSurface expected{.mark = SurfaceMark::Red,
            .path = {.radiusMm = 5.0, .pointsLps = {}, .rules = core::newestSurfaceRules}};
        expected.path.pointsLps = {context.toLps(way[0]), context.toLps(way[1])};
        QCOMPARE(canonical(fixture.lastRow().edit), canonical(expected));
        QVERIFY(fixture.marked(SurfaceMark::Red) > 5);
        QCOMPARE(fixture.refinement().errors().size(), std::size_t(1));
        const auto* errors = fixture.panel.findChild<QListWidget*>(QStringLiteral("surfaceErrors"));
        QCOMPARE(errors->count(), 1);
        // The next error is where it was painted.
        fixture.refinement().goToError(1);
        QVERIFY(glm::distance(fixture.workspace.crosshairLps(), glm::mix(from, to, 0.5)) < 5.0);
        fixture.refinement().changeMarks({.way = core::ChangeMarks::Way::Clear});
        fixture.settle();
        QCOMPARE(fixture.marked(SurfaceMark::Red), std::size_t(0));
        QCOMPARE(errors->count(), 0);
    }

    /// A stroke is a row; written back, the segment has what the surface encloses then.
    void mouseAndPenRepairTheSegment_data()
    {
        QTest::addColumn<bool>("drags");
        QTest::addColumn<bool>("inVolume");
        QTest::addColumn<test::DrawnBy>("by");
        for (const auto by : {test::DrawnBy::Mouse, test::DrawnBy::Pen}) {
            const char* name = by == test::DrawnBy::Mouse ? "mouse" : "pen";
            QTest::addRow("a sphere on a slice, %s", name) << false << false << by;
            QTest::addRow("a sphere in 3D, %s", name) << false << true << by;
            QTest::addRow("a drag on a slice, %s", name) << true << false << by;
        }
    }
    void mouseAndPenRepairTheSegment()
    {
        QFETCH(const bool, drags);
        QFETCH(const bool, inVolume);
        QFETCH(const test::DrawnBy, by);
        RefineFixture fixture;
        fixture.lay();
        fixture.set(drags ? Mode::Drag : Mode::Sphere, 6.0);
        const std::size_t rows = fixture.rows();
        ui::ImageView& where = inVolume ? static_cast<ui::ImageView&>(fixture.view) : fixture.slice;
        // Drawn out from the surface, or pushed in by a ball whose middle is outside of it; the 3D
        // view looks at the front.
        std::vector<glm::dvec3> places{{radius, 0.0, 0.0}, {radius + 4.0, 0.0, 0.0}};
        if (!drags)
            places = inVolume
                ? std::vector<glm::dvec3>{{0.0, -radius, 0.0}, {2.0, -radius, 0.0}}
                : std::vector<glm::dvec3>{{radius + 3.0, 0.0, 0.0}, {radius + 3.0, 2.0, 0.0}};
        std::vector<QPointF> way;
        for (const glm::dvec3& place : places)
            way.push_back(fixture.at(where, place));
        test::drawStroke(by, where, way);
        fixture.settle();
        QCOMPARE(fixture.rows(), rows + 1);
        const QString name = fixture.lastRow().name;
        QVERIFY2(name.startsWith(drags ? QStringLiteral("Drag point 6.0 mm")
                                       : QStringLiteral("Sphere push 6.0 mm")),
            qPrintable(name));
        const std::int64_t before = fixture.voxels();
        fixture.refinement().writeBack();
        fixture.settle();
        QCOMPARE(fixture.rows(), rows + 2);
        QVERIFY2(drags ? fixture.voxels() > before + 20 : fixture.voxels() < before - 20,
            qPrintable(QStringLiteral("%1 of %2").arg(fixture.voxels()).arg(before)));
        QVERIFY(test::isWhatARecipeComesTo(fixture.session()));
    }

    void controlAndTheEraserEndInvert_data() { test::addWhatInverts(); }
    void controlAndTheEraserEndInvert()
    {
        QFETCH(const test::DrawnBy, by);
        RefineFixture fixture;
        fixture.lay();
        // On what is seen in 3D a sphere pushes outwards.
        fixture.set(Mode::Sphere, 6.0);
        const std::int64_t before = fixture.voxels();
        test::drawStroke(by, fixture.view, {fixture.at(fixture.view, {0.0, -radius, 0.0})},
            test::invertingKeys(by));
        fixture.settle();
        QVERIFY(fixture.lastRow().edit.is<core::SpherePush>());
        fixture.refinement().writeBack();
        fixture.settle();
        QVERIFY2(fixture.voxels() > before + 20,
            qPrintable(QStringLiteral("%1 of %2").arg(fixture.voxels()).arg(before)));
        // Marks are taken off.
        fixture.markTheLeft();
        const std::size_t red = fixture.marked(SurfaceMark::Red);
        QVERIFY(red > 5);
        fixture.set(Mode::Mark, 6.0);
        test::drawStroke(by, fixture.slice,
            {fixture.at(fixture.slice, {radius + 3.0, 0.0, 0.0}),
                fixture.at(fixture.slice, {radius, 0.0, 0.0})},
            test::invertingKeys(by));
        fixture.settle();
        QVERIFY2(fixture.marked(SurfaceMark::Red) < red, qPrintable(fixture.lastRow().name));
        QVERIFY(test::isWhatARecipeComesTo(fixture.session()));
    }

    void errorsAreSignedOffOneByOne()
    {
        RefineFixture fixture;
        fixture.lay();
        fixture.markTheLeft();
        fixture.apply(core::MarkSurface{.mark = SurfaceMark::Red,
            .path = {.radiusMm = 4.0, .pointsLps = {glm::dvec3(-radius, 0.0, 0.0)}}});
        auto* errors = fixture.panel.findChild<QListWidget*>(QStringLiteral("surfaceErrors"));
        auto* signOff = fixture.panel.findChild<QPushButton*>(QStringLiteral("signOffError"));
        QCOMPARE(errors->count(), 2);
        QVERIFY(!signOff->isEnabled());
        const std::size_t larger = fixture.refinement().errors().front().vertices;
        const std::size_t smaller = fixture.refinement().errors().back().vertices;
        errors->setCurrentRow(0);
        QVERIFY(signOff->isEnabled());
        signOff->click();
        fixture.settle();
        QCOMPARE(errors->count(), 1);
        QCOMPARE(fixture.marked(SurfaceMark::Green), larger);
        QCOMPARE(fixture.marked(SurfaceMark::Red), smaller);
        QVERIFY(fixture.lastRow().name.startsWith(QStringLiteral("Sign off red region, ")));
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(errors->count(), 2);
    }

    void inTheThirdDimensionTheToolIsOnTheSurface()
    {
        RefineFixture fixture;
        fixture.lay();
        fixture.set(Mode::Sphere, 6.0);
        const QPointF middle = fixture.at(fixture.view, glm::dvec3(0.0));
        draw(fixture, fixture.view, {middle});
        const auto* push = fixture.lastRow().edit.as<core::SpherePush>();
        QVERIFY(push);
        // Half its radius outside of what is seen from the front.
        QVERIFY(std::abs(push->path.pointsLps.front().y + radius + 3.0) < 0.6);
        fixture.refinement().writeBack();
        fixture.settle();
        const std::int64_t dented = fixture.voxels();
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QVERIFY(dented < fixture.voxels());
        // Beside the surface there is nothing to push.
        const core::RowId before = fixture.session().history().position();
        draw(fixture, fixture.view, {fixture.at(fixture.view, glm::dvec3(18.0, 0.0, 0.0))});
        QCOMPARE(fixture.session().history().position(), before);
    }

    /// A small sphere half the whole radius out would touch nothing.
    void inTheThirdDimensionALightPenPushes()
    {
        RefineFixture fixture;
        fixture.lay();
        fixture.refinement().setSettings(
            {.mode = Mode::Sphere, .radiusMm = 6.0, .radiusByPressure = true});
        const QByteArray before = fixture.session().stateHash();
        const QPointF middle = fixture.at(fixture.view, glm::dvec3(0.0));
        const QPointF aside = fixture.at(fixture.view, glm::dvec3(2.0, 0.0, 0.0));
        {
            test::Pen pen(fixture.view);
            pen.press(middle, 0.3, 70000);
            pen.move(aside, 0.6, 70012);
            pen.release(aside, 70024);
        }
        fixture.settle();
        const core::Edit pushed = fixture.lastRow().edit;
        QVERIFY(pushed.is<core::SpherePush>());
        const core::SurfacePath& path = pushed.get<core::SpherePush>().path;
        QVERIFY(path.pressures && path.pressures->size() == 2 && path.pointsLps.size() == 2);
        QVERIFY(std::abs(path.pressures->front() - 0.3) < 1e-3);
        QVERIFY(std::abs(path.pressures->back() - 0.6) < 1e-3);
        // Half of what the radius is at that pressure, as far as the surface is a ball: 0.9 mm at
        // the front, and 1.8 mm along the normal 2 mm beside it.
        const auto outside = [](const glm::dvec3& place) { return glm::length(place) - radius; };
        QVERIFY2(std::abs(outside(path.pointsLps[0]) - 0.9) < 0.6,
            qPrintable(QString::number(outside(path.pointsLps[0]))));
        QVERIFY2(std::abs(outside(path.pointsLps[1]) - 1.8) < 0.6,
            qPrintable(QString::number(outside(path.pointsLps[1]))));
        QVERIFY(fixture.session().stateHash() != before); // and the surface was met
    }

    void whatIsDraggedFollowsThePen()
    {
        RefineFixture fixture;
        fixture.lay();
        fixture.set(Mode::Drag, 6.0);
        const glm::dvec3 from(radius, 0.0, 0.0);
        const glm::dvec3 to(radius + 4.0, 0.0, 0.0);
        draw(fixture, fixture.slice,
            {fixture.at(fixture.slice, from), fixture.at(fixture.slice, to)});
        QCOMPARE(fixture.marked(SurfaceMark::Green), std::size_t(1));
        const core::SurfaceMirror& mirror = fixture.refinement().mirror();
        const core::VertexId near = mirror.nearestVertex(to);
        QVERIFY(glm::distance(mirror.vertex(near).positionLps, to) < 1.5);
    }

    void aStrokeIsTakenBack()
    {
        RefineFixture fixture;
        fixture.lay();
        const QByteArray before = fixture.session().stateHash();
        const core::SimplexMesh mesh = *fixture.session().surface().mesh();
        fixture.set(Mode::Sphere, 6.0);
        draw(fixture, fixture.slice,
            {fixture.at(fixture.slice, {0.0, -radius, 0.0}),
                fixture.at(fixture.slice, {3.0, -radius, 0.0})},
            false);
        QVERIFY(fixture.session().transactionOpen());
        QTest::keyClick(&fixture.slice, Qt::Key_Escape);
        fixture.settle();
        QVERIFY(!fixture.session().transactionOpen());
        QCOMPARE(fixture.session().stateHash(), before);
        QVERIFY(core::identical(*fixture.session().surface().mesh(), mesh));
        // What is shown is that, too.
        const core::SurfaceMirror& mirror = fixture.refinement().mirror();
        for (const core::VertexId id : mesh.vertexIds())
            QCOMPARE(mirror.vertex(id).positionLps, mesh.position(id));
    }

    void doubtsAreToldNotMarked()
    {
        RefineFixture fixture;
        fixture.lay();
        auto* look = fixture.panel.findChild<QPushButton*>(QStringLiteral("lookForDoubts"));
        auto* list = fixture.panel.findChild<QListWidget*>(QStringLiteral("surfaceDoubts"));
        const auto* state = fixture.panel.findChild<QLabel*>(QStringLiteral("doubtsFound"));
        const auto isToldNone = [&] { return state->text() == QStringLiteral("none"); };
        const auto found = [&] {
            fixture.session().poll();
            QCoreApplication::processEvents();
            return look->isEnabled();
        };
        // The ball lies in the brain, which is the same everywhere: its surface follows no edge,
        // but that is so everywhere.
        fixture.apply(core::MarkSurface{.mark = SurfaceMark::Green,
            .path = {.radiusMm = 6.0, .pointsLps = {glm::dvec3(radius, 0.0, 0.0)}}});
        QVERIFY(!isToldNone());
        look->click();
        QVERIFY(!look->isEnabled());
        QVERIFY(!isToldNone());
        QTRY_VERIFY(found());
        const int before = list->count();
        QCOMPARE(isToldNone(), before == 0);
        // The segment grows under what is green.
        fixture.apply(test::paintAt(1, {glm::dvec3(radius + 1.0, 0.0, 0.0)}, 7.0));
        const std::size_t green = fixture.marked(SurfaceMark::Green);
        fixture.panel.findChild<QPushButton*>(QStringLiteral("followMask"))->click();
        QTRY_VERIFY(found());
        fixture.settle();
        QVERIFY(list->count() > before);
        QVERIFY(list->item(0)->text().startsWith(QStringLiteral("Off the mask")));
        QCOMPARE(fixture.marked(SurfaceMark::Green), green);
        QCOMPARE(fixture.marked(SurfaceMark::Red), std::size_t(0));
        Q_EMIT list->itemClicked(list->item(0));
        QVERIFY(glm::distance(fixture.workspace.crosshairLps(), {radius, 0.0, 0.0}) < 5.0);
        fixture.refinement().drop();
        fixture.settle();
        QCOMPARE(list->count(), 0);
        QVERIFY(!isToldNone()); // nothing was looked at
        look->click();
        QVERIFY(!isToldNone());
    }

    void contoursOnTwoPlanesMakeATemplate()
    {
        RefineFixture fixture;
        fixture.lay();
        fixture.markTheLeft();
        const QByteArray before = fixture.session().stateHash();
        const core::RowId rowBefore = fixture.session().history().position();
        fixture.drawLobe();
        QCOMPARE(fixture.refinement().contours().size(), std::size_t(2));
        // Drawing changes nothing yet, and is no step.
        QCOMPARE(fixture.session().stateHash(), before);
        const std::vector<std::vector<glm::dvec3>> contours = fixture.refinement().contours();

        fixture.refinement().previewTemplate();
        QVERIFY(fixture.refinement().isPreviewing());
        fixture.settleOpen();
        const glm::dvec3 top(radius + 5.0, 0.0, 0.0);
        QVERIFY(fixture.refinement().isPreviewing());
        QVERIFY2(fixture.apartFrom(top) < 1.5, qPrintable(QString::number(fixture.apartFrom(top))));
        QCOMPARE(fixture.session().history().position(), rowBefore);

        fixture.refinement().dropPreview();
        fixture.settle();
        QCOMPARE(fixture.session().stateHash(), before);
        QVERIFY(fixture.apartFrom(top) > 3.0);
        QCOMPARE(fixture.refinement().contours().size(), std::size_t(2));

        fixture.refinement().previewTemplate();
        fixture.refinement().takeTemplate();
        fixture.settle();
        QVERIFY(fixture.refinement().contours().empty());
        QVERIFY(!fixture.refinement().isPreviewing());
        QVERIFY(fixture.apartFrom(top) < 1.5);
        const core::Edit taken = fixture.lastRow().edit;
        QCOMPARE(canonical(taken),
            canonical(
                core::ApplyTemplate{.contoursLps = contours, .rules = core::newestSurfaceRules}));
        // As a recipe does it at once, to the bit.
        const QByteArray after = fixture.session().stateHash();
        QVERIFY(after != before);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fixture.session().stateHash(), before);
        fixture.apply(taken);
        QCOMPARE(fixture.session().stateHash(), after);
    }

    void openAndClosedContoursArePreviewedTogether()
    {
        RefineFixture fixture;
        fixture.lay();
        fixture.markTheLeft();
        fixture.drawLobe();
        std::vector<glm::dvec3> ring;
        for (int i = 0; i <= 24; ++i) {
            const double turn = (i % 24) * M_PI / 12.0;
            ring.emplace_back(radius + 2.0, 4.63 * std::cos(turn), 4.63 * std::sin(turn));
        }
        fixture.refinement().addContour(ring);
        const QByteArray before = fixture.session().stateHash();
        fixture.refinement().previewTemplate();
        fixture.settleOpen();
        QVERIFY(fixture.refinement().isPreviewing());
        const glm::dvec3 top(radius + 5.0, 0.0, 0.0);
        QVERIFY2(fixture.apartFrom(top) < 1.5, qPrintable(QString::number(fixture.apartFrom(top))));
        fixture.refinement().dropPreview();
        fixture.settle();
        QCOMPARE(fixture.session().stateHash(), before);
    }

    void aPreviewGivesWay()
    {
        RefineFixture fixture;
        fixture.lay();
        fixture.markTheLeft();
        fixture.drawLobe();
        const QByteArray before = fixture.session().stateHash();
        // To Esc, and the contours stay.
        fixture.refinement().previewTemplate();
        QTest::keyClick(&fixture.slice, Qt::Key_Escape);
        fixture.settle();
        QVERIFY(!fixture.refinement().isPreviewing());
        QCOMPARE(fixture.session().stateHash(), before);
        QCOMPARE(fixture.refinement().contours().size(), std::size_t(2));
        // To any other edit.
        fixture.refinement().previewTemplate();
        QVERIFY(fixture.refinement().isPreviewing());
        fixture.refinement().changeMarks({.way = core::ChangeMarks::Way::Grow});
        fixture.settle();
        QVERIFY(!fixture.refinement().isPreviewing());
        QVERIFY(fixture.lastRow().edit.is<core::ChangeMarks>());
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fixture.session().stateHash(), before);
        // To undo.
        fixture.refinement().previewTemplate();
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QVERIFY(!fixture.refinement().isPreviewing());
        QCOMPARE(fixture.marked(SurfaceMark::Red), std::size_t(0));
        // To another contour.
        QVERIFY(fixture.session().redo());
        fixture.settle();
        fixture.refinement().previewTemplate();
        draw(fixture, fixture.slice,
            {fixture.at(fixture.slice, {radius, -4.0, 0.0}),
                fixture.at(fixture.slice, {radius, 4.0, 0.0})});
        QVERIFY(!fixture.refinement().isPreviewing());
        QCOMPARE(fixture.refinement().contours().size(), std::size_t(3));
        fixture.refinement().removeContour();
        QCOMPARE(fixture.refinement().contours().size(), std::size_t(2));
        QCOMPARE(fixture.session().stateHash(), before);
    }

    void aTemplateWithoutARedRegionIsRefusedOnce()
    {
        RefineFixture fixture;
        fixture.lay();
        fixture.drawLobe();
        const QByteArray before = fixture.session().stateHash();
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        fixture.refinement().previewTemplate();
        QTRY_VERIFY((fixture.session().poll(), failed.size() == 1));
        QVERIFY(failed.first()
                    .first()
                    .value<core::Error>()
                    .arguments.join(QLatin1Char(' '))
                    .contains(QStringLiteral("red region")));
        fixture.refinement().dropPreview();
        // The refusal was told of once, and waits for whoever settles.
        QVERIFY(!fixture.session().settle());
        QVERIFY(fixture.session().idle());
        QCOMPARE(failed.size(), 1);
        QVERIFY(!fixture.refinement().isPreviewing());
        QCOMPARE(fixture.session().stateHash(), before);
    }

    /// What was drawn stays, to be previewed once the region is marked.
    void aRefusedTemplateIsNotTaken()
    {
        RefineFixture fixture;
        fixture.lay();
        fixture.drawLobe();
        QCOMPARE(fixture.refinement().contours().size(), std::size_t(2));
        const auto* take = fixture.window.findChild<QToolButton*>(QStringLiteral("templateTake"));
        QVERIFY(take && !take->isEnabled());
        const std::size_t rows = fixture.rows();
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        fixture.refinement().previewTemplate();
        QVERIFY(take->isEnabled());
        QTRY_VERIFY((fixture.session().poll(), failed.size() == 1));
        QVERIFY(fixture.refinement().isPreviewing());
        QVERIFY(!take->isEnabled());
        fixture.refinement().takeTemplate();
        QVERIFY(!fixture.session().settle()); // it returns the refusal
        QVERIFY(fixture.session().idle());
        QCOMPARE(failed.size(), 1);
        QCOMPARE(fixture.rows(), rows);
        QVERIFY(!fixture.refinement().isPreviewing());
        QCOMPARE(fixture.refinement().contours().size(), std::size_t(2));
        // With a red region it is previewed and taken.
        fixture.markTheLeft();
        fixture.refinement().previewTemplate();
        fixture.settleOpen();
        QVERIFY(fixture.refinement().isPreviewing() && take->isEnabled());
        fixture.refinement().takeTemplate();
        fixture.settle();
        QVERIFY(fixture.lastRow().edit.is<core::ApplyTemplate>());
        QVERIFY(fixture.refinement().contours().empty());
    }

    void withoutASurfaceItSaysSo()
    {
        RefineFixture fixture;
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const core::RowId before = fixture.session().history().position();
        draw(fixture, fixture.slice, {fixture.at(fixture.slice, glm::dvec3(0.0))});
        QCOMPARE(fixture.session().history().position(), before);
        QVERIFY(!said.isEmpty());
        QVERIFY(said.last().first().toString().contains(QStringLiteral("panel Refine")));
    }
};

BURIN_WINDOW_TEST(RefineToolUiTest)

} // namespace refineToolUiTest

#include "RefineToolUiTest.moc"
