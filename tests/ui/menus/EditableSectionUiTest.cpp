// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/EditableSection.h"

#include "core/edits/EditJson.h"
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/parts/EditableRange.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/session/SessionDisplay.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/menus/EditableButton.h"
#include "ui/tools/growth/FloodFillTool.h"
#include "ui/tools/growth/PaintTool.h"
#include "ui/views/ViewGrid.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QJsonObject>
#include <QToolButton>
#include <QtTest>

#include <vector>

namespace editableSectionUiTest {

namespace {

using Where = ui::EditableSettings::Where;
using Labels = std::vector<std::uint8_t>;

/// The real window with the small head and a brush as large as its brain.
struct Fixture : test::WindowFixture {
    Fixture()
        : test::WindowFixture(test::smallHead::volume())
        , paint(workspace)
        , flood(workspace)
    {
        workspace.setBrushSettings(
            ui::Workspace::Brush::Paint, {.radiusMm = 10.0, .overwriteUnlocked = true});
        workspace.setActiveTool(&paint);
    }
    [[nodiscard]] Labels labels() { return *session().questions().labels(0); }
    [[nodiscard]] const core::Edit& lastEdit() { return session().history().rows().back().edit; }
    void dab()
    {
        ui::SliceView& slice = window.views().axial();
        const QPointF middle = QPointF(slice.width(), slice.height()) / 2.0;
        test::Pen pen(slice);
        pen.press(middle, 0.5, 70000);
        pen.release(middle, 70100);
        QVERIFY(session().settle());
    }
    template <class W> [[nodiscard]] W& its(const char* name)
    {
        return *window.findChild<W*>(QLatin1String(name));
    }
    void choose(const QString& place)
    {
        auto& where = its<QComboBox>("editableWhere");
        const int index = where.findText(place);
        QVERIFY2(index >= 0, qPrintable(place));
        where.setCurrentIndex(index);
        Q_EMIT where.activated(index);
    }

    ui::PaintTool paint;
    ui::FloodFillTool flood;
};

} // namespace

class EditableSectionUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void offUntilItIsSwitchedOn()
    {
        Fixture fixture;
        QVERIFY(!fixture.its<QCheckBox>("editableOn").isChecked());
        QVERIFY(!fixture.its<QCheckBox>("editableByValue").isEnabled());
        QVERIFY(!fixture.workspace.editableRange());
        QVERIFY(fixture.workspace.editableText().isEmpty());
        QVERIFY(fixture.its<QToolButton>("brushLimits")
                    .toolTip()
                    .endsWith(QStringLiteral(": over others")));
        fixture.dab();
        const core::Edit stroke = fixture.lastEdit();
        QVERIFY(stroke.is<core::PaintStroke>() && !*core::editableRangeOf(stroke));
        QVERIFY(!core::editToJson(fixture.lastEdit()).contains(QStringLiteral("editable")));
    }

    /// Where voxels may change is chosen in one go; that they may change anywhere switches nothing
    /// on.
    void aPlaceSwitchesItOn()
    {
        Fixture fixture;
        QVERIFY(fixture.its<QComboBox>("editableWhere").isEnabled());
        fixture.choose(QStringLiteral("anywhere"));
        QVERIFY(!fixture.workspace.editableSettings().on);
        fixture.choose(QStringLiteral("inside visible segments"));
        QVERIFY(fixture.workspace.editableSettings().on);
        QVERIFY(fixture.its<QCheckBox>("editableOn").isChecked());
        QVERIFY(fixture.its<QCheckBox>("editableByValue").isEnabled());
        QCOMPARE(fixture.its<QComboBox>("editableWhere").currentText(),
            QStringLiteral("inside visible segments"));

        // Switched off again it keeps the place, and anywhere leaves it on.
        fixture.its<QCheckBox>("editableOn").click();
        QVERIFY(!fixture.workspace.editableRange());
        QCOMPARE(fixture.workspace.editableSettings().where, Where::InsideVisible);
        fixture.its<QCheckBox>("editableOn").click();
        fixture.choose(QStringLiteral("anywhere"));
        QVERIFY(fixture.workspace.editableSettings().on);
    }

    /// Of what is under the brush only what the range allows; the row has it, and its recipe comes
    /// to the same.
    void paintingChangesOnlyWhatItAllows()
    {
        Fixture fixture;
        fixture.workspace.setGrowSettings({.lower = 0.0, .upper = 300.0});
        fixture.its<QCheckBox>("editableOn").click();
        QVERIFY(fixture.workspace.editableSettings().on);
        fixture.its<QCheckBox>("editableByValue").click();
        QCOMPARE(fixture.its<QDoubleSpinBox>("editableUpper").value(), 300.0); // the growth's
        fixture.its<QDoubleSpinBox>("editableLower").setValue(20.0);
        QCOMPARE(fixture.workspace.editableText(), QStringLiteral("editable: only 20 … 300 HU"));
        QVERIFY(fixture.its<QToolButton>("brushLimits")
                    .toolTip()
                    .contains(QStringLiteral("editable: only 20 … 300 HU")));
        fixture.dab();

        const core::Edit edit = fixture.lastEdit();
        QVERIFY(edit.is<core::PaintStroke>());
        const std::optional<core::EditableRange>& editable = *core::editableRangeOf(edit);
        QVERIFY(editable);
        QCOMPARE(*editable->lower, 20.0);
        QCOMPARE(*editable->upper, 300.0);
        QVERIFY(core::editToJson(edit).value(QStringLiteral("editable")).isObject());

        test::WorkspaceFixture freely;
        freely.apply(fixture.session().history().row(1).edit);
        core::Edit without = edit;
        core::editableRangeOf(without)->reset();
        freely.apply(without);
        const Labels all = *freely.session().questions().labels(0);
        const Labels found = fixture.labels();
        const core::LoadedVolume head = test::smallHead::volume();
        int painted = 0;
        int spared = 0;
        for (std::size_t voxel = 0; voxel < found.size(); ++voxel) {
            const double value = head.volume.encoding.value(head.codes[voxel]);
            const bool may = value >= 20.0 && value <= 300.0;
            QCOMPARE(int(found[voxel]), may ? int(all[voxel]) : 0);
            if (all[voxel] != 0)
                ++(may ? painted : spared);
        }
        QVERIFY(painted > 100 && spared > 100);

        test::WorkspaceFixture recipe;
        recipe.apply(fixture.session().history().row(1).edit);
        recipe.apply(*core::editFromJson(core::editToJson(edit)));
        QCOMPARE(recipe.session().stateHash(), fixture.session().stateHash());
    }

    /// Segments are resolved when the edit is made.
    void insideAndOutsideOfSegments()
    {
        Fixture fixture;
        fixture.apply(test::newSegment(QStringLiteral("One")));
        fixture.apply(test::newSegment(QStringLiteral("Two")));
        fixture.apply(test::paintAt(1, {{0.0, 0.0, 0.0}}, 4.0));
        fixture.workspace.setActiveSegment(2);
        fixture.its<QCheckBox>("editableOn").click();
        fixture.choose(QStringLiteral("inside One"));
        QVERIFY(fixture.workspace.editableRange()->inside == std::vector<int>{1});
        QCOMPARE(fixture.workspace.editableText(), QStringLiteral("editable: inside One"));
        const Labels before = fixture.labels();
        fixture.dab();
        const Labels after = fixture.labels();
        QVERIFY(after != before);
        for (std::size_t voxel = 0; voxel < after.size(); ++voxel)
            QVERIFY(before[voxel] == 1 ? after[voxel] != 0 : after[voxel] == before[voxel]);

        fixture.choose(QStringLiteral("outside Two"));
        QVERIFY(fixture.workspace.editableRange()->outside == std::vector<int>{2});
        QVERIFY(!fixture.workspace.editableRange()->inside);
        fixture.choose(QStringLiteral("inside visible segments"));
        QVERIFY(fixture.workspace.editableRange()->inside == (std::vector<int>{1, 2}));
        fixture.session().display().setSegmentVisible(1, false);
        QVERIFY(fixture.workspace.editableRange()->inside == std::vector<int>{2});
        fixture.choose(QStringLiteral("outside visible segments"));
        QVERIFY(fixture.workspace.editableRange()->outside == std::vector<int>{2});
        fixture.choose(QStringLiteral("inside One"));
        fixture.apply(core::RemoveSegment{.segment = 1});
        // Nothing is inside of what is gone.
        QVERIFY(fixture.workspace.editableRange()->inside == std::vector<int>());
    }

    void inTheClipBox()
    {
        Fixture fixture;
        fixture.its<QCheckBox>("editableOn").click();
        QVERIFY(!fixture.its<QCheckBox>("editableBoxed").isEnabled()); // there is none
        ui::EditableSettings settings = fixture.workspace.editableSettings();
        settings.boxed = true;
        fixture.workspace.setEditableSettings(settings);
        QVERIFY(!fixture.workspace.editableRange()->box);
        QCOMPARE(fixture.workspace.editableText(), QStringLiteral("editable: all voxels"));
        core::ClipRegion clip = fixture.workspace.clip();
        clip.box.on = true;
        clip.box.maximum.x = 20.5;
        fixture.workspace.setClip(clip);
        QVERIFY(fixture.its<QToolButton>("brushLimits")
                    .toolTip()
                    .contains(QStringLiteral("in the clip box")));
        fixture.dab();
        const Labels found = fixture.labels();
        std::size_t voxel = 0;
        int painted = 0;
        for (int z = 0; z < test::smallHead::side; ++z)
            for (int y = 0; y < test::smallHead::side; ++y)
                for (int x = 0; x < test::smallHead::side; ++x, ++voxel) {
                    QVERIFY(x <= 20 || found[voxel] == 0);
                    painted += found[voxel];
                }
        QVERIFY(painted > 100);
    }

    /// That all of them keep to it tells EditableEverywhereUiTest.
    void theBarOfAToolSaysIt()
    {
        Fixture fixture;
        fixture.workspace.setEditableSettings(
            {.on = true, .byValue = true, .lower = 20.0, .upper = 0.0});
        fixture.workspace.setActiveTool(&fixture.flood);
        auto* button = fixture.window.findChild<ui::EditableButton*>();
        QVERIFY(button);
        QVERIFY(button->toolTip().contains(QStringLiteral("editable: only 0 … 20 HU")));
        QVERIFY(fixture.window.minimumSizeHint().width() <= 1280);
        fixture.its<QCheckBox>("editableOn").click();
        QVERIFY(!fixture.workspace.editableRange());
        QVERIFY(button->toolTip().endsWith(QStringLiteral(": all voxels")));
    }

    void anotherStudyBeginsWithout()
    {
        Fixture fixture;
        QCOMPARE(fixture.engine.rangesExpected, 0);
        fixture.its<QCheckBox>("editableOn").click();
        QVERIFY(fixture.workspace.editableSettings().on);
        // The engine gets ready for it, once each time that it is switched on.
        QCOMPARE(fixture.engine.rangesExpected, 1);
        ui::EditableSettings byValue = fixture.workspace.editableSettings();
        byValue.byValue = true;
        fixture.workspace.setEditableSettings(byValue);
        QCOMPARE(fixture.engine.rangesExpected, 1);
        fixture.workspace.setSession(nullptr);
        QVERIFY(!fixture.workspace.editableSettings().on);
        QVERIFY(fixture.workspace.editableText().isEmpty());
    }
};

BURIN_WINDOW_TEST(EditableSectionUiTest)

} // namespace editableSectionUiTest

#include "EditableSectionUiTest.moc"
