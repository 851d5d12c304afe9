// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/SegmentMenus.h"

#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/metrics/SegmentGap.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/cases/BoxedMasks.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/panels/lists/SegmentsPanel.h"
#include "ui/workspace/SegmentActions.h"

#include <QApplication>
#include <QListView>
#include <QMenu>
#include <QSignalSpy>
#include <QTimer>
#include <QToolButton>
#include <QtTest>

#include <algorithm>

namespace segmentMenusUiTest {

namespace {

/// Brain has grown, bone has a dab, skin & hair nothing.
struct Fixture : test::WindowFixture {
    Fixture()
        : WindowFixture(test::smallStudy())
    {
        window.addPanel(new ui::SegmentsPanel(workspace));
        window.showPanels(true);
        list = window.findChild<QListView*>(QStringLiteral("segmentList"));
        for (const core::Edit& edit : std::vector<core::Edit>{test::addSegment("Brain"),
                 test::addSegment("Bone"), test::addSegment("Skin & hair"), test::seedInBrain(1),
                 test::growBrain(), test::paintAt(2, test::pointsInBone(), 1.5)})
            apply(edit);
        workspace.setActiveSegment(1);
    }
    [[nodiscard]] std::int64_t voxels(int label)
    {
        return session().document().segment(label)->voxels;
    }
    /// A part of the menu Segments, as it is once that has opened.
    [[nodiscard]] QMenu& ofBar(const char* name)
    {
        QMenu& segments = window.segmentsMenu();
        segments.popup(window.mapToGlobal(QPoint(40, 40)));
        segments.close();
        return *segments.findChild<QMenu*>(QLatin1String(name));
    }

    QListView* list = nullptr;
};

QStringList textsOf(const QMenu& menu)
{
    QStringList texts;
    for (const QAction* each : menu.actions())
        texts += each->text();
    return texts;
}

QString spaced(std::int64_t count)
{
    QString digits = QString::number(count);
    for (qsizetype place = digits.size() - 3; place > 0; place -= 3)
        digits.insert(place, QLatin1Char(' '));
    return digits;
}

} // namespace

class SegmentMenusUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Its entries are about the segments of the study in which it was opened.
    void theMenuClosesWithItsStudy()
    {
        Fixture fixture;
        QMenu& segments = fixture.window.segmentsMenu();
        segments.popup(fixture.window.mapToGlobal(QPoint(40, 40)));
        QVERIFY(segments.isVisible());
        fixture.workspace.setSession(nullptr);
        const bool isOpen = segments.isVisible();
        segments.close();
        QVERIFY(!isOpen);
    }

    /// From the menu bar, about the active segment, whose name it says.
    void theBarMergesTheActiveSegment()
    {
        Fixture fixture;
        const std::int64_t brain = fixture.voxels(1);
        const std::int64_t bone = fixture.voxels(2);
        QVERIFY(brain > 1000 && bone > 0);
        QMenu& merge = fixture.ofBar("mergeSegments");
        QCOMPARE(merge.title(), QStringLiteral("Merge 'Brain' into"));
        QCOMPARE(
            textsOf(merge), (QStringList{QStringLiteral("Bone"), QStringLiteral("Skin && hair")}));
        QVERIFY(merge.menuAction()->isEnabled());
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const std::size_t rows = fixture.session().history().rows().size();
        merge.actions().front()->trigger();
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 1);
        QCOMPARE(said.front().front().toString(),
            QStringLiteral("Merge segment 'Brain' into 'Bone', +%1 voxels; Ctrl+Z takes it back")
                .arg(spaced(brain)));
        QCOMPARE(fixture.session().history().rows().size(), rows + 1);
        QCOMPARE(fixture.voxels(1), std::int64_t(0));
        QCOMPARE(fixture.voxels(2), brain + bone);
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QCOMPARE(fixture.voxels(1), brain);
        QCOMPARE(fixture.voxels(2), bone);

        // Another one is active: the menu is about that one.
        fixture.workspace.setActiveSegment(3);
        QCOMPARE(fixture.ofBar("swapSegments").title(), QStringLiteral("Swap 'Skin && hair' with"));
        QCOMPARE(textsOf(fixture.ofBar("swapSegments")),
            (QStringList{QStringLiteral("Brain"), QStringLiteral("Bone")}));
    }

    /// Elsewhere, too, an ampersand in a name is shown and marks no letter.
    void namesAreShownAsTheyAre()
    {
        Fixture fixture;
        fixture.workspace.setActiveSegment(3);
        fixture.window.actionTable().refresh();
        int named = 0;
        for (const QAction* each : fixture.window.segmentsMenu().actions()) {
            if (each->text().contains(QLatin1String("Skin")))
                named += each->text().contains(QLatin1String("'Skin && hair'")) ? 1 : -100;
        }
        QVERIFY2(named >= 5, qPrintable(QString::number(named)));
        QVERIFY(fixture.session().apply(test::addSegment("Gut & gall")));
        QVERIFY(fixture.session().settle());
        const QAction& undo = fixture.window.actionTable()[QStringLiteral("edit.undo")];
        QTRY_COMPARE(undo.text(), QStringLiteral("Undo: Add segment 'Gut && gall'"));
        const QString shown = QStringLiteral("Undo: Add segment 'Gut & gall'");
        const auto buttons = fixture.window.findChildren<QToolButton*>();
        QTRY_VERIFY(std::any_of(buttons.begin(), buttons.end(),
            [&](const QToolButton* each) { return each->toolTip().startsWith(shown); }));
    }

    /// Where there is nothing to be merged, that is told, and no step is made.
    void anEmptyOneHasNothingToGive()
    {
        Fixture fixture;
        fixture.workspace.setActiveSegment(3);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const std::size_t rows = fixture.session().history().rows().size();
        fixture.ofBar("mergeSegments").actions().front()->trigger();
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 1);
        QCOMPARE(said.front().front().toString(), QStringLiteral("'Skin & hair' has no voxels"));
        QCOMPARE(fixture.session().history().rows().size(), rows);
    }

    /// From the menu of a row, about the segment of that row.
    void aRowSwaps()
    {
        Fixture fixture;
        const std::int64_t brain = fixture.voxels(1);
        const std::int64_t bone = fixture.voxels(2);
        const QPoint at = fixture.list->visualRect(fixture.list->model()->index(1, 0)).center();
        QString title;
        QStringList others;
        int height = 0;
        QTimer::singleShot(0, &fixture.window, [&] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu);
            height = menu->sizeHint().height();
            auto* swap = menu->findChild<QMenu*>(QStringLiteral("swapSegments"));
            if (swap && !swap->isEmpty()) {
                title = swap->title();
                others = textsOf(*swap);
                swap->actions().front()->trigger();
            }
            menu->close();
        });
        Q_EMIT fixture.list->customContextMenuRequested(at);
        QVERIFY2(height > 0 && height <= 720, qPrintable(QString::number(height)));
        QCOMPARE(title, QStringLiteral("Swap with"));
        QCOMPARE(others, (QStringList{QStringLiteral("Brain"), QStringLiteral("Skin && hair")}));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.voxels(1), bone);
        QCOMPARE(fixture.voxels(2), brain);
        QCOMPARE(fixture.session().history().rows().back().name,
            QStringLiteral("Swap segments 'Bone' and 'Brain', +%1 −%2 voxels")
                .arg(spaced(brain), spaced(bone)));
    }

    /// Above what changes segments stands which voxels may change, while that is limited.
    void theEditableRangeIsSaid()
    {
        Fixture fixture;
        const auto noteIn = [](const QMenu& menu) {
            const auto* note = menu.findChild<QAction*>(
                QStringLiteral("editableNote"), Qt::FindDirectChildrenOnly);
            return note && note->isVisible() && !note->isEnabled() ? note->text() : QString();
        };
        QMenu& bar = fixture.window.segmentsMenu();
        static_cast<void>(fixture.ofBar("mergeSegments"));
        QCOMPARE(noteIn(bar), QString());
        fixture.workspace.setEditableSettings(
            {.on = true, .where = ui::EditableSettings::Where::Inside, .segment = 3});
        static_cast<void>(fixture.ofBar("mergeSegments"));
        QCOMPARE(noteIn(bar), QStringLiteral("editable: inside Skin && hair"));
        QString ofRow;
        int height = 0;
        QTimer::singleShot(0, &fixture.window, [&] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu);
            height = menu->sizeHint().height();
            ofRow = noteIn(*menu);
            menu->close();
        });
        const QPoint at = fixture.list->visualRect(fixture.list->model()->index(1, 0)).center();
        Q_EMIT fixture.list->customContextMenuRequested(at);
        QCOMPARE(ofRow, QStringLiteral("editable: inside Skin && hair"));
        QVERIFY2(height > 0 && height <= 720, qPrintable(QString::number(height)));
    }

    /// Segments that overlap can be added, subtracted and intersected; the menus are there for
    /// them.
    void whatOverlapsIsSubtracted()
    {
        Fixture fixture;
        for (const char* name : {"uniteSegments", "subtractSegment", "intersectSegments"})
            QVERIFY(!fixture.ofBar(name).menuAction()->isVisible());
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        const glm::ivec3 middle = geometry.size / 2;
        core::ImportMask mask = test::importOfBoxes({{middle - 2, middle + 2}}, geometry.size);
        mask.planes = std::vector<int>{1};
        mask.overwriteUnlocked = false;
        fixture.apply(test::eraseAt(1, {geometry.toWorld(glm::dvec3(middle))}, 6.0));
        fixture.apply(mask);
        const std::int64_t box = fixture.voxels(4);
        QVERIFY(box > 0);
        fixture.apply(test::paintAt(1, {geometry.toWorld(glm::dvec3(middle))}, 6.0));
        const std::int64_t brain = fixture.voxels(1);
        QMenu& subtract = fixture.ofBar("subtractSegment");
        QVERIFY(subtract.menuAction()->isVisible() && subtract.menuAction()->isEnabled());
        QCOMPARE(subtract.title(), QStringLiteral("Subtract from 'Brain'"));
        QCOMPARE(subtract.actions().size(), 3);
        QVERIFY(!subtract.actions().at(0)->isEnabled());
        QVERIFY(subtract.actions().at(0)->toolTip().contains(QStringLiteral("same label plane")));
        subtract.actions().at(2)->trigger();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.voxels(1), brain - box);
        QCOMPARE(fixture.voxels(4), box);
        QCOMPARE(fixture.session().history().rows().back().name,
            QStringLiteral("Subtract 'S1' from 'Brain', −%1 voxels").arg(spaced(box)));
        fixture.ofBar("uniteSegments").actions().at(2)->trigger();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.voxels(1), brain);
        fixture.ofBar("intersectSegments").actions().at(2)->trigger();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.voxels(1), box);
    }

    /// The copy lies where its voxels are free, also that of a locked segment; the message and the
    /// row of the history name both.
    void aSegmentIsDuplicated()
    {
        Fixture fixture;
        fixture.apply(test::lockSegment(1));
        const std::int64_t brain = fixture.voxels(1);
        QAction& duplicate = fixture.window.actionTable()[QStringLiteral("segments.duplicate")];
        fixture.window.actionTable().refresh();
        QCOMPARE(duplicate.text(), QStringLiteral("Duplicate segment 'Brain'"));
        QVERIFY(duplicate.isEnabled()); // it is only read
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const std::size_t rows = fixture.session().history().rows().size();
        duplicate.trigger();
        QTRY_VERIFY((fixture.session().poll(), said.size() == 1));
        QCOMPARE(said.front().front().toString(),
            QStringLiteral("Copy segment 'Brain' as 'Brain copy', +%1 voxels; Ctrl+Z takes it back")
                .arg(spaced(brain)));
        QCOMPARE(fixture.session().history().rows().size(), rows + 1);
        const core::Segment copy = *fixture.session().document().segment(4);
        QCOMPARE(copy.voxels, brain);
        QCOMPARE(int(copy.plane), 1);
        QVERIFY(!copy.locked);
        for (const core::Segment& other : fixture.session().document().segments)
            QVERIFY(other.label == copy.label || other.rgb != copy.rgb);
        QCOMPARE(fixture.workspace.activeSegment(), 1);

        // From the row's menu; the second copy has another name.
        const QPoint at = fixture.list->visualRect(fixture.list->model()->index(0, 0)).center();
        QTimer::singleShot(0, &fixture.window, [&] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu);
            for (QAction* each : menu->actions()) {
                if (each->text() == QLatin1String("Duplicate segment") && each->isEnabled())
                    each->trigger();
            }
            menu->close();
        });
        Q_EMIT fixture.list->customContextMenuRequested(at);
        QTRY_VERIFY((fixture.session().poll(), said.size() == 2));
        QCOMPARE(fixture.session().document().segments.back().name, QStringLiteral("Brain copy 2"));
        QCOMPARE(int(fixture.session().document().segments.back().plane), 2);

        // Until nothing is left: what is told names the limit.
        duplicate.trigger();
        QTRY_VERIFY((fixture.session().poll(), said.size() == 3));
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        duplicate.trigger();
        QTRY_VERIFY((fixture.session().poll(), failed.size() == 1));
        const auto why = failed.front().front().value<core::Error>();
        QVERIFY2(why.arguments.join(u' ').contains(QStringLiteral("at most 4 label planes")),
            qPrintable(why.arguments.join(u' ')));
        QCOMPARE(fixture.session().document().segments.size(), std::size_t(6));
        QCoreApplication::processEvents();
        QCOMPARE(said.size(), 3); // not that there was nothing to copy
    }

    void anEmptyOneIsNotDuplicated()
    {
        Fixture fixture;
        fixture.workspace.setActiveSegment(3);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.window.actionTable()[QStringLiteral("segments.duplicate")].trigger();
        QTRY_VERIFY((fixture.session().poll(), said.size() == 1));
        QCOMPARE(said.front().front().toString(), QStringLiteral("'Skin & hair' has no voxels"));
        QCOMPARE(fixture.session().document().segments.size(), std::size_t(3));
    }

    /// A segment of another plane is painted over others, which keep what they have.
    void aSegmentIsAddedThatMayOverlap()
    {
        Fixture fixture;
        QMenu& add = fixture.ofBar("overlappingSegment");
        QCOMPARE(add.title(), QStringLiteral("Add segment that may overlap"));
        QCOMPARE(textsOf(add), QStringList{QStringLiteral("All others")});
        add.actions().front()->trigger();
        QVERIFY(fixture.session().settle());
        const core::Segment& made = fixture.session().document().segments.back();
        QCOMPARE(int(made.label), 4);
        QCOMPARE(int(made.plane), 1);
        QCOMPARE(fixture.workspace.activeSegment(), 4);
        const std::int64_t brain = fixture.voxels(1);
        fixture.apply(test::paintAt(4, test::pointsInBrain(), 3.0));
        QVERIFY(fixture.voxels(4) > 0);
        QCOMPARE(fixture.voxels(1), brain);

        // Now there is something beside which one can lie.
        QCOMPARE(textsOf(fixture.ofBar("overlappingSegment")),
            (QStringList{QStringLiteral("All others"),
                QStringLiteral("All but 'Brain', 'Bone', 'Skin && hair'"),
                QStringLiteral("All but 'Segment 4'")}));
        add.actions().at(2)->trigger();
        QVERIFY(fixture.session().settle());
        QCOMPARE(int(fixture.session().document().segment(5)->plane), 1);
        for (const int plane : {2, 3}) {
            fixture.ofBar("overlappingSegment").actions().front()->trigger();
            QVERIFY(fixture.session().settle());
            QCOMPARE(int(fixture.session().document().segments.back().plane), plane);
        }
        QAction* all = fixture.ofBar("overlappingSegment").actions().front();
        QVERIFY(!all->isEnabled());
        QCOMPARE(all->toolTip(), QStringLiteral("segments lie in each of the 4 label planes"));
        QCOMPARE(add.actions().size(), 5);
    }

    /// The distance to another one, locked or not, becomes a measurement between both surfaces.
    void theDistanceOfTwo()
    {
        Fixture fixture;
        fixture.apply(test::paintAt(3, {glm::dvec3(-18.0, -16.0, 106.0)}, 1.2));
        fixture.apply(test::lockSegment(3));
        QMenu& distance = fixture.ofBar("distanceOfSegments");
        QCOMPARE(distance.title(), QStringLiteral("Measure distance from 'Brain' to"));
        QVERIFY(distance.menuAction()->isEnabled() && distance.actions().at(1)->isEnabled());
        const std::size_t rows = fixture.session().history().rows().size();
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        distance.actions().at(1)->trigger();
        QTRY_VERIFY((fixture.session().poll(), said.size() == 2)); // answers come when asked for
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().rows().size(), rows + 1);
        const auto labels = fixture.session().questions().labels(0);
        QVERIFY(labels);
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        const auto gap = core::segmentGap(*labels, 1, *labels, 3, geometry, core::Progress());
        QVERIFY(gap && *gap);
        const auto& kept = fixture.session().document().measurements;
        QCOMPARE(kept.size(), std::size_t(1));
        QVERIFY(glm::length(kept.front().pointsLps.front() - (*gap)->fromLps) < 0.01);
        QVERIFY(glm::length(kept.front().pointsLps.back() - (*gap)->toLps) < 0.01);
        QVERIFY2(said.back().front().toString().startsWith(
                     QStringLiteral("'Brain' and 'Skin & hair' are ")),
            qPrintable(said.back().front().toString()));
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QVERIFY(fixture.session().document().measurements.empty());
    }

    /// A segment that is added while a copy is still looking for its label plane is not that copy.
    void whoComesNextIsNotTheCopy()
    {
        Fixture fixture;
        QVERIFY(ui::addSegment(fixture.workspace, 1)); // so that planes must be looked at
        QVERIFY(fixture.session().settle());
        fixture.workspace.setActiveSegment(1);
        fixture.window.actionTable().refresh();
        fixture.window.actionTable()[QStringLiteral("segments.duplicate")].trigger();
        const core::Result<int> added = ui::addSegment(fixture.workspace);
        QVERIFY(added);
        QVERIFY(fixture.session().settle());
        const core::Document& document = fixture.session().document();
        QCOMPARE(document.segments.size(), std::size_t(6));
        QCOMPARE(fixture.workspace.activeSegment(), *added);
        QCOMPARE(document.segment(*added)->voxels, std::int64_t(0));
        QCOMPARE(document.segments[4].name, QStringLiteral("Brain copy"));
        QCOMPARE(int(document.segments[5].label), *added);
    }

    /// What cannot be chosen says why.
    void whatCannotBeSaysWhy()
    {
        Fixture fixture;
        fixture.apply(test::lockSegment(2));
        for (const char* name : {"mergeSegments", "swapSegments"}) {
            QMenu& menu = fixture.ofBar(name);
            QVERIFY(menu.toolTipsVisible() && menu.menuAction()->isEnabled());
            QVERIFY(!menu.actions().at(0)->isEnabled());
            QCOMPARE(menu.actions().at(0)->toolTip(), QStringLiteral("'Bone' is locked"));
            QVERIFY(menu.actions().at(1)->isEnabled());
        }
        fixture.apply(test::lockSegment(3));
        QMenu& merge = fixture.ofBar("mergeSegments");
        QCOMPARE(merge.actions().size(), 2);
        QCOMPARE(merge.menuAction()->toolTip(), QStringLiteral("every other segment is locked"));
        fixture.apply(test::lockSegment(1));
        QVERIFY(!fixture.ofBar("mergeSegments").menuAction()->isEnabled());
        QCOMPARE(merge.menuAction()->toolTip(), QStringLiteral("'Brain' is locked"));
        QVERIFY(fixture.window.segmentsMenu().toolTipsVisible());
        for (const int label : {1, 2, 3})
            fixture.apply(test::lockSegment(label, false));
        for (const int label : {2, 3})
            fixture.apply(core::RemoveSegment{.segment = label});
        QVERIFY(!fixture.ofBar("mergeSegments").menuAction()->isEnabled());
        QCOMPARE(merge.menuAction()->toolTip(), QStringLiteral("there is no other segment"));
        fixture.apply(core::RemoveSegment{.segment = 1});
        QVERIFY(!fixture.ofBar("mergeSegments").menuAction()->isEnabled());
        QCOMPARE(merge.title(), QStringLiteral("Merge into"));
        QCOMPARE(merge.menuAction()->toolTip(), QStringLiteral("there is no segment"));
    }
};

BURIN_WINDOW_TEST(SegmentMenusUiTest)

} // namespace segmentMenusUiTest

#include "SegmentMenusUiTest.moc"
