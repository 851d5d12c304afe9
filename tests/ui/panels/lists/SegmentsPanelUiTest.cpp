// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/lists/SegmentDelegate.h"
#include "ui/panels/lists/SegmentsPanel.h"
#include "ui/workspace/LayerActions.h"

#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/layers/SegmentToLayer.h"
#include "core/edits/kinds/segments/MoveSegment.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/models/SegmentListModel.h"
#include "ui/views/ViewGrid.h"

#include <QApplication>
#include <QListView>
#include <QMenu>
#include <QSignalSpy>
#include <QTimer>
#include <QtTest>

#include <algorithm>
#include <array>

namespace segmentsPanelUiTest {

namespace {

struct Fixture : test::WindowFixture {
    Fixture()
        : WindowFixture(test::smallStudy())
    {
        window.addPanel(new ui::SegmentsPanel(workspace));
        window.showPanels(true);
        window.activateWindow();
        if (!QTest::qWaitForWindowActive(&window))
            qFatal("the window does not become active");
        list = window.findChild<QListView*>(QStringLiteral("segmentList"));
        for (const core::Edit& edit :
            std::vector<core::Edit>{test::addSegment("Brain"), test::addSegment("Bone"),
                test::addSegment("Skin"), test::seedInBrain(1), test::growBrain()})
            apply(edit);
        workspace.setActiveSegment(1);
    }
    [[nodiscard]] QStringList listed() const
    {
        QStringList names;
        for (int row = 0; row < list->model()->rowCount(); ++row)
            names += list->model()->index(row, 0).data().toString();
        return names;
    }
    void pressDelete(QWidget* where)
    {
        where->setFocus();
        QTRY_VERIFY(where->hasFocus());
        QTest::keyClick(where, Qt::Key_Delete);
        QVERIFY(session().settle());
    }

    QListView* list = nullptr;
};

/// That it fits a screen of 720 pixels.
constexpr int mostMenuHeight = 700;

QString spaced(std::int64_t count)
{
    QString digits = QString::number(count);
    for (qsizetype place = digits.size() - 3; place > 0; place -= 3)
        digits.insert(place, QLatin1Char(' '));
    return digits;
}

} // namespace

class SegmentsPanelUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void deleteTakesTheSegmentAndSaysSo()
    {
        Fixture fixture;
        const std::int64_t voxels = fixture.session().document().segment(1)->voxels;
        QVERIFY(voxels > 1000);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.pressDelete(fixture.list);
        QCOMPARE(fixture.listed(), (QStringList{QStringLiteral("Bone"), QStringLiteral("Skin")}));
        QCOMPARE(said.size(), 1);
        QCOMPARE(said.front().front().toString(),
            QStringLiteral("Deleted 'Brain', %1 voxels; Ctrl+Z brings it back")
                .arg(spaced(voxels)));
        QCOMPARE(fixture.workspace.activeSegment(), 2); // the one below
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.listed().front(), QStringLiteral("Brain"));
        QCOMPARE(fixture.session().document().segment(1)->voxels, voxels);
    }

    /// Rows that go, come back or move leave the active segment alone: the next stroke is for it.
    void theActiveOneStays()
    {
        Fixture fixture;
        const auto is = [&fixture](int label) {
            return fixture.workspace.activeSegment() == label
                && fixture.list->currentIndex().data(ui::SegmentListModel::LabelRole).toInt()
                == label;
        };
        fixture.workspace.setActiveSegment(3);
        QSignalSpy changed(&fixture.workspace, &ui::Workspace::activeSegmentChanged);
        fixture.apply(core::RemoveSegment{.segment = 2});
        QVERIFY(is(3));
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QVERIFY(is(3));
        QCOMPARE(fixture.listed().at(1), QStringLiteral("Bone"));
        for (const int place : {1, 2, 3}) {
            fixture.apply(core::MoveSegment{.segment = 3, .place = place});
            QVERIFY(is(3));
            QCOMPARE(fixture.listed().indexOf(QStringLiteral("Skin")), place - 1);
        }
        fixture.apply(core::MoveSegment{.segment = 1, .place = 3});
        QVERIFY(is(3));
        QCOMPARE(fixture.listed(),
            (QStringList{QStringLiteral("Bone"), QStringLiteral("Skin"), QStringLiteral("Brain")}));
        QCOMPARE(changed.size(), 0);
    }

    /// Its entries are about a segment of the session in which it was opened.
    void theMenuClosesWithItsSession()
    {
        Fixture fixture;
        bool wasOpen = false;
        bool isOpen = true;
        QTimer::singleShot(0, &fixture.window, [&] {
            wasOpen = QApplication::activePopupWidget() != nullptr;
            fixture.workspace.setSession(nullptr);
            isOpen = QApplication::activePopupWidget() != nullptr;
            if (isOpen)
                QApplication::activePopupWidget()->close();
        });
        const QRect row = fixture.list->visualRect(fixture.list->model()->index(0, 0));
        Q_EMIT fixture.list->customContextMenuRequested(row.center());
        QVERIFY(wasOpen);
        QVERIFY(!isOpen);
    }

    void theLastLeavesTheOneAbove()
    {
        Fixture fixture;
        fixture.workspace.setActiveSegment(3);
        fixture.pressDelete(fixture.list);
        QCOMPARE(fixture.workspace.activeSegment(), 2);
        fixture.pressDelete(fixture.list);
        QCOMPARE(fixture.workspace.activeSegment(), 1);
        fixture.pressDelete(fixture.list);
        QCOMPARE(fixture.workspace.activeSegment(), 0);
        QVERIFY(fixture.session().document().segments.empty());
    }

    void theKeyDeletesInTheListOnly()
    {
        Fixture fixture;
        const std::size_t rows = fixture.session().history().rows().size();
        fixture.pressDelete(&fixture.window.views().volume());
        QCOMPARE(fixture.session().history().rows().size(), rows);
        // From the menu it works anywhere.
        QAction& action = fixture.window.actionTable()[QStringLiteral("segments.remove")];
        QCOMPARE(action.text(), QStringLiteral("Delete segment 'Brain'"));
        action.trigger();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().rows().size(), rows + 1);
    }

    void aLockedOneStays()
    {
        Fixture fixture;
        fixture.apply(test::lockSegment(1));
        QVERIFY(!fixture.window.actionTable()[QStringLiteral("segments.remove")].isEnabled());
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        const std::size_t rows = fixture.session().history().rows().size();
        fixture.pressDelete(fixture.list);
        QCOMPARE(fixture.session().history().rows().size(), rows);
        QCOMPARE(failed.size(), 1);
    }

    void inversionIsOneStep()
    {
        Fixture fixture;
        const std::int64_t voxels = fixture.session().document().segment(1)->voxels;
        const glm::ivec3 size = fixture.session().document().volumes.front().geometry.size;
        QAction& action = fixture.window.actionTable()[QStringLiteral("segments.invert")];
        QCOMPARE(action.text(), QStringLiteral("Invert segment 'Brain'"));
        QVERIFY(fixture.window.segmentsMenu().actions().contains(&action));
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const std::size_t rows = fixture.session().history().rows().size();
        action.trigger();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().rows().size(), rows + 1);
        QCOMPARE(fixture.session().document().segment(1)->voxels,
            std::int64_t(size.x) * size.y * size.z - voxels);
        QCOMPARE(said.size(), 1);
        QCOMPARE(said.front().front().toString(),
            QStringLiteral("Inverted 'Brain'; Ctrl+Z takes it back"));
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().document().segment(1)->voxels, voxels);
        fixture.apply(test::lockSegment(1));
        QVERIFY(!action.isEnabled());
    }

    /// Mirrored twice about the same plane, all is where it was, but for what lay beside the
    /// images.
    void mirroringIsOneStep()
    {
        Fixture fixture;
        const auto before = fixture.session().questions().labels(0);
        QVERIFY(before);
        QAction& action = fixture.window.actionTable()[QStringLiteral("segments.mirror")];
        QCOMPARE(action.text(), QStringLiteral("Mirror 'Brain' left and right"));
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const std::size_t rows = fixture.session().history().rows().size();
        action.trigger();
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 1);
        const bool changed = fixture.session().history().rows().size() == rows + 1;
        QCOMPARE(
            said.front().front().toString().startsWith(QStringLiteral("Mirror 'Brain'")), changed);
        const auto after = fixture.session().questions().labels(0);
        QVERIFY(after);
        const glm::ivec3 size = fixture.session().document().volumes.front().geometry.size;
        for (std::size_t voxel = 0; voxel < after->size(); ++voxel) {
            const std::size_t x = voxel % std::size_t(size.x);
            const std::size_t image = voxel - x + (std::size_t(size.x) - 1 - x);
            if ((*before)[voxel] == 0 || (*before)[voxel] == 1)
                QCOMPARE(int((*after)[voxel]), (*before)[image] == 1 ? 1 : 0);
        }
        fixture.workspace.setCrosshairLps(
            fixture.workspace.volume()->geometry.toWorld({12.0, 10.0, 10.0}));
        fixture.window.actionTable()[QStringLiteral("segments.mirrorAtCrosshair")].trigger();
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.session().history().rows().back().edit.is<core::MirrorSegment>());
        QVERIFY(fixture.session().history().rows().back().edit.get<core::MirrorSegment>().placeLps);
    }

    /// All of them stand together in both menus, and each is a step of its own direction.
    void mirroringHasThreeDirections()
    {
        Fixture fixture;
        const auto submenus = fixture.window.segmentsMenu().actions();
        const auto mirror = std::find_if(submenus.begin(), submenus.end(),
            [](const QAction* each) { return each->text() == QStringLiteral("Mirror"); });
        QVERIFY(mirror != submenus.end() && (*mirror)->menu());
        QCOMPARE((*mirror)->menu()->actions().size(), 7);
        const glm::ivec3 size = fixture.session().document().volumes.front().geometry.size;
        fixture.workspace.setCrosshairLps(
            fixture.workspace.volume()->geometry.toWorld({10.0, 11.0, 9.0}));
        const glm::ivec3 crosshair(10, 11, 9);
        const std::size_t rowsAtFirst = fixture.session().history().rows().size();
        const std::array<const char*, 3> ids{
            "segments.mirror", "segments.mirrorFrontBack", "segments.mirrorHeadFeet"};
        for (int axis = 0; axis < 3; ++axis) {
            for (const bool atCrosshair : {false, true}) {
                const auto before = fixture.session().questions().labels(0);
                QVERIFY(before);
                QAction& action = fixture.window.actionTable()[QLatin1String(ids[std::size_t(axis)])
                    + (atCrosshair ? QStringLiteral("AtCrosshair") : QString())];
                QVERIFY((*mirror)->menu()->actions().contains(&action));
                const std::size_t rows = fixture.session().history().rows().size();
                QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
                action.trigger();
                QVERIFY(fixture.session().settle());
                QTRY_COMPARE(said.size(), 1);
                const auto after = fixture.session().questions().labels(0);
                QVERIFY(after);
                const int sum = atCrosshair ? 2 * crosshair[axis] : size[axis] - 1;
                for (std::size_t voxel = 0; voxel < after->size(); ++voxel) {
                    if ((*before)[voxel] > 1)
                        continue; // another segment keeps it
                    const int at = int(voxel);
                    glm::ivec3 image(at % size.x, at / size.x % size.y, at / (size.x * size.y));
                    image[axis] = sum - image[axis];
                    const bool isBrain = image[axis] >= 0 && image[axis] < size[axis]
                        && (*before)[std::size_t(image.x + size.x * (image.y + size.y * image.z))]
                            == 1;
                    QCOMPARE(int((*after)[voxel]), isBrain ? 1 : 0);
                }
                if (fixture.session().history().rows().size() == rows)
                    continue; // it is its own mirror image
                const auto edit =
                    fixture.session().history().rows().back().edit.get<core::MirrorSegment>();
                QCOMPARE(int(edit.sides), axis);
                QCOMPARE(edit.placeLps.has_value(), atCrosshair);
                QVERIFY(fixture.session().undo() && fixture.session().settle());
                QVERIFY(*fixture.session().questions().labels(0) == *before);
            }
        }
        // At the crosshair each of them moves the brain.
        QVERIFY(fixture.session().history().rows().size() >= rowsAtFirst + 3);
        fixture.apply(test::lockSegment(1));
        for (const QAction* each : (*mirror)->menu()->actions())
            QVERIFY(!each->isEnabled());
    }

    /// What is cleaned is one step; where there is nothing to clean, that is told.
    void cleaningSaysWhatItDid()
    {
        Fixture fixture;
        QAction& action = fixture.window.actionTable()[QStringLiteral("segments.keepLargest")];
        QCOMPARE(action.text(), QStringLiteral("Keep largest island of 'Brain'"));
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const std::int64_t voxels = fixture.session().document().segment(1)->voxels;
        fixture.apply(test::paintAt(1, {glm::dvec3(-18.0, -16.0, 106.0)}, 1.2));
        QVERIFY(fixture.session().document().segment(1)->voxels > voxels);
        const std::size_t rows = fixture.session().history().rows().size();
        action.trigger();
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 1);
        QCOMPARE(fixture.session().history().rows().size(), rows + 1);
        QCOMPARE(fixture.session().document().segment(1)->voxels, voxels);
        QVERIFY(said.front().front().toString().startsWith(
            QStringLiteral("Keep the largest island of 'Brain'")));
        action.trigger();
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 2);
        QCOMPARE(fixture.session().history().rows().size(), rows + 1);
        QCOMPARE(said.back().front().toString(), QStringLiteral("'Brain' is one island already"));
    }

    /// The menu of a row has what the menu Segments has, and keeps its hands off what is locked.
    void aRowsMenuInverts_data()
    {
        QTest::addColumn<bool>("locked");
        QTest::newRow("free") << false;
        QTest::newRow("locked") << true;
    }
    void aRowsMenuInverts()
    {
        QFETCH(bool, locked);
        Fixture fixture;
        if (locked)
            fixture.apply(test::lockSegment(2));
        const std::size_t rows = fixture.session().history().rows().size();
        const QPoint at = fixture.list->visualRect(fixture.list->model()->index(1, 0)).center();
        QString seen;
        QTimer::singleShot(0, &fixture.window, [&] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu);
            test::look(menu->grab(), locked ? "segment-menu-locked.png" : "segment-menu.png");
            QVERIFY2(menu->height() <= mostMenuHeight,
                qPrintable(QString::number(menu->height()))); // else it scrolls
            for (QAction* each : menu->actions()) {
                if (each->text() != QStringLiteral("Invert segment"))
                    continue;
                seen = each->isEnabled() ? QStringLiteral("possible") : QStringLiteral("not");
                each->trigger();
            }
            menu->close();
        });
        Q_EMIT fixture.list->customContextMenuRequested(at);
        QCOMPARE(seen, locked ? QStringLiteral("not") : QStringLiteral("possible"));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().rows().size(), rows + (locked ? 0 : 1));
        if (!locked)
            QVERIFY(fixture.session().history().rows().back().name.startsWith(
                QStringLiteral("Invert segment 'Bone', +")));
    }

    /// What passes between a segment and sculpting stands in a menu within its menu.
    void aRowsMenuCarves()
    {
        Fixture fixture;
        const QPoint at = fixture.list->visualRect(fixture.list->model()->index(0, 0)).center();
        QStringList entries;
        QTimer::singleShot(0, &fixture.window, [&] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu);
            for (const QAction* sub : menu->actions()) {
                if (!sub->menu() || sub->text() != QStringLiteral("Sculpt"))
                    continue;
                for (QAction* each : sub->menu()->actions()) {
                    entries += each->text();
                    if (each->text().startsWith(QStringLiteral("Carve it")))
                        each->trigger();
                }
            }
            menu->close();
        });
        Q_EMIT fixture.list->customContextMenuRequested(at);
        QCOMPARE(entries,
            (QStringList{QStringLiteral("Add what I see in 3D"),
                QStringLiteral("Add what 'Sculpt 1' has carved"),
                QStringLiteral("Carve it into layer 'Sculpt 1'"),
                QStringLiteral("Carve all but it into layer 'Sculpt 1'")}));
        QVERIFY(fixture.session().settle());
        const auto* edit =
            fixture.session().history().rows().back().edit.as<core::SegmentToLayer>();
        QVERIFY(edit);
        QCOMPARE(edit->segment, 1);
        QVERIFY(!edit->outside);
    }

    /// The shield of a row: one click, one step; tools say whom they spare.
    void aShieldKeepsToolsOff()
    {
        Fixture fixture;
        QCOMPARE(
            ui::carvingTarget(fixture.workspace, false), QStringLiteral("carves layer Sculpt 1"));
        const QModelIndex bone = fixture.list->model()->index(1, 0);
        const auto click = [&] {
            const QRect row = fixture.list->visualRect(bone);
            const QPoint at = ui::SegmentDelegate::shieldRect(row).center();
            QTest::mouseClick(fixture.list->viewport(), Qt::LeftButton, {}, at);
            QVERIFY(fixture.session().settle());
        };
        click();
        QVERIFY(fixture.session().document().segment(2)->uncarvable);
        QVERIFY(!fixture.session().document().segment(2)->locked);
        QCOMPARE(fixture.session().history().rows().back().name,
            QStringLiteral("Protect segment 'Bone' from sculpting"));
        QCOMPARE(ui::carvingTarget(fixture.workspace, false),
            QStringLiteral("carves layer Sculpt 1, not Bone"));
        QCOMPARE(
            ui::carvingTarget(fixture.workspace, true), QStringLiteral("restores layer Sculpt 1"));
        click();
        QVERIFY(!fixture.session().document().segment(2)->uncarvable);
    }

    /// A segment that follows an interval has a mark, which asks for another one. The first change
    /// by hand takes it away and is told once; undo brings it back.
    void aMarkWhereAnIntervalIsFollowed()
    {
        Fixture fixture;
        QObject::disconnect(
            &fixture.workspace, &ui::Workspace::thresholdAsked, &fixture.window, nullptr);
        QSignalSpy asked(&fixture.workspace, &ui::Workspace::thresholdAsked);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const QModelIndex bone = fixture.list->model()->index(1, 0);
        const auto clickMark = [&] {
            const QRect row = fixture.list->visualRect(bone);
            const QPoint at = ui::SegmentDelegate::intervalRect(row).center();
            QTest::mouseClick(fixture.list->viewport(), Qt::LeftButton, {}, at);
        };
        const auto mark = [&] { return bone.data(ui::SegmentListModel::FollowsRole).toString(); };
        QCOMPARE(mark(), QString());
        fixture.apply(core::ThresholdSegment{.segment = 2, .lower = 226.0, .upper = 1000.0});
        QCOMPARE(mark(), QStringLiteral("follows 226 … 1000 HU"));
        clickMark();
        QCOMPARE(asked.size(), 1);
        QCOMPARE(asked.front().front().toInt(), 2);
        test::look(fixture.list->grab(), "segment-follows.png");

        fixture.apply(test::paintAt(1, test::pointsInBrain()));
        QCoreApplication::processEvents();
        QCOMPARE(said.size(), 0); // it is still as its interval gave it
        fixture.apply(test::eraseAt(2, test::pointsInBone(), 1.5));
        QTRY_COMPARE(said.size(), 1);
        QCOMPARE(said.front().front().toString(),
            QStringLiteral("'Bone' no longer follows its interval: it was changed by hand; Ctrl+Z "
                           "takes it back"));
        QCOMPARE(mark(), QString());
        fixture.apply(test::eraseAt(2, test::pointsInBone(), 2.5));
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QCOMPARE(mark(), QStringLiteral("follows 226 … 1000 HU"));
        QVERIFY(fixture.session().redo() && fixture.session().settle());
        QCOMPARE(mark(), QString());
        QCoreApplication::processEvents();
        QCOMPARE(said.size(), 1);

        // Another threshold that leaves something of the first is told as what it is.
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        fixture.apply(core::ThresholdSegment{
            .segment = 2, .upper = -500.0, .mode = core::ThresholdSegment::Mode::Add});
        QTRY_COMPARE(said.size(), 2);
        QCOMPARE(said.back().front().toString(),
            QStringLiteral("'Bone' no longer follows its interval: the new one changed only a part "
                           "of it; Ctrl+Z takes it back"));
    }
};

BURIN_WINDOW_TEST(SegmentsPanelUiTest)

} // namespace segmentsPanelUiTest

#include "SegmentsPanelUiTest.moc"
