// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/SegmentMenus.h"

#include "core/session/EditSession.h"
#include "ui/base/MenuText.h"
#include "ui/measure/DistanceOfSegments.h"
#include "ui/menus/SegmentEntries.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QMenu>

namespace ui {

namespace {

/// One of the three, as it is when the menu opens.
struct Combination {
    QMenu* menu = nullptr;
    QString text;
    QString named; ///< with the segment's name
    void (*run)(Workspace& workspace, int label, int other) = nullptr;
    bool changes = true; ///< locked segments cannot be chosen

    void list(Workspace& workspace, int label, bool isNamed) const
    {
        const core::EditSession* session = workspace.session();
        const core::Segment* segment = session ? session->document().segment(label) : nullptr;
        menu->clear();
        menu->setTitle(isNamed && segment ? named.arg(menuText(segment->name)) : text);
        QString why = changes || !segment ? whyUnchangeable(segment) : QString();
        if (why.isEmpty())
            why = listOtherSegments(
                *menu, session->document(), label,
                [&workspace, session, label, combine = run](int other) {
                    if (workspace.session() == session)
                        combine(workspace, label, other);
                },
                changes);
        // Where one is locked, the list shows which.
        menu->menuAction()->setEnabled(!menu->isEmpty());
        menu->menuAction()->setToolTip(why);
    }
};

} // namespace

QString whyUnchangeable(const core::Segment* segment)
{
    if (!segment)
        return QObject::tr("there is no segment");
    return segment->locked ? QObject::tr("'%1' is locked").arg(segment->name) : QString();
}

QString listOtherSegments(QMenu& menu, const core::Document& document, int but,
    const std::function<void(int)>& choose, bool changes)
{
    menu.setToolTipsVisible(true);
    QString why = QObject::tr("there is no other segment");
    const core::Segment* own = document.segment(but);
    bool possible = false;
    bool apart = false;
    for (const core::Segment& each : document.segments) {
        if (each.label == but)
            continue;
        QAction* entry = menu.addAction(menuText(each.name));
        QObject::connect(entry, &QAction::triggered, &menu,
            [choose, label = int(each.label)] { choose(label); });
        QString whyNot = changes ? whyUnchangeable(&each) : QString();
        if (changes && own && each.plane != own->plane) {
            whyNot = QObject::tr("'%1' lies on another label plane").arg(each.name);
            apart = true;
        }
        entry->setEnabled(whyNot.isEmpty());
        entry->setToolTip(whyNot);
        possible = possible || whyNot.isEmpty();
        why = apart ? QObject::tr("every other segment is locked or lies on another label plane")
                    : QObject::tr("every other segment is locked");
    }
    return possible ? QString() : why;
}

QMenu& menuOf(QMenu& menu, const SegmentAction& action)
{
    if (action.submenu.isEmpty())
        return menu;
    for (const QAction* each : menu.actions()) {
        if (each->menu() && each->menu()->title() == action.submenu)
            return *each->menu();
    }
    return *menu.addMenu(action.submenu);
}

void addCombinations(QMenu& menu, QAction* before, Workspace& workspace,
    const std::function<int()>& label, bool named)
{
    menu.setToolTipsVisible(true);
    const auto add = [&](const char* name) {
        auto* sub = new QMenu(&menu);
        sub->setObjectName(QLatin1String(name));
        menu.insertMenu(before, sub);
        return sub;
    };
    const Combination merge{add("mergeSegments"), QObject::tr("Merge into"),
        QObject::tr("Merge '%1' into"), &mergeSegments};
    const Combination swap{add("swapSegments"), QObject::tr("Swap with"),
        QObject::tr("Swap '%1' with"), &swapSegments};
    const Combination distance{add("distanceOfSegments"), QObject::tr("Measure distance to"),
        QObject::tr("Measure distance from '%1' to"), &measureDistance, false};
    const auto list = [&workspace, merge, swap, distance, label, named] {
        merge.list(workspace, label(), named);
        swap.list(workspace, label(), named);
        distance.list(workspace, label(), named);
    };
    QObject::connect(&menu, &QMenu::aboutToShow, merge.menu, list);
    list();
}

} // namespace ui
