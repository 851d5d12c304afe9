// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/ThresholdDialog.h"

#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/growth/ProbedVoxel.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/base/NumberText.h"
#include "ui/widgets/HistogramRange.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTimer>
#include <QToolButton>
#include <QtTest>

#include <algorithm>
#include <memory>

namespace thresholdDialogUiTest {

namespace {

/// With the histogram that a study from files has, of bins of 10 HU: air, brain and bone.
core::LoadedVolume studyWithHistogram()
{
    core::LoadedVolume study = test::smallStudy();
    study.volume.histogram = {.minimum = -1000.0, .maximum = 1000.0, .counts = {}};
    study.volume.histogram.counts.assign(200, 0);
    for (const std::uint16_t code : study.codes) {
        const int bin = (int(code) - 1024 + 1000) / 10;
        ++study.volume.histogram.counts[std::size_t(std::min(bin, 199))];
    }
    return study;
}

std::int64_t voxelsOfValue(int value)
{
    const core::LoadedVolume study = test::smallStudy();
    return std::count(study.codes.begin(), study.codes.end(), std::uint16_t(value + 1024));
}

struct Fixture : test::WindowFixture {
    Fixture()
        : WindowFixture(studyWithHistogram())
    {
        // As the engine's thread wakes the window in the program.
        QObject::connect(&wakeUp, &QTimer::timeout, [this] {
            if (core::EditSession* open = workspace.session())
                open->poll();
        });
        wakeUp.start(10);
    }
    /// With a segment that has nothing yet, and one that has grown.
    void addSegments()
    {
        for (const core::Edit& edit : std::vector<core::Edit>{test::addSegment("Bone"),
                 test::addSegment("Brain"), test::seedInBrain(2), test::growBrain()})
            apply(edit);
        workspace.setActiveSegment(1);
    }
    [[nodiscard]] std::int64_t voxels(int label)
    {
        return session().document().segment(label)->voxels;
    }
    [[nodiscard]] const core::HistoryRow& lastRow() { return session().history().rows().back(); }
    /// The dialog after the menu Segments has opened it.
    [[nodiscard]] ui::ThresholdDialog& opened()
    {
        window.actionTable()[QStringLiteral("segments.threshold")].trigger();
        return *window.findChild<ui::ThresholdDialog*>();
    }
    /// Which label is held in the bone now, also of what is no step yet.
    [[nodiscard]] int labelInBone()
    {
        const glm::dvec3 index = workspace.volume()->geometry.toIndex(test::pointsInBone().front());
        const auto label = std::make_shared<int>(-1);
        session().questions().probe({glm::ivec3(glm::floor(index + 0.5))},
            [label](const core::Result<std::vector<core::ProbedVoxel>>& probes) {
                if (probes && !probes->empty())
                    *label = probes->front().label;
            });
        session().poll();
        return *label;
    }

    QTimer wakeUp;
};

ui::HistogramRange& rangeOf(const QWidget& dialog)
{
    return *dialog.findChild<ui::HistogramRange*>(QStringLiteral("thresholdInterval"));
}

QDoubleSpinBox& fieldOf(const QWidget& dialog, const char* name)
{
    return *dialog.findChild<QDoubleSpinBox*>(QLatin1String(name));
}

QToolButton& toolOf(const QWidget& dialog, const char* name)
{
    return *dialog.findChild<QToolButton*>(QLatin1String(name));
}

QCheckBox& checkOf(const QWidget& dialog, const char* name)
{
    return *dialog.findChild<QCheckBox*>(QLatin1String(name));
}

QPushButton& applyOf(const QWidget& dialog)
{
    return *dialog.findChild<QPushButton*>(QStringLiteral("applyThreshold"));
}

QComboBox& modeOf(const QWidget& dialog)
{
    return *dialog.findChild<QComboBox*>(QStringLiteral("thresholdMode"));
}

QString textOf(const QWidget& dialog, const char* name)
{
    return dialog.findChild<QLabel*>(QLatin1String(name))->text();
}

/// The entries of a button's menu as it is when it opens.
QList<QAction*> offeredBy(QToolButton& button)
{
    Q_EMIT button.menu()->aboutToShow();
    return button.menu()->actions();
}

void press(QPushButton& button)
{
    QTest::mouseClick(&button, Qt::LeftButton);
}

} // namespace

class ThresholdDialogUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Shown while it is chosen, a step when it is applied, and undone by one key.
    void bonesAtOneGo()
    {
        Fixture fixture;
        fixture.addSegments();
        const QAction& action = fixture.window.actionTable()[QStringLiteral("segments.threshold")];
        QCOMPARE(action.text(), QStringLiteral("Threshold for 'Bone' …"));
        ui::ThresholdDialog& dialog = fixture.opened();
        QVERIFY(dialog.isVisible() && !dialog.isModal());
        QVERIFY(dialog.windowType() == Qt::Tool); // the window's keys work in it, too
        QCOMPARE(textOf(dialog, "thresholdWhose"), QStringLiteral("Bone"));
        QCOMPARE(rangeOf(dialog).lower(), 226.0);
        QCOMPARE(rangeOf(dialog).upper(), 1000.0);
        const std::size_t rows = fixture.rows();
        QTRY_VERIFY(fixture.session().isOpen<core::ThresholdSegment>());
        QTRY_COMPARE(fixture.labelInBone(), 1);
        QCOMPARE(fixture.rows(), rows);
        // What is seen is counted, and told apart from what the segment has.
        const std::int64_t bone = voxelsOfValue(1000);
        const QString size =
            QStringLiteral("%1 voxels, %2")
                .arg(ui::countText(bone), ui::volumeText(double(bone) * 1.5 / 1000.0));
        QTRY_COMPARE(textOf(dialog, "thresholdNow"),
            QStringLiteral("Preview: %1\nNow: 0 voxels, 0.00 mL").arg(size));

        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        press(applyOf(dialog));
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 1);
        QCOMPARE(fixture.rows(), rows + 1);
        QCOMPARE(fixture.voxels(1), bone);
        QCOMPARE(fixture.lastRow().name,
            QStringLiteral("Threshold 'Bone' to 226 … 1000 HU, +%1 voxels")
                .arg(ui::countText(bone)));
        QCOMPARE(said.front().front().toString(),
            fixture.lastRow().name + QStringLiteral("; Ctrl+Z takes it back"));
        QTRY_COMPARE(textOf(dialog, "thresholdNow"), QStringLiteral("Now: %1").arg(size));
        QVERIFY(dialog.isVisible());
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QCOMPARE(fixture.voxels(1), std::int64_t(0));
    }

    /// Another interval is shown at once; without a preview, or when the dialog closes, all is as
    /// it was.
    void previewFollows()
    {
        Fixture fixture;
        fixture.addSegments();
        const std::size_t rows = fixture.rows();
        ui::ThresholdDialog& dialog = fixture.opened();
        QTRY_COMPARE(fixture.labelInBone(), 1);
        fieldOf(dialog, "rangeUpper").setValue(900.0);
        QTRY_COMPARE(fixture.labelInBone(), 0);
        QVERIFY(fixture.session().isOpen<core::ThresholdSegment>());
        fieldOf(dialog, "rangeUpper").setValue(1000.0);
        QTRY_COMPARE(fixture.labelInBone(), 1);
        checkOf(dialog, "thresholdPreview").setChecked(false);
        QVERIFY(!fixture.session().isOpen<core::ThresholdSegment>());
        QTRY_COMPARE(fixture.labelInBone(), 0);
        checkOf(dialog, "thresholdPreview").setChecked(true);
        QTRY_COMPARE(fixture.labelInBone(), 1);
        // A stroke takes it back, as everything does, and the next change shows it again.
        fixture.apply(test::paintAt(2, test::pointsInBone(), 1.5));
        QVERIFY(!fixture.session().isOpen<core::ThresholdSegment>());
        QCOMPARE(fixture.labelInBone(), 2);
        checkOf(dialog, "thresholdOverwrite").setChecked(true);
        QTRY_COMPARE(fixture.labelInBone(), 1);
        dialog.reject();
        QVERIFY(!fixture.session().isOpen<core::ThresholdSegment>());
        QTRY_COMPARE(fixture.labelInBone(), 2);
        QCOMPARE(fixture.rows(), rows + 1);
    }

    /// The count is that of the interval that is shown, never of one before.
    void theCountIsOfWhatIsShown()
    {
        Fixture fixture;
        fixture.addSegments();
        ui::ThresholdDialog& dialog = fixture.opened();
        const auto startsWith = [&dialog](const QString& text) {
            return textOf(dialog, "thresholdNow").startsWith(text);
        };
        const auto preview = [](std::int64_t voxels) {
            return QStringLiteral("Preview: %1 voxels, ").arg(ui::countText(voxels));
        };
        const std::int64_t bone = voxelsOfValue(1000);
        QTRY_VERIFY(startsWith(preview(bone)));
        // Above all values.
        fieldOf(dialog, "rangeUpper").setValue(900.0);
        QVERIFY(startsWith(QStringLiteral("Preview: counting")));
        QTRY_VERIFY(startsWith(preview(0)));
        fieldOf(dialog, "rangeUpper").setValue(1000.0);
        QTRY_VERIFY(startsWith(preview(bone)));
        checkOf(dialog, "thresholdPreview").setChecked(false);
        QCOMPARE(textOf(dialog, "thresholdNow"), QStringLiteral("Now: 0 voxels, 0.00 mL"));
        checkOf(dialog, "thresholdPreview").setChecked(true);
        QTRY_VERIFY(startsWith(preview(bone)));
        // A step takes the preview back, and its count goes with it.
        fixture.apply(test::paintAt(2, test::pointsInBone(), 1.5));
        QTRY_VERIFY(startsWith(QStringLiteral("Now: ")));
    }

    /// Every choice is in the edit.
    void choicesAreInTheEdit()
    {
        Fixture fixture;
        fixture.addSegments();
        fixture.workspace.setActiveSegment(2);
        core::ClipRegion clip = fixture.workspace.clip();
        ui::ThresholdDialog& dialog = fixture.opened();
        QVERIFY(!checkOf(dialog, "thresholdBoxed").isEnabled());
        clip.box.on = true;
        clip.box.minimum = {4.5, 5.5, 6.5};
        clip.box.maximum = {30.5, 29.5, 25.5};
        fixture.workspace.setClip(clip);
        QVERIFY(checkOf(dialog, "thresholdBoxed").isEnabled());
        for (const char* each : {"thresholdBoxed", "thresholdOnlyVisible", "thresholdOverwrite"})
            checkOf(dialog, each).setChecked(true);
        modeOf(dialog).setCurrentIndex(2);
        fieldOf(dialog, "rangeLower").setValue(10.0);
        fieldOf(dialog, "rangeUpper").setValue(100.0);
        const std::size_t rows = fixture.rows();
        press(applyOf(dialog));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), rows + 1);
        const auto& edit = fixture.lastRow().edit.get<core::ThresholdSegment>();
        QCOMPARE(edit.segment, 2);
        QVERIFY(edit.lower == 10.0 && edit.upper == 100.0);
        QVERIFY(edit.mode == core::ThresholdSegment::Mode::Subtract);
        QVERIFY(edit.onlyVisible && edit.overwriteUnlocked && edit.box);
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        QVERIFY(glm::distance(edit.box->fromLps, geometry.toWorld({5.0, 6.0, 7.0})) < 1e-2);
        QVERIFY(glm::distance(edit.box->toLps, geometry.toWorld({30.0, 29.0, 25.0})) < 1e-2);
        modeOf(dialog).setCurrentIndex(1);
        press(applyOf(dialog));
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.lastRow().edit.get<core::ThresholdSegment>().mode
            == core::ThresholdSegment::Mode::Add);
    }

    /// Otsu's parts, and what a CT usually shows.
    void suggestions()
    {
        Fixture fixture;
        fixture.addSegments();
        ui::ThresholdDialog& dialog = fixture.opened();
        const ui::HistogramRange& range = rangeOf(dialog);
        toolOf(dialog, "thresholdOtsu").click();
        // In the middle between air (−1000) and brain (40).
        QCOMPARE(range.lower(), -480.0);
        QCOMPARE(range.upper(), 1000.0);
        const QList<QAction*> three = offeredBy(toolOf(dialog, "thresholdThree"));
        QCOMPARE(three.size(), 3);
        three[0]->trigger();
        QCOMPARE(range.lower(), -1000.0);
        QCOMPARE(range.upper(), -481.0);
        three[1]->trigger();
        QCOMPARE(range.lower(), -480.0);
        QCOMPARE(range.upper(), 519.0);
        three[2]->trigger();
        QCOMPARE(range.lower(), 520.0);
        QCOMPARE(range.upper(), 1000.0);
        // There are but three different values.
        QCOMPARE(offeredBy(toolOf(dialog, "thresholdFour")).size(), 3);
        QVERIFY(toolOf(dialog, "thresholdTissues").isVisible());
        const QList<QAction*> tissues = offeredBy(toolOf(dialog, "thresholdTissues"));
        QCOMPARE(tissues.size(), 4);
        QVERIFY(tissues[1]->text().startsWith(QStringLiteral("Soft tissue")));
        tissues[1]->trigger();
        QCOMPARE(range.lower(), -160.0);
        QCOMPARE(range.upper(), 225.0);
        tissues[3]->trigger();
        QCOMPARE(range.lower(), -1000.0);
        QCOMPARE(range.upper(), -951.0);
        tissues[0]->trigger();
        QTRY_COMPARE(fixture.labelInBone(), 1); // a suggestion is shown, too
    }

    /// What is clicked on is in the interval.
    void picking()
    {
        Fixture fixture;
        fixture.addSegments();
        ui::ThresholdDialog& dialog = fixture.opened();
        const ui::HistogramRange& range = rangeOf(dialog);
        fixture.workspace.setCrosshairLps(test::pointsInBone().front());
        QVERIFY(fixture.session().settle());
        QCOMPARE(range.lower(), 226.0); // nothing is picked yet
        QToolButton& pick = toolOf(dialog, "thresholdPick");
        pick.click();
        QVERIFY(pick.isChecked() && !fixture.workspace.activeTool());
        fixture.workspace.setCrosshairLps(test::pointsInBrain().front());
        QTRY_COMPARE(range.upper(), 40.0);
        QCOMPARE(range.lower(), 40.0);
        fixture.workspace.setCrosshairLps(test::pointsInBone().front());
        QTRY_COMPARE(range.upper(), 1000.0);
        QCOMPARE(range.lower(), 40.0);
        pick.click();
        fixture.workspace.setCrosshairLps(
            fixture.workspace.volume()->geometry.toWorld({1.0, 1.0, 1.0}));
        QVERIFY(fixture.session().settle());
        QCOMPARE(range.lower(), 40.0);
        dialog.reject();
        QVERIFY(!pick.isChecked());
    }

    /// It is the first thing that one does: a segment is made for it.
    void withoutASegment()
    {
        Fixture fixture;
        QAction& action = fixture.window.actionTable()[QStringLiteral("segments.threshold")];
        QVERIFY(action.isEnabled());
        QVERIFY(!fixture.window.actionTable()[QStringLiteral("segments.fillHoles")].isEnabled());
        QCOMPARE(action.text(), QStringLiteral("Threshold …"));
        const ui::ThresholdDialog& dialog = fixture.opened();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().document().segments.size(), std::size_t(1));
        QTRY_COMPARE(textOf(dialog, "thresholdWhose"), QStringLiteral("Segment 1"));
        press(applyOf(dialog));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.voxels(1), voxelsOfValue(1000));
    }

    /// What cannot be changed says why; what has nothing to be done is told.
    void whatCannotBeSaysWhy()
    {
        Fixture fixture;
        fixture.addSegments();
        ui::ThresholdDialog& dialog = fixture.opened();
        QVERIFY(applyOf(dialog).isEnabled());
        fixture.apply(test::lockSegment(1));
        QVERIFY(!applyOf(dialog).isEnabled());
        QCOMPARE(applyOf(dialog).toolTip(), QStringLiteral("'Bone' is locked"));
        QVERIFY(!fixture.window.actionTable()[QStringLiteral("segments.threshold")].isEnabled());
        fixture.apply(test::lockSegment(1, false));
        QVERIFY(applyOf(dialog).isEnabled());
        fieldOf(dialog, "rangeLower").setValue(300.0);
        fieldOf(dialog, "rangeUpper").setValue(900.0);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const std::size_t rows = fixture.rows();
        press(applyOf(dialog));
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 1);
        QCOMPARE(said.front().front().toString(), QStringLiteral("'Bone' stays as it is"));
        QCOMPARE(fixture.rows(), rows);
        fixture.apply(core::RemoveSegment{.segment = 1});
        QVERIFY(!applyOf(dialog).isEnabled());
        QCOMPARE(applyOf(dialog).toolTip(), QStringLiteral("there is no segment"));
    }

    /// A segment that follows its interval comes with it; another one is a step in place of the
    /// first, until the segment is changed by hand.
    void aFollowedIntervalIsMoved()
    {
        Fixture fixture;
        fixture.addSegments();
        ui::ThresholdDialog& dialog = fixture.opened();
        const auto& follows = *dialog.findChild<QLabel*>(QStringLiteral("thresholdFollows"));
        QCOMPARE(follows.text(),
            QStringLiteral("This segment follows its interval: moving it works it out anew"));
        QVERIFY(!follows.isVisible());
        press(applyOf(dialog));
        QVERIFY(fixture.session().settle());
        QTRY_VERIFY(follows.isVisible());
        dialog.reject();

        // Another segment follows none, and is asked about with the same interval.
        fixture.workspace.setActiveSegment(2);
        QVERIFY(&fixture.opened() == &dialog);
        QVERIFY(!follows.isVisible());
        QCOMPARE(rangeOf(dialog).lower(), 226.0);
        fieldOf(dialog, "rangeLower").setValue(-400.0);
        modeOf(dialog).setCurrentIndex(1);
        checkOf(dialog, "thresholdOverwrite").setChecked(true);
        dialog.reject();

        fixture.workspace.setActiveSegment(1);
        QVERIFY(&fixture.opened() == &dialog);
        QVERIFY(follows.isVisible());
        QCOMPARE(rangeOf(dialog).lower(), 226.0);
        QCOMPARE(rangeOf(dialog).upper(), 1000.0);
        QCOMPARE(modeOf(dialog).currentIndex(), 0);
        QVERIFY(!checkOf(dialog, "thresholdOverwrite").isChecked());
        const std::size_t rows = fixture.rows();
        // No bone is of 900 HU and less: all of it goes, which is only shown yet.
        fieldOf(dialog, "rangeUpper").setValue(900.0);
        QTRY_COMPARE(fixture.labelInBone(), 0);
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(fixture.voxels(1), voxelsOfValue(1000));
        QVERIFY(follows.isVisible());
        press(applyOf(dialog));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), rows + 1);
        QCOMPARE(fixture.voxels(1), std::int64_t(0));
        QVERIFY(follows.isVisible());
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QCOMPARE(fixture.voxels(1), voxelsOfValue(1000));
        QVERIFY(&fixture.opened() == &dialog);
        QCOMPARE(rangeOf(dialog).upper(), 1000.0); // that which is in force now

        fixture.apply(test::eraseAt(1, test::pointsInBone(), 1.5));
        QTRY_VERIFY(!follows.isVisible());
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QTRY_VERIFY(follows.isVisible());
    }

    /// What was limited to a box is worked out anew in that box, wherever the clip box is now.
    void aFollowedIntervalKeepsItsBox()
    {
        Fixture fixture;
        fixture.addSegments();
        core::ClipRegion clip = fixture.workspace.clip();
        clip.box.on = true;
        clip.box.minimum = {4.5, 4.5, 4.5};
        clip.box.maximum = {20.5, 20.5, 20.5};
        fixture.workspace.setClip(clip);
        ui::ThresholdDialog& dialog = fixture.opened();
        checkOf(dialog, "thresholdBoxed").setChecked(true);
        press(applyOf(dialog));
        QVERIFY(fixture.session().settle());
        const auto first = fixture.lastRow().edit.get<core::ThresholdSegment>();
        QVERIFY(first.box && fixture.voxels(1) > 0 && fixture.voxels(1) < voxelsOfValue(1000));
        dialog.reject();
        checkOf(dialog, "thresholdBoxed").setChecked(false);
        clip.box.on = false;
        fixture.workspace.setClip(clip);

        QVERIFY(&fixture.opened() == &dialog);
        QVERIFY(checkOf(dialog, "thresholdBoxed").isChecked());
        fieldOf(dialog, "rangeLower").setValue(-1000.0);
        press(applyOf(dialog));
        QVERIFY(fixture.session().settle());
        const auto& moved = fixture.lastRow().edit.get<core::ThresholdSegment>();
        QVERIFY(moved.lower == -1000.0 && moved.box == first.box);
        QVERIFY(fixture.lastRow().statistics.followsInterval);
        // Switched off and on it is the clip box of now again: none.
        checkOf(dialog, "thresholdBoxed").setChecked(false);
        checkOf(dialog, "thresholdBoxed").setChecked(true);
        press(applyOf(dialog));
        QVERIFY(fixture.session().settle());
        QVERIFY(!fixture.lastRow().edit.get<core::ThresholdSegment>().box);
    }

    /// The interval may become that of all tools; the dialog gives way, and nothing is a step.
    void asTheEditableRange()
    {
        Fixture fixture;
        fixture.addSegments();
        const std::size_t rows = fixture.rows();
        ui::ThresholdDialog& dialog = fixture.opened();
        press(*dialog.findChild<QPushButton*>(QStringLiteral("thresholdAsRange")));
        QVERIFY(!dialog.isVisible());
        const ui::EditableSettings& settings = fixture.workspace.editableSettings();
        QVERIFY(settings.on && settings.byValue);
        QCOMPARE(settings.lower, 226.0);
        QCOMPARE(settings.upper, 1000.0);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(fixture.voxels(1), std::int64_t(0));
    }
};

BURIN_WINDOW_TEST(ThresholdDialogUiTest)

} // namespace thresholdDialogUiTest

#include "ThresholdDialogUiTest.moc"
