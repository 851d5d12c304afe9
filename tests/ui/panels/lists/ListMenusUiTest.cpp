// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/layers/RemoveLayer.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/frame/PanelSection.h"
#include "ui/panels/lists/LayersPanel.h"
#include "ui/panels/lists/SegmentsPanel.h"

#include <QAction>
#include <QApplication>
#include <QListView>
#include <QMenu>
#include <QSignalSpy>
#include <QTimer>
#include <QtTest>

namespace listMenusUiTest {

namespace {

/// A window with one panel, which has a list.
template <class Panel> struct ListWindow : test::WindowFixture {
    ListWindow()
        : WindowFixture(test::smallStudy())
    {
        auto* panel = new Panel(workspace);
        window.addPanel(panel);
        window.showPanels(true);
        for (auto* section : window.findChildren<ui::PanelSection*>())
            section->setFolded(false);
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        list = panel->template findChild<QListView*>();
    }
    [[nodiscard]] QStringList listed() const
    {
        QStringList names;
        for (int row = 0; row < list->model()->rowCount(); ++row)
            names += list->model()->index(row, 0).data().toString();
        return names;
    }
    /// Opens the menu of a row, has the last step undone, and only then chooses an entry.
    void chooseAfterUndo(int row, const QString& text)
    {
        bool isChosen = false;
        QTimer::singleShot(0, &window, [&] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu);
            QVERIFY(session().undo());
            QVERIFY(session().settle());
            for (QAction* each : menu->actions()) {
                if (each->text() != text)
                    continue;
                isChosen = true;
                each->trigger();
            }
            menu->close();
        });
        const QModelIndex index = list->model()->index(row, 0);
        list->scrollTo(index);
        Q_EMIT list->customContextMenuRequested(list->visualRect(index).center());
        QVERIFY(isChosen);
        QVERIFY(session().settle());
    }

    QListView* list = nullptr;
};

} // namespace

/// What was asked of the session may change a list while the menu of one of its rows is open.
class ListMenusUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void theSegmentIsTheOneThatWasClicked()
    {
        ListWindow<ui::SegmentsPanel> fixture;
        for (const char* name : {"Brain", "Bone", "Skin"})
            fixture.apply(test::addSegment(name));
        fixture.apply(core::RemoveSegment{.segment = 1});
        QCOMPARE(fixture.listed(), (QStringList{QStringLiteral("Bone"), QStringLiteral("Skin")}));
        fixture.chooseAfterUndo(0, QStringLiteral("Lock")); // of the bone
        QCOMPARE(fixture.listed(),
            (QStringList{QStringLiteral("Brain"), QStringLiteral("Bone"), QStringLiteral("Skin")}));
        const core::Document& document = fixture.session().document();
        QVERIFY(!document.segment(1)->locked);
        QVERIFY(document.segment(2)->locked);
    }

    void theLayerIsTheOneThatWasClicked()
    {
        ListWindow<ui::LayersPanel> fixture;
        for (const char* name : {"Approach", "Orbit"})
            fixture.apply(core::AddLayer{.name = QLatin1String(name)});
        fixture.apply(core::RemoveLayer{.layer = 2});
        QCOMPARE(
            fixture.listed(), (QStringList{QStringLiteral("Sculpt 1"), QStringLiteral("Orbit")}));
        fixture.chooseAfterUndo(1, QStringLiteral("Delete layer")); // the orbit
        QCOMPARE(fixture.listed(),
            (QStringList{QStringLiteral("Sculpt 1"), QStringLiteral("Approach")}));
    }

    /// Undo takes the layer away in whose menu it is chosen to be deleted.
    void aLayerThatIsGoneIsNotDeleted()
    {
        ListWindow<ui::LayersPanel> fixture;
        for (const char* name : {"Approach", "Orbit"})
            fixture.apply(core::AddLayer{.name = QLatin1String(name)});
        const QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        fixture.chooseAfterUndo(2, QStringLiteral("Delete layer"));
        QCOMPARE(fixture.listed(),
            (QStringList{QStringLiteral("Sculpt 1"), QStringLiteral("Approach")}));
        QCOMPARE(failed.size(), 1);
    }
};

BURIN_WINDOW_TEST(ListMenusUiTest)

} // namespace listMenusUiTest

#include "ListMenusUiTest.moc"
